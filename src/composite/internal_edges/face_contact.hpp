// The feature that a contact stands on, before any search for its neighbours.
//
// Guarantee: a contact that stands clear is one that `settle_normal` (ghost_contacts.hpp) leaves as it is, up to
// rounding.
#pragma once

#include <algorithm>

#include "composite/internal_edges/leaf_in_context.hpp"
#include "graze/contact.hpp"

namespace graze {

/// A contact leans no further than this sine, two degrees, from the face that its body stands on: up to there the caps
/// of cylinders and cones count as standing too (`contact.hpp`).
template <class T>
inline constexpr T standing_lean = T(0.035);

/// The place of contacts on one of their sides: the middle of the deepest points, which lies inside the edge for an
/// edge's contact and not at an end of it.
template <class T, class Points>
Vec3<T> standing_point(const Points& points, Vec3<T> ContactPoint<T>::*side) {
  const ContactPoint<T>& deepest =
      *std::min_element(points.begin(), points.end(),
                        [](const ContactPoint<T>& p, const ContactPoint<T>& q) { return p.distance < q.distance; });
  Vec3<T> sum{};
  T count(0);
  for (const ContactPoint<T>& p : points) {
    const Vec3<T> from = p.*side - deepest.*side;
    if (p.distance - deepest.distance > same_direction<T> * length(from)) continue;
    sum += from;
    count += T(1);
  }
  return deepest.*side + sum / count;
}

/// The normal of the triangle's or box's face that `outward` is the normal of, but for rounding or a `lean` (sine);
/// zero if of none.
template <class T>
Vec3<T> face_along(const LeafInContext<T>& self, const Vec3<T>& outward, T lean = same_direction<T>);

/// Whether nothing beside the convex shape `self` makes the contact on it other than it is: its normal, `outward`, is
/// that of the face it stands on, and nothing beside rises above the plane through `point`, its standing point, where
/// that is or between there and the middle of `other`. Most contacts on a floor of several bodies are such, and this is
/// told by a point of each of those beside.
template <class T>
bool stands_clear(const LeafInContext<T>& self, const LeafInContext<T>& other, const Vec3<T>& outward,
                  const Vec3<T>& point);

}  // namespace graze
