// Contacts of a box and a triangle alone.
//
// Guarantee: what the kernels answer for many pairs, bit for bit.
#pragma once

#include <optional>

#include "narrow/box_batch.hpp"

namespace graze {

/// The points of a box and a triangle, as the kernels find them for many pairs, and their signed distance (or, when nothing
/// is within the margin, a lower bound that exceeds it); nothing of a sliver, or where their faces do not tell.
template <class T>
std::optional<T> triangle_contacts(const BoxCore<T>& a, const Pose<T>& pose_a, const TriangleCore<T>& b,
                                   const Pose<T>& pose_b, T margin, Manifold<T>& manifold) {
  const BoxAndTriangle<T> pair(a, pose_a, b, pose_b);
  const TriangleChoice<T> choice = triangle_choice(pair, margin);
  if (choice.distance > margin) {
    manifold.normal = rotation_of(pose_a.rotation) * choice.normal;
    return choice.distance;
  }
  const BoxManifold<T> found = triangle_manifold(pair, choice, margin, pose_a);
  if (found.known == T(0)) return std::nullopt;
  take_points<T>(
      static_cast<unsigned>(found.filled), [&](std::size_t i) { return found.slots[i]; }, triangle_features,
      manifold.points);
  manifold.normal = found.normal;
  return choice.distance;
}

/// The same of two shapes in the order of the list that are a box and a triangle without margins, in units in which no product overflows: a power of two takes no
/// digit from any number. Nothing of other shapes.
template <class T>
std::optional<T> triangle_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                                   T margin, Manifold<T>& manifold) {
  constexpr T large = T(0x1p27), smaller_unit = T(0x1p-40);
  const auto* box = a.template as<Box<T>>();
  const auto* triangle = b.template as<Triangle<T>>();
  if (!box || !triangle || a.margin() != T(0) || b.margin() != T(0)) return std::nullopt;
  const BoxCore<T> core_a{box->half_extents()};
  const TriangleCore<T> core_b{{triangle->point(0), triangle->point(1), triangle->point(2)}};
  const auto& p = core_b.point;
  const T size = greatest(greatest(max_abs(core_a.half), max_abs(p[0])), greatest(max_abs(p[1]), max_abs(p[2])));
  if (!(size > large)) {
    if (!regular_box(core_a.half)) return std::nullopt;
    return triangle_contacts(core_a, pose_a, core_b, pose_b, margin, manifold);
  }
  const T u = smaller_unit;
  if (!regular_box(core_a.half * u)) return std::nullopt;
  const auto distance = triangle_contacts<T>({core_a.half * u}, {pose_a.translation * u, pose_a.rotation},
                                             {{p[0] * u, p[1] * u, p[2] * u}},
                                             {pose_b.translation * u, pose_b.rotation}, margin * u, manifold);
  if (!distance) return std::nullopt;
  for (ContactPoint<T>& point : manifold.points)
    point = {point.a / u, point.b / u, point.distance / u, point.feature, point.weight};
  return *distance / u;
}

}  // namespace graze
