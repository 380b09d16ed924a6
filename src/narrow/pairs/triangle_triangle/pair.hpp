// Triangle against triangle by a form of its own.
//
// Guarantee: `distance`, `overlap` and `contacts` take their answer from here, so that they agree on what touches. An
// answer is given only with its proof, see `triangle_distance`; of slivers, and where rounding hides the proof, the
// general path answers.
#pragma once

#include <limits>
#include <optional>

#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/batch/pair_kernels.hpp"
#include "narrow/pairs/closed_form.hpp"
#include "narrow/pairs/triangle_triangle/distance.hpp"

namespace graze {

template <class T>
PlacedTriangle<double> placed_triangle(const Triangle<T>& triangle, T margin, const Pose<T>& pose) {
  return {{{converted<double>(triangle.point(0)), converted<double>(triangle.point(1)),
            converted<double>(triangle.point(2))}},
          static_cast<double>(margin),
          converted<double>(pose)};
}

/// See `triangle_distance`.
template <class T>
TriangleDistance<double> distance_of_triangles(const Triangle<T>& a, T margin_a, const Pose<T>& pose_a,
                                               const Triangle<T>& b, T margin_b, const Pose<T>& pose_b, double enough) {
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), triangle_pair);
  TriangleDistance<double> found;
  kernel(placed_triangle(a, margin_a, pose_a), placed_triangle(b, margin_b, pose_b), enough, found);
  return found;
}

template <class T>
std::optional<Distance<T>> own_distance(const Triangle<T>& a, T margin_a, const Pose<T>& pose_a, const Triangle<T>& b,
                                        T margin_b, const Pose<T>& pose_b) {
  const auto found =
      distance_of_triangles(a, margin_a, pose_a, b, margin_b, pose_b, std::numeric_limits<double>::infinity());
  if (!found.proven) return std::nullopt;
  return rounded<T>(found.at);
}

template <class T>
std::optional<bool> own_overlap(const Triangle<T>& a, T margin_a, const Pose<T>& pose_a, const Triangle<T>& b,
                                T margin_b, const Pose<T>& pose_b) {
  const auto found = distance_of_triangles(a, margin_a, pose_a, b, margin_b, pose_b, 0);
  if (!found.proven) return std::nullopt;
  return static_cast<T>(found.at.distance) <= T(0);
}

/// The contacts of two shapes that are triangles; returns their signed distance, or where nothing is within the margin
/// a lower bound that exceeds it.
template <class T>
T triangle_pair_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                         Manifold<T>& manifold);

}  // namespace graze
