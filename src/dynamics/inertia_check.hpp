// Moments of inertia that no body has.
//
// Guarantee: three that some body has are accepted, however they were rounded.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "graze/detail/validate.hpp"
#include "graze/vec3.hpp"

namespace graze {

/// The part by which a moment of inertia may exceed the sum of the two others, as rounding makes that of a flat plate.
template <class T>
constexpr T rounding_of_inertia = T(16) * std::numeric_limits<T>::epsilon();

/// Throws `InvalidValue` where one of three finite moments of inertia is larger than the sum of the others: the moments
/// are the sums, two by two, of the mass's second moments along the axes, which are not negative. `path` names the
/// three.
template <class T>
void check_triangle_inequality(const Vec3<T>& inertia, const std::string& path) {
  for (std::size_t i = 0; i < 3; ++i) {
    const T others = inertia[(i + 1) % 3] + inertia[(i + 2) % 3];
    if (std::isfinite(inertia[i]) && inertia[i] > others * (T(1) + rounding_of_inertia<T>))
      validate::fail(path + "[" + std::to_string(i) + "]", "at most the sum of the other two",
                     static_cast<double>(inertia[i]));
  }
}

}  // namespace graze
