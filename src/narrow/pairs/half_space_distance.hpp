// Half-space against any shape: one support point along its normal, or its support face.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core/core.hpp"

namespace graze {

/// The height of a box's lowest corner above y = 0, by all eight corners.
template <class S>
S lowest_corner(const Vec3<S>& half, const Pose<S>& pose) {
  S lowest(std::numeric_limits<float>::infinity());
  for (const Vec3<S>& corner : vertices_of(OrientedBox<S>{pose, half})) lowest = least(lowest, corner.y);
  return lowest;
}

/// The height of a box's lowest corner, by its projected radius along the normal: sum of half_i |n . axis_i|.
template <class S>
S lowest_by_radius(const Vec3<S>& half, const Pose<S>& pose) {
  const Mat3<S> m = rotation_matrix(pose.rotation);
  return pose.translation.y - dot(abs(m.row[1]), half);
}

// The point of a core that lies furthest along a direction, as the shape's `core_support` gives it.
template <class C, class S>
Vec3<S> furthest_along(const C& concrete, const Vec3<S>& direction) {
  return concrete.core_support(direction);
}
template <class S>
Vec3<S> furthest_along(const PointCore<S>& core, const Vec3<S>&) {
  return core.point;
}
template <class S>
Vec3<S> furthest_along(const AxisCore<S>& core, const Vec3<S>& direction) {
  return {S(0), select(direction.y < S(0), -core.half_height, core.half_height), S(0)};
}
template <class S>
Vec3<S> furthest_along(const BoxCore<S>& core, const Vec3<S>& direction) {
  const auto side = [](const S& half, const S& along) { return select(along < S(0), -half, half); };
  return {side(core.half.x, direction.x), side(core.half.y, direction.y), side(core.half.z, direction.z)};
}
template <class S>
Vec3<S> furthest_along(const TriangleCore<S>& core, const Vec3<S>& direction) {
  Vec3<S> best = core.point[0];
  S most = dot(best, direction);
  for (std::size_t i = 1; i < 3; ++i) {
    const S along = dot(core.point[i], direction);
    const auto further = along > most;
    best = select(further, core.point[i], best);
    most = select(further, along, most);
  }
  return best;
}

/// The signed distance of a core B from the half-space y <= 0, which is A; for cores also across lanes.
template <class C, class S>
CoreDistance<S> half_space_distance(const C& b, const Pose<S>& b_in_a) {
  const Vec3<S> up{S(0), S(1), S(0)};
  const Vec3<S> down_in_b = rotate(conjugate(b_in_a.rotation), -up);
  const Vec3<S> lowest = transform(b_in_a, furthest_along(b, down_in_b));
  return {lowest.y, up, {lowest.x, S(0), lowest.z}, lowest};
}

/// Whether a half-space with the surface normal `n` faces the half-space y <= 0, up to the rounding of their poses.
template <class T>
bool opposite(const Vec3<T>& n) {
  const T slack = T(16) * std::numeric_limits<T>::epsilon();
  return n.y < T(0) && n.x * n.x + n.z * n.z <= slack * slack;
}

}  // namespace graze
