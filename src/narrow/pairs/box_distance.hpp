// Box against box: the signed distance where one of the fifteen axes tells it.
//
// Guarantee: what is returned is the distance up to rounding, whether the boxes overlap or not: no axis parts them by
// more, and the two points, which lie on the boxes, are no further apart. Nothing where corners and edges are nearest
// that no axis belongs to, or where features are parallel and the deepest points are not single.
#pragma once

#include <optional>

#include "narrow/pairs/box_box.hpp"

namespace graze {

namespace detail {

/// The corner of a box that lies furthest along a direction given in its frame.
inline Vec3d corner_along(const Vec3d& half, const Vec3d& direction) {
  return {direction.x < 0 ? -half.x : half.x, direction.y < 0 ? -half.y : half.y, direction.z < 0 ? -half.z : half.z};
}

inline bool inside_box(const Vec3d& half, const Vec3d& p, double slack) {
  return std::abs(p.x) <= half.x + slack && std::abs(p.y) <= half.y + slack && std::abs(p.z) <= half.z + slack;
}

/// B's corner over A's face, and the reverse.
inline CoreDistance<double> over_face_of_a(const BoxPair<double>& p, const BoxAxis<double>& axis) {
  const Vec3d& n = axis.normal;
  const Vec3d b = p.rotation * corner_along(p.half_b, -transposed_times(p.rotation, n)) + p.translation;
  return {axis.separation, n, b - n * axis.separation, b};
}
inline CoreDistance<double> over_face_of_b(const BoxPair<double>& p, const BoxAxis<double>& axis) {
  const Vec3d a = corner_along(p.half_a, axis.normal);
  return {axis.separation, axis.normal, a, a + axis.normal * axis.separation};
}

/// The nearest points of the lines of two edges that are not parallel.
inline CoreDistance<double> between_edges(const BoxPair<double>& p, const BoxAxis<double>& axis) {
  const auto number = static_cast<std::size_t>(axis.number) - 6;
  const std::size_t i = number / 3, j = number % 3;
  const Vec3d& n = axis.normal;
  Vec3d on_a = corner_along(p.half_a, n), on_b = corner_along(p.half_b, -transposed_times(p.rotation, n));
  on_a[i] = 0;
  on_b[j] = 0;
  on_b = p.rotation * on_b + p.translation;
  const Vec3d e = unit_axis<double>(i), f = p.rotation.column(j), between = on_b - on_a;
  const double cosine = f[i], squared_sine = 1 - cosine * cosine, along_e = between[i], along_f = dot(between, f);
  const double s = (along_e - cosine * along_f) / squared_sine, t = (cosine * along_e - along_f) / squared_sine;
  return {axis.separation, n, on_a + e * s, on_b + f * t};
}

}  // namespace detail

/// Roundings of a coordinate by which a point may miss the box that it lies on: less than what `laid_slack` allows.
inline constexpr double witness_slack = 16;

/// Whether the two points prove the distance: each lies on its box, and they are apart along the normal by that.
inline bool proven(const BoxPair<double>& p, const CoreDistance<double>& d, double noise) {
  const double slack = witness_slack * noise;
  return length(d.b - d.a - d.normal * d.distance) <= slack && detail::inside_box(p.half_a, d.a, slack) &&
         detail::inside_box(p.half_b, transposed_times(p.rotation, d.b - p.translation), slack);
}

/// The best of all: a face's before an edge's that is better by no more than `noise`.
inline const BoxAxis<double>& best_of(const BoxAxes<double>& axes, double noise) {
  const BoxAxis<double>& face = axes.face_b.separation > axes.face_a.separation ? axes.face_b : axes.face_a;
  return axes.edge.separation > face.separation + noise ? axes.edge : face;
}

/// By the best of all fifteen axes. `noise`: what rounding may do to the distance.
inline std::optional<CoreDistance<double>> box_distance(const BoxPair<double>& p, const BoxAxis<double>& best,
                                                        double noise) {
  const CoreDistance<double> d = best.number >= 6   ? detail::between_edges(p, best)
                                 : best.number >= 3 ? detail::over_face_of_b(p, best)
                                                    : detail::over_face_of_a(p, best);
  return proven(p, d, noise) ? std::optional(d) : std::nullopt;
}

}  // namespace graze
