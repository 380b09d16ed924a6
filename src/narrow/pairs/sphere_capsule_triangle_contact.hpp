// Contact of a ball or an untapered capsule with a triangle, across lanes: in one point, or along the capsule's side.
//
// Guarantee: in every lane the bits that the pair gives alone: those of `distance`, with the features that faces give.
// The general path answers where `known` is -1.
#pragma once

#include "narrow/pairs/capsule_triangle_segment.hpp"
#include "narrow/pairs/sphere_capsule_contacts.hpp"

namespace graze {

/// The contact at the closest points, with its parts up to `limit` apart. The distance of an unknown pair is -infinity.
template <class S, class Pair>
OneContact<S> closest_triangle_contact(const Pair& pair, const S& limit) {
  const S nothing(-std::numeric_limits<double>::infinity());
  const auto known = pair.known();
  OneContact<S> contact{pair.distance(), S(0), S(0), S(-1)};
  contact.at.distance = select(known, contact.at.distance, nothing);
  if (!any(known & (contact.at.distance <= limit))) return contact;
  contact.part_a = pair.part();
  contact.part_b = pair.triangle_part();
  contact.known = select(known, select(pair.one_point(), S(1), S(0)), S(-1));
  return contact;
}

/// The contact of a single pair. Nothing where the answer is incomplete; where there may be two points, the manifold
/// then holds the closest points.
template <class T, class Pair, class M>
std::optional<T> contact_of(const Pair& pair, T margin, M& manifold) {
  if (!pair.known()) return std::nullopt;
  const auto found = closest_triangle_contact(pair, before_rounding<T>(static_cast<double>(margin)));
  const CoreDistance<double>& at = found.at;
  const T distance = static_cast<T>(at.distance);
  if (std::is_same_v<M, Manifold<T>> || distance <= margin) put(converted<T>(at.normal), manifold.normal);
  if (distance <= margin) {
    const std::uint32_t feature =
        ids_with_triangle.of[static_cast<std::size_t>(feature_place(found.part_a, found.part_b))];
    ContactPoint<T>& point = manifold.points.emplace_back();
    put(converted<T>(at.a), point.a);
    put(converted<T>(at.b), point.b);
    point.distance = distance;
    point.feature = feature;
    point.weight = T(0.5);
    if (found.known == 0) return std::nullopt;
  }
  return distance;
}

}  // namespace graze
