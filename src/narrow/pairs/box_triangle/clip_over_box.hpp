// Box against triangle, the points of contact: the triangle, or its edge or vertex, clipped by the box's face along a
// normal, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The points are the corners of the intersection, as
// `clip_faces` gives them, up to rounding; for a vertex the vertex. `known` is 0 where the two are nearer to each other
// elsewhere by more than `face_preference`.
#pragma once

#include "narrow/pairs/box_box/clip_box_faces.hpp"
#include "narrow/pairs/box_triangle/sat.hpp"
#include "narrow/pairs/triangle_face.hpp"

namespace graze {

namespace detail {

/// The feature of the triangle that meets the box along a normal, projected onto the box's face. `n` and the triangle's
/// `normal` and points are in the frame of the box's face, which lies across z at `height`. `fall` is the cosine
/// between n and each edge.
template <class S>
TriangleFace<S> face_over_box(const Vec3<S> (&point)[3], const Vec3<S>& normal, const Vec3<S>& n, const S& height,
                              const Vec3<S>& fall, const S& rounding) {
  using T = typename LaneOf<S>::type;
  const S steep = S(1) / n.z;
  const auto vertex_at = [&](std::size_t i) {
    const S apart = (point[i].z - height) * steep;
    return FlatVertex<S>{{point[i].x - n.x * apart, point[i].y - n.y * apart}, apart, S(static_cast<T>(i))};
  };
  return {vertex_at,
          {-dot(normal, n),
           {normal.x, normal.y},
           {dot(point[0], n), dot(point[1], n), dot(point[2], n)},
           fall,
           S(T(1 - furthest_lean))},
          rounding};
}

}  // namespace detail

/// The points along the chosen axis of a box and a triangle that are at most `margin` apart, in the world. Only for
/// shapes within the margin of each other.
template <class S>
void triangle_manifold(const BoxAndTriangle<S>& p, const TriangleDirections<S>& directions,
                       const TriangleReferenceAxis<S>& choice, const S& margin, const Pose<S>& pose_a,
                       ContactSlots<S>& found) {
  using std::sqrt;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S zero(0), one(1);

  // The axes of the box permuted until that of its face comes last.
  const auto axes = AxisPermutation<S>::longest(choice.normal);
  const Vec3<S> n = axes.turned(choice.normal), half = axes.turned(p.half),
                point[3] = {axes.turned(of_corner(p.point, 0)), axes.turned(of_corner(p.point, 1)),
                            axes.turned(of_corner(p.point, 2))};
  const Mask positive = n.z >= zero;
  const S height = select(positive, half.z, -half.z);
  const Packed<S, 3> fall = abs(dot(directions.along, for_corners(choice.normal)));
  const detail::TriangleFace<S> face = detail::face_over_box(point, axes.turned(directions.normal), n, height,
                                                             Vec3<S>{fall[0], fall[1], fall[2]}, p.noise);
  const detail::RectangleAndTriangle<S> faces{{half.x, half.y}, face.side, face.whole, face.edge, p.noise};
  const S shorter = least(half.x, half.y),
          near = S(T(same_place)) * sqrt(least(S(4) * shorter * shorter, face.shortest_squared())),
          near_squared = near * near;

  detail::Corner<S> slots[most_contact_slots];
  faces.corners(slots, S(same_point<T>) * near_squared);
  detail::ContactPolygon<S> corners = ring_of(slots, [&](const FlatPoint<S>& at) { return face.apart_at(at); });
  const S nearest = corners.find_deepest();
  if (any(face.whole)) detail::simplify(corners, near);

  const Vec3<S> wx = axes.turned(p.turn.row[0]), wy = axes.turned(p.turn.row[1]), wz = axes.turned(p.turn.row[2]);
  found.normal = {dot(wx, n), dot(wy, n), dot(wz, n)};
  found.filled = zero;
  const S box_face = face_part(axes, positive), limit = greatest(margin, choice.distance + p.noise);
  const FlatPoint<S> rim{half.x - near, half.y - near};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const S apart = corners.apart_at(i);
    const Mask here = corners.has(i) & (apart <= limit);
    if (!any(here)) continue;
    const FlatPoint<S> at = corners.at(i);
    const Vec3<S> place{at.x, at.y, height},
        on_box = pose_a.translation + Vec3<S>{dot(wx, place), dot(wy, place), dot(wz, place)};
    found.put(i,
              {on_box, on_box + found.normal * apart, apart,
               box_face + part_along<S>(at.x, rim.x) + part_along<S>(at.y, rim.y) * S(3), face.part(at, near_squared)});
    found.filled = found.filled + select(here, S(T(1 << i)), zero);
  }
  const S allowed = S(T(face_preference)) * least(p.size_a, p.size_b);
  const Mask known = directions.regular & (found.filled > zero) & (nearest <= choice.distance + allowed);
  found.known = select(known, one, zero);
}

}  // namespace graze
