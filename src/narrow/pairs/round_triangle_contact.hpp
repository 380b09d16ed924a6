// A ball or an even capsule and a triangle that touch in one point, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone: those of `distance`, and the names that the faces give.
// Where there is no such answer, or the capsule's side lies on the triangle, which may give two points, `known` says so:
// the general path answers then.
#pragma once

#include "narrow/pairs/capsule_box_contact.hpp"
#include "narrow/pairs/capsule_triangle.hpp"
#include "narrow/pairs/round_contacts.hpp"

namespace graze {

/// Up to `limit` apart it is asked what touches. Of a pair of which nothing is known the distance is -infinity.
template <class S, class Pair>
RoundContact<S> round_triangle_contact(const Pair& pair, const S& limit) {
  const S nothing(-std::numeric_limits<double>::infinity());
  const auto known = pair.known();
  RoundContact<S> contact{pair.distance(), S(0), S(0), S(0)};
  contact.at.distance = select(known, contact.at.distance, nothing);
  if (!any(known & (contact.at.distance <= limit))) return contact;
  contact.part_a = pair.part();
  contact.part_b = pair.triangle_part();
  contact.known = select(known & pair.one_point(), S(1), S(0));
  return contact;
}

template <class B, class T, class Pair>
std::optional<T> contact_of(const Pair& pair, T margin, Manifold<T>& manifold) {
  if (!pair.known()) return std::nullopt;
  const auto found = round_triangle_contact(pair, before_rounding<T>(static_cast<double>(margin)));
  const CoreDistance<double>& at = found.at;
  const T distance = static_cast<T>(at.distance);
  if (distance <= margin) {
    if (found.known == 0) return std::nullopt;
    const std::uint32_t feature =
        round_feature_ids<B, T>().of[static_cast<std::size_t>(feature_place(found.part_a, found.part_b))];
    manifold.points.push_back({cast<T>(at.a), cast<T>(at.b), distance, feature, T(0.5)});
  }
  manifold.normal = cast<T>(at.normal);
  return distance;
}

template <class T>
std::optional<T> own_contacts(const Sphere<T>& ball, T margin_ball, const Pose<T>& pose_ball,
                              const Triangle<T>& triangle, T margin_triangle, const Pose<T>& pose_triangle, T margin,
                              Manifold<T>& manifold) {
  return contact_of<Triangle<T>>(with_triangle(ball, margin_ball, pose_ball, triangle, margin_triangle, pose_triangle),
                                 margin, manifold);
}
template <class T>
std::optional<T> own_contacts(const Capsule<T>& capsule, T margin_capsule, const Pose<T>& pose,
                              const Triangle<T>& triangle, T margin_triangle, const Pose<T>& pose_triangle, T margin,
                              Manifold<T>& manifold) {
  if (!has_even_side(capsule)) return std::nullopt;
  return contact_of<Triangle<T>>(with_triangle(capsule, margin_capsule, pose, triangle, margin_triangle, pose_triangle),
                                 margin, manifold);
}

}  // namespace graze
