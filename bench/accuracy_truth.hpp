// What is so, in extended precision, of the pairs that the libraries are asked about: by the reference of the tests,
// which shares no line with any of them.
#pragma once

#include <optional>

#include "../tests/reference/distance.hpp"
#include "pairs.hpp"

namespace graze::bench {

using Real = reference::Real;

/// A body for the reference.
reference::Placed referenced(const Body& body);

/// When something moving first meets, as the part of its motion; and how fast the gap closes there, per whole motion.
struct Meeting {
  Real t, closing;
};

/// When a ray enters a shape of that size, on its way from `from` to `from + way`.
std::optional<Meeting> ray_meeting(const reference::Placed& target, const reference::Vector& from,
                                   const reference::Vector& way, Real size);

/// When the ray of a pair of `make_rays` enters A.
std::optional<Meeting> ray_meeting(const Pair& ray);

/// When A, on its way, first touches B: a pair of `make_ways`.
std::optional<Meeting> cast_meeting(const Pair& way);

}  // namespace graze::bench
