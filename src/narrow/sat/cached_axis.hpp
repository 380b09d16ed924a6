// Temporal coherence: whether two shapes are still apart along a direction that separated them before.
//
// Guarantee: true only where `contacts` within the same margin finds nothing; so it saves work and never changes an
// answer. Two support queries.
#pragma once

#include "narrow/general.hpp"

namespace graze {

/// `axis` is a unit vector from A to B in the frame of A. Half-spaces have no support function and are never found
/// apart.
template <class T>
bool still_apart(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                 const Vec3<T>& axis, T margin) {
  const Posed b_in_a = relative_in_double(pose_a, pose_b);
  const Vec3d n = converted<double>(axis);
  double radii = 0, size = 0;
  bool bounded = true;
  /// The extent of a core along a direction; adds up rounding radii.
  const auto reach = [&](const Shape<T>& shape, const Vec3d& direction) {
    return shape.visit([&](const auto& c) -> double {
      if constexpr (BoundedConvex<std::decay_t<decltype(c)>>) {
        const auto radius = static_cast<double>(rounding_radius(c, shape.rounding()));
        radii += radius;
        size = greatest(size, static_cast<double>(c.core_extent()) + radius);
        return dot(c.core_support(direction), direction);
      } else {
        bounded = false;
        return 0;
      }
    });
  };
  const double reach_a = reach(a, n), reach_b = reach(b, rotate(conjugate(b_in_a.rotation), -n));
  // Twice the tolerance of an answer, and the axis' own rounding in T.
  const double slack =
      (2 * static_cast<double>(tolerance<T>) + 4 * static_cast<double>(std::numeric_limits<T>::epsilon())) *
      (size + max_abs(b_in_a.translation) + static_cast<double>(margin));
  return bounded && dot(b_in_a.translation, n) - reach_a - reach_b - radii > static_cast<double>(margin) + slack;
}

}  // namespace graze
