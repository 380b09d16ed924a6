// Contacts of a capsule whose side lies on another shape: one point or two along one normal, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The points are those of the general path, up to
// rounding, with the same features: the ends of the stretch in which the faces overlap, each on the surfaces at that
// end.
#pragma once

#include "narrow/core/core.hpp"
#include "narrow/manifold/features.hpp"
#include "narrow/manifold/polygon.hpp"

namespace graze {

/// The points; each lane fills different slots.
template <class S>
struct SegmentContact {
  struct Slot {
    Vec3<S> a, b;
    S distance;
    S place;  ///< index of the two features in the table of the pair
  } slots[2];
  S distance;      ///< distance of the two shapes
  Vec3<S> normal;  ///< unit, from A to B, in the world
  S filled;        ///< slot i holds a point: bit i of this number; 0: nothing is known
};

template <class T, class S>
SegmentContact<T> converted(const SegmentContact<S>& found) {
  const auto slot = [&](std::size_t i) {
    const auto& from = found.slots[i];
    return typename SegmentContact<T>::Slot{converted<T>(from.a), converted<T>(from.b), static_cast<T>(from.distance),
                                            static_cast<T>(from.place)};
  };
  return {{slot(0), slot(1)}, static_cast<T>(found.distance), converted<T>(found.normal), static_cast<T>(found.filled)};
}

template <class M, class S>
SegmentContact<S> select(const M& condition, const SegmentContact<S>& yes, const SegmentContact<S>& no) {
  const auto slot = [&](std::size_t i) {
    const auto &y = yes.slots[i], &n = no.slots[i];
    return typename SegmentContact<S>::Slot{select(condition, y.a, n.a), select(condition, y.b, n.b),
                                            select(condition, y.distance, n.distance),
                                            select(condition, y.place, n.place)};
  };
  return {{slot(0), slot(1)},
          select(condition, yes.distance, no.distance),
          select(condition, yes.normal, no.normal),
          select(condition, yes.filled, no.filled)};
}

/// The points of one pair, in the caller's order of the two shapes.
template <class T>
struct SegmentPoints {
  const SegmentContact<T>& found;
  const std::uint32_t* features;
  bool turned;  ///< A is the caller's second shape

  Vec3<T> normal() const { return turned ? -found.normal : found.normal; }
  /// Appends the points to `points` (of contact points or of types that begin with one) and returns their number.
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

namespace sphere_capsule {

/// Distance from the end of a side within which a point counts as at the end, squared, relative to the square of the
/// length.
template <class S>
inline constexpr typename LaneOf<S>::type near_end = static_cast<typename LaneOf<S>::type>(same_place* same_place);

/// Part number of the side of a ball or a capsule; 0 and 1 are its ends.
inline constexpr int side_part = 2;

/// The part of a segment about the origin that a position on it belongs to: an end, or the inside. `seen`: the square
/// of a unit of its length as seen; `near_squared`: the squared distance within which an end counts.
template <class S>
S part_at(const S& along, const S& half, const S& seen, const S& near_squared) {
  using std::abs;
  const S beside = half - abs(along);
  return select(beside * beside * seen <= near_squared, select(along > S(0), S(1), S(0)), S(side_part));
}

/// The side of a capsule intersected by lines along a direction that is about perpendicular to it.
template <class S>
struct Side {
  S half, radius;
  S up, seen;  ///< `up`: component of the direction along the axis; `seen`: squared length of a unit of the axis as
               ///< seen

  /// The height of the surface along the direction over a position on the axis and `beside` it; minus infinity where
  /// the line misses. `beside` is given by its square, and its product with the axis as seen, since both are seen along
  /// the direction.
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
  /// The squared distance within which an end counts.
  S near_end() const { return S(4) * S(sphere_capsule::near_end<S>) * (half * half * seen); }
};

/// The stretch of a segment about its middle that remains when the bounds of a face clip it.
template <class S>
struct Stretch {
  using Mask = decltype(S() < S());
  S half;
  S low, high;
  Mask any;

  explicit Stretch(const S& half_length) : half(half_length), low(-half_length), high(half_length), any(low <= high) {}
  /// Clips by a slab to the part within `reach` of its middle: `from` is the middle of the segment there, `pace` the
  /// change per unit of length. An end that is out by no more than `slack` stays.
  void cut(const S& from, const S& pace, const S& reach, const S& slack) {
    using std::abs;
    const S zero(0), inverse = S(1) / select(pace == zero, S(1), pace);
    const S at_low = from - pace * half, at_high = from + pace * half;
    const Mask low_out = abs(at_low) > reach + slack, high_out = abs(at_high) > reach + slack;
    const auto crossing = [&](const S& at) {
      return clamp((select(at > zero, reach, -reach) - from) * inverse, -half, half);
    };
    any = any & !(low_out & high_out & (at_low * at_high > zero));
    low = select(low_out, greatest(low, crossing(at_low)), low);
    high = select(high_out, least(high, crossing(at_high)), high);
  }
  /// Clips by a plane to the part where `from`, changing by `pace`, is positive. An end that is out by less than the
  /// root of `slack_squared` stays.
  void cut(const S& from, const S& pace, const S& slack_squared) {
    const S zero(0), at_low = from - pace * half, at_high = from + pace * half;
    const auto out = [&](const S& at) -> Mask { return (at < zero) & (at * at > slack_squared); };
    const Mask low_out = out(at_low), high_out = out(at_high);
    const S crossing = clamp(-from / select(pace == zero, S(1), pace), -half, half);
    any = any & !(low_out & high_out);
    low = select(low_out, greatest(low, crossing), low);
    high = select(high_out, least(high, crossing), high);
  }
};

/// Keeps of the two points those up to `limit` apart, and of two with the same features or at the same place, up to
/// `most_merged`, the deeper. Returns where that leaves a point and one is as near as `nearest`: elsewhere the closest
/// points of the shapes serve better.
template <class S, class M>
M keep_points(SegmentContact<S>& found, const M& first, const M& second, const S& limit, const S& most_merged,
              const S& nearest) {
  const S zero(0), one(1);
  const auto &p = found.slots[0], &q = found.slots[1];
  const auto near = [&](const Vec3<S>& a, const Vec3<S>& b) { return max_abs(a - b) <= most_merged; };
  const M within = first & (p.distance <= limit), within_too = second & (q.distance <= limit),
          same = within & within_too & ((p.place == q.place) | (near(p.a, q.a) & near(p.b, q.b))),
          deeper = q.distance < p.distance;
  found.filled =
      select(within & (!(same & deeper)), one, zero) + select(within_too & (!(same & (!deeper))), S(2), zero);
  return (found.filled > zero) & ((first & (p.distance <= nearest)) | (second & (q.distance <= nearest)));
}

/// Puts the closest points of the shapes where `faces` is not set.
template <class S, class M>
void put_closest(SegmentContact<S>& found, const M& faces, const CoreDistance<S>& closest, const S& place) {
  auto& slot = found.slots[0];
  found.normal = select(faces, found.normal, closest.normal);
  found.filled = select(faces, found.filled, S(1));
  slot = {select(faces, slot.a, closest.a), select(faces, slot.b, closest.b),
          select(faces, slot.distance, closest.distance), select(faces, slot.place, place)};
}

/// Two sides that run along each other, seen along a normal from A to B: axes of capsules, or edges, which have zero
/// radius, in a frame along the world's axes.
template <class S>
struct SidesAlong {
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());

  const TurnedAxis<S>&a, &b;
  const S &radius_a, &radius_b;
  const Vec3<S>& n;
  S up_a, up_b;
  Side<S> side_a, side_b;
  S near;  ///< squared distance within which an end counts

  SidesAlong(const TurnedAxis<S>& axis_a, const S& of_a, const TurnedAxis<S>& axis_b, const S& of_b,
             const Vec3<S>& normal)
      : a(axis_a),
        b(axis_b),
        radius_a(of_a),
        radius_b(of_b),
        n(normal),
        up_a(dot(a.axis, n)),
        up_b(dot(b.axis, n)),
        side_a{a.half, radius_a, up_a, S(1) - up_a * up_a},
        side_b{b.half, radius_b, -up_b, S(1) - up_b * up_b},
        near(least(side_a.near_end(), side_b.near_end())) {}

  S part_a(const S& along) const { return part_at(along, a.half, side_a.seen, near); }
  S part_b(const S& along) const { return part_at(along, b.half, side_b.seen, near); }

  /// Puts the ends of the stretch along which both run (`clip_faces`), in the order of A; `first` and `second` are the
  /// lanes that have them. `origin`: the frame's, in the world. `sharp`: distance beside an edge that counts as on it.
  /// `place(i, j)`: index of the features of two parts.
  template <class Place>
  void put_ends(const Vec3<S>& origin, const S& sharp, const Place& place, SegmentContact<S>& found, Mask& first,
                Mask& second) const {
    using std::abs;
    const S zero(0), one(1), never(-std::numeric_limits<T>::infinity()), radii = radius_a + radius_b;
    // Positions along A, as seen, of positions along B: `middle` for its middle, plus `slope` for each unit.
    const Vec3<S> seen_axis = (a.axis - n * up_a) * (one / side_a.seen);
    const S middle = dot(b.middle - a.middle, seen_axis), slope = dot(b.axis, seen_axis), inverse = one / slope;
    const S reach = abs(slope) * b.half, from = middle - reach, to = middle + reach,
            last = select(slope > zero, b.half, -b.half);
    const Mask meet = (from <= a.half) & (to >= -a.half);
    const S share = select(radii > zero, radius_a / select(radii > zero, radii, one), zero);
    const auto put = [&](typename SegmentContact<S>::Slot& slot, const S& on_a, const S& on_b) -> Mask {
      // The offset of the two axes across the normal is shared, so that both points lie on the rounded sides.
      const Vec3<S> core = a.at(on_a), gap = b.at(on_b) - core;
      const S apart = dot(gap, n);
      const Vec3<S> across = gap - n * apart;
      const S beside = length_squared(across), along_a = dot(across, a.axis), along_b = dot(across, b.axis);
      const Mask shared = beside > sharp * sharp;
      const S to_a = select(shared, share, zero), to_b = select(shared, share - one, zero);
      const S rise_a = side_a.rise(on_a, beside * to_a * to_a, along_a * to_a),
              rise_b = side_b.rise(on_b, beside * to_b * to_b, along_b * to_b);
      slot.distance = apart - (rise_a + rise_b);
      slot.a = origin + (core + across * to_a + n * rise_a);
      slot.b = slot.a + n * slot.distance;
      slot.place = place(part_a(on_a), part_b(on_b));
      return meet & ((radii > zero) | (!shared)) & (rise_a > never) & (rise_b > never);
    };
    first = put(found.slots[0], greatest(from, -a.half),
                select(from > -a.half, -last, b.within((-a.half - middle) * inverse)));
    second = put(found.slots[1], least(to, a.half), select(to < a.half, last, b.within((a.half - middle) * inverse)));
  }
};

}  // namespace sphere_capsule

}  // namespace graze
