// Contacts of a box and a triangle alone.
//
// Guarantee: what the kernels answer for many pairs, bit for bit.
#pragma once

#include <optional>

#include "narrow/batch/box_batch.hpp"

namespace graze {

/// Nothing of a sliver, where lengths are so large that products of them overflow, or where the faces do not tell.
template <class T>
std::optional<T> triangle_contacts(const BoxCore<T>& a, const Pose<T>& pose_a, const TriangleCore<T>& b,
                                   const Pose<T>& pose_b, T margin, Manifold<T>& manifold) {
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), triangle_contact<T>);
  ContactSlots<T> found;
  const T distance = kernel({&a, &b, &pose_a, &pose_b, margin}, found);
  if (!(distance > margin)) {
    if (found.known == T(0)) return std::nullopt;
    take_points<T>(
        static_cast<unsigned>(found.filled), [&](std::size_t i) { return found.slot(i); }, box_features.of,
        triangle_features, manifold.points);
  }
  manifold.normal = found.normal;
  return distance;
}

/// The same in units in which no product overflows: a power of two takes no digit from any number.
template <class T>
std::optional<T> large_triangle_contacts(const BoxCore<T>& a, const Pose<T>& pose_a, const TriangleCore<T>& b,
                                         const Pose<T>& pose_b, T margin, Manifold<T>& manifold) {
  constexpr T u = T(0x1p-40);
  const auto smaller = [&](const Pose<T>& pose) { return Pose<T>{pose.translation * u, pose.rotation}; };
  const auto distance =
      triangle_contacts<T>({a.half * u}, smaller(pose_a), {{b.point[0] * u, b.point[1] * u, b.point[2] * u}},
                           smaller(pose_b), margin * u, manifold);
  if (!distance) return std::nullopt;
  for (ContactPoint<T>& p : manifold.points) p = {p.a / u, p.b / u, p.distance / u, p.feature, p.weight};
  return *distance / u;
}

/// Of shapes with their margins: the signed distance (where nothing is within the margin, a lower bound that exceeds
/// it); nothing where the general path has to answer.
template <class T>
std::optional<T> own_contacts(const Box<T>& a, T margin_a, const Pose<T>& pose_a, const Triangle<T>& b, T margin_b,
                              const Pose<T>& pose_b, T margin, Manifold<T>& manifold) {
  if (margin_a != T(0) || margin_b != T(0)) return std::nullopt;
  const BoxCore<T> box{a.half_extents()};
  const TriangleCore<T> triangle{{b.point(0), b.point(1), b.point(2)}};
  const auto& p = triangle.point;
  constexpr T large = T(0x1p27);
  const T size = greatest(greatest(max_abs(box.half), max_abs(p[0])), greatest(max_abs(p[1]), max_abs(p[2])));
  const bool small = !(size > large);
  if (!regular_box(small ? box.half : box.half * T(0x1p-40))) return std::nullopt;
  return small ? triangle_contacts(box, pose_a, triangle, pose_b, margin, manifold)
               : large_triangle_contacts(box, pose_a, triangle, pose_b, margin, manifold);
}

}  // namespace graze
