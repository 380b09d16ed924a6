// Half-space against everything: one support point along its normal, or a face of them.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core.hpp"

namespace graze {

/// Height of a box's lowest corner above y = 0, by all eight corners.
template <class S>
S lowest_corner(const Vec3<S>& half, const Pose<S>& pose) {
  S lowest(std::numeric_limits<float>::infinity());
  for (const Vec3<S>& corner : vertices_of(OrientedBox<S>{pose, half})) lowest = least(lowest, corner.y);
  return lowest;
}

/// The same by the box's projected radius along the normal: sum of half_i |n . axis_i|.
template <class S>
S lowest_by_radius(const Vec3<S>& half, const Pose<S>& pose) {
  const Mat3<S> m = rotation_matrix(pose.rotation);
  return pose.translation.y - dot(abs(m.row[1]), half);
}

/// The half-space y <= 0 is A; the other shape's core is seen from it.
template <class C, class T>
CoreDistance<T> half_space_distance(const C& b, const Pose<T>& b_in_a) {
  const Vec3<T> up{T(0), T(1), T(0)};
  const Vec3<T> down_in_b = rotate(conjugate(b_in_a.rotation), -up);
  const Vec3<T> lowest = transform(b_in_a, b.core_support(down_in_b));
  return {lowest.y, up, {lowest.x, T(0), lowest.z}, lowest};
}

/// The gap between the half-space y <= 0 and another that faces it, whose surface stands at height `offset` along its
/// own normal `n`; nothing when they do not face each other, up to the rounding of their poses.
template <class T>
bool opposite(const Vec3<T>& n) {
  const T slack = T(16) * std::numeric_limits<T>::epsilon();
  return n.y < T(0) && n.x * n.x + n.z * n.z <= slack * slack;
}

}  // namespace graze
