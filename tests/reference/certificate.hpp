// Judges a claimed answer for a pair by what can be proven about it.
//
// A separated claim needs no second opinion: witnesses inside both shapes bound
// the distance from above, s(normal) bounds it from below. For an overlapping
// claim the same two show that the translation separates; that no shorter one
// does takes a search over all directions.
#pragma once

#include <optional>
#include <string>

#include "distance.hpp"

namespace graze::reference {

struct Answer {
  Real distance;
  Vector normal;  // unit, from A to B
  Vector a, b;    // witness points in world space, b - a = distance * normal
};

// How far |normal| may be from 1: some roundings of double precision.
inline constexpr Real unit_tolerance = 1e-12L;

// Nothing when the claims hold, else a sentence that names the first that does
// not, with its numbers. `tolerance` is a length. Without `search` an
// overlapping answer is only checked to separate the shapes, not to be minimal.
//  - |normal| = 1, and b - a = distance * normal
//  - a is in A and b is in B, and each is a support point of its shape along
//    the normal (which puts it on the boundary)
//  - s(normal) = distance, and no direction tried gives more
std::optional<std::string> disprove(const Placed& a, const Placed& b, const Answer& answer, Real tolerance,
                                    bool search = true);

// Distance from a world point to the shape; zero inside. Closed forms that
// share nothing with the search over directions.
Real outside_distance(const Placed& placed, const Vector& world_point);

}  // namespace graze::reference
