// Triangle against triangle by a form of its own.
//
// Guarantee: `distance`, `overlap` and `contacts` take their answer from here, so that they agree on what touches. An
// answer is given only with its proof, see `triangle_distance`; of slivers, and where rounding hides the proof, the
// general path answers.
#pragma once

#include <limits>
#include <optional>

#include "graze/query.hpp"
#include "narrow/closed_form.hpp"
#include "narrow/pairs/triangle_triangle_distance.hpp"

namespace graze {

template <class T>
PlacedTriangle<double> placed_triangle(const Triangle<T>& triangle, T margin, const Pose<T>& pose) {
  return {{{cast<double>(triangle.point(0)), cast<double>(triangle.point(1)), cast<double>(triangle.point(2))}},
          static_cast<double>(margin),
          cast<double>(pose)};
}

/// `triangle_distance` of one pair.
TriangleDistance<double> distance_of_triangles(const PlacedTriangle<double>& a, const PlacedTriangle<double>& b,
                                               double enough);

template <class T>
std::optional<Distance<T>> own_distance(const Triangle<T>& a, T margin_a, const Pose<T>& pose_a, const Triangle<T>& b,
                                        T margin_b, const Pose<T>& pose_b) {
  const auto found = distance_of_triangles(placed_triangle(a, margin_a, pose_a), placed_triangle(b, margin_b, pose_b),
                                           std::numeric_limits<double>::infinity());
  if (!found.proven) return std::nullopt;
  return rounded<T>(found.at);
}

}  // namespace graze
