// What touches where the side of a capsule lies on something: one point or two along one normal, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The points are those of the general path, up to rounding
// and under the same names: the ends of the stretch in which the faces lie over each other, each on the surfaces over it.
#pragma once

#include "narrow/core.hpp"
#include "narrow/features.hpp"
#include "narrow/outline.hpp"

namespace graze {

/// The points; which of the slots hold one is another matter in every lane.
template <class S>
struct SideContact {
  struct Slot {
    Vec3<S> a, b;
    S distance;
    S place;  ///< of the names of the two features, in the table of the pair
  } slots[2];
  S distance;      ///< of the two shapes
  Vec3<S> normal;  ///< unit, from A to B, in the world
  S filled;        ///< slot i holds a point: bit i of this number; 0: nothing is known
};

template <class T, class S>
SideContact<T> cast(const SideContact<S>& found) {
  const auto slot = [&](std::size_t i) {
    const auto& from = found.slots[i];
    return typename SideContact<T>::Slot{cast<T>(from.a), cast<T>(from.b), static_cast<T>(from.distance),
                                         static_cast<T>(from.place)};
  };
  return {{slot(0), slot(1)}, static_cast<T>(found.distance), cast<T>(found.normal), static_cast<T>(found.filled)};
}

/// The points of one pair, in the order in which the two stand.
template <class T>
struct SidePoints {
  const SideContact<T>& found;
  const std::uint32_t* features;
  bool turned;  ///< A is the second of the two for whoever asks

  Vec3<T> normal() const { return turned ? -found.normal : found.normal; }
  /// Appends them to `points` (of contact points or of what begins with one) and returns how many.
  template <class Points>
  std::size_t append(Points& points) const {
    const auto filled = static_cast<unsigned>(found.filled);
    for (unsigned i = 0; i < 2; ++i) {
      if ((filled >> i & 1) == 0) continue;
      const auto& slot = found.slots[i];
      const ContactPoint<T> p{slot.a, slot.b, slot.distance, features[static_cast<std::size_t>(slot.place)]};
      points.push_back({turned ? mirrored(p) : p});
    }
    return (filled & 1) + (filled >> 1);
  }
};

namespace round {

/// How near the end of a side counts as that, squared, relative to the square of its length.
template <class S>
inline constexpr typename LaneOf<S>::type near_end = static_cast<typename LaneOf<S>::type>(same_place* same_place);

/// What of a ball or a capsule a part is: a centre, or the side between the two.
inline constexpr int side_part = 2;

/// What of a segment about the origin a place on it lies on: an end of it, or its inside. `seen`: the square of a unit
/// of its length as seen; `near_squared`: how near an end counts as that.
template <class S>
S part_at(const S& along, const S& half, const S& seen, const S& near_squared) {
  using std::abs;
  const S beside = half - abs(along);
  return select(beside * beside * seen <= near_squared, select(along > S(0), S(1), S(0)), S(side_part));
}

/// The side of a capsule met by lines along a direction that is about across it.
template <class S>
struct Side {
  S half, radius;
  S up, seen;  ///< along the axis a unit of the direction, and squared a unit of the axis as seen

  /// How far beyond a place on the axis, and `beside` it, the surface lies; minus infinity where the line passes by. The
  /// square of what is beside, and its product with the axis as seen, since both are seen along the direction.
  S rise(const S& along, const S& beside_squared, const S& beside_along) const {
    using std::sqrt;
    const S zero(0), never(-std::numeric_limits<typename LaneOf<S>::type>::infinity()), flat = S(1) / seen;
    const S left = radius * radius - (beside_squared - beside_along * beside_along * flat);
    const S by_side = sqrt(greatest(left, zero) * flat) + up * beside_along * flat,
            at = along + beside_along + by_side * up;
    const S side = select((left >= zero) & (at >= -half) & (at <= half), by_side, never);
    const auto ball = [&](const S& end) {
      const S from = along - end,
              rest = radius * radius - (from * from * seen + S(2) * from * beside_along + beside_squared);
      return select(rest >= zero, sqrt(greatest(rest, zero)) - from * up, never);
    };
    return greatest(side, greatest(ball(-half), ball(half)));
  }
  S rise(const S& along) const { return rise(along, S(0), S(0)); }
  /// How near an end counts as that, squared.
  S near_end() const { return S(4) * S(round::near_end<S>) * (half * half * seen); }
};

/// Of the two points keeps those up to `limit` apart, and of two under the same names or at the same place, up to
/// `together`, the deeper. Where that leaves one, and one is as near as `nearest`: elsewhere the closest points of the
/// shapes serve better.
template <class S, class M>
M keep_points(SideContact<S>& found, const M& first, const M& second, const S& limit, const S& together,
              const S& nearest) {
  const S zero(0), one(1);
  const auto &p = found.slots[0], &q = found.slots[1];
  const auto near = [&](const Vec3<S>& a, const Vec3<S>& b) { return max_abs(a - b) <= together; };
  const M within = first & (p.distance <= limit), within_too = second & (q.distance <= limit),
          same = within & within_too & ((p.place == q.place) | (near(p.a, q.a) & near(p.b, q.b))),
          deeper = q.distance < p.distance;
  found.filled =
      select(within & (!(same & deeper)), one, zero) + select(within_too & (!(same & (!deeper))), S(2), zero);
  return (found.filled > zero) & ((first & (p.distance <= nearest)) | (second & (q.distance <= nearest)));
}

/// Puts the closest points of the shapes where `faces` do not tell.
template <class S, class M>
void put_closest(SideContact<S>& found, const M& faces, const CoreDistance<S>& closest, const S& place) {
  auto& slot = found.slots[0];
  found.normal = select(faces, found.normal, closest.normal);
  found.filled = select(faces, found.filled, S(1));
  slot = {select(faces, slot.a, closest.a), select(faces, slot.b, closest.b),
          select(faces, slot.distance, closest.distance), select(faces, slot.place, place)};
}

}  // namespace round

}  // namespace graze
