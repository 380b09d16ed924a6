// What touches where the side of a capsule lies on something: one point or two along one normal, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The points are those of the general path, up to rounding
// and under the same names: the ends of the stretch in which the faces lie over each other, each on the surfaces over
// it.
#pragma once

#include "narrow/core/core.hpp"
#include "narrow/manifold/features.hpp"
#include "narrow/manifold/polygon.hpp"

namespace graze {

/// The points; which of the slots hold one is another matter in every lane.
template <class S>
struct SegmentContact {
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

/// The points of one pair, in the order in which the two stand.
template <class T>
struct SegmentPoints {
  const SegmentContact<T>& found;
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

  /// How far beyond a place on the axis, and `beside` it, the surface lies; minus infinity where the line passes by.
  /// The square of what is beside, and its product with the axis as seen, since both are seen along the direction.
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

/// The stretch of a segment about its middle that is left where what bounds a face cuts it.
template <class S>
struct Stretch {
  using Mask = decltype(S() < S());
  S half;
  S low, high;
  Mask any;

  explicit Stretch(const S& half_length) : half(half_length), low(-half_length), high(half_length), any(low <= high) {}
  /// What is within `reach` of the middle of a slab: `from` is the segment's middle there, which moves by `pace`. An
  /// end stays that is no further out than `slack`.
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
  /// What is on the inner side of a plane, where `from` and what it becomes are positive. An end stays that is out by
  /// less than the root of `slack_squared`.
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

/// Of the two points keeps those up to `limit` apart, and of two under the same names or at the same place, up to
/// `together`, the deeper. Where that leaves one, and one is as near as `nearest`: elsewhere the closest points of the
/// shapes serve better.
template <class S, class M>
M keep_points(SegmentContact<S>& found, const M& first, const M& second, const S& limit, const S& together,
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
void put_closest(SegmentContact<S>& found, const M& faces, const CoreDistance<S>& closest, const S& place) {
  auto& slot = found.slots[0];
  found.normal = select(faces, found.normal, closest.normal);
  found.filled = select(faces, found.filled, S(1));
  slot = {select(faces, slot.a, closest.a), select(faces, slot.b, closest.b),
          select(faces, slot.distance, closest.distance), select(faces, slot.place, place)};
}

/// Two sides that run along each other, seen along a normal from A to B: axes of capsules, or edges, which have no
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
  S near;  ///< how near an end counts as that, squared

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

  /// The ends of the stretch that they run along each other (`clip_faces`), in the order of A; in which lanes there are
  /// such. `origin`: of the frame, in the world. `sharp`: how far beside an edge counts as on it. `place(i, j)`: that
  /// of the names of two parts.
  template <class Place>
  void put_ends(const Vec3<S>& origin, const S& sharp, const Place& place, SegmentContact<S>& found, Mask& first,
                Mask& second) const {
    using std::abs;
    const S zero(0), one(1), never(-std::numeric_limits<T>::infinity()), radii = radius_a + radius_b;
    // Where along A, as seen, the places along B are: at `middle` its middle, further by `slope` for each unit.
    const Vec3<S> seen_axis = (a.axis - n * up_a) * (one / side_a.seen);
    const S middle = dot(b.middle - a.middle, seen_axis), slope = dot(b.axis, seen_axis), inverse = one / slope;
    const S reach = abs(slope) * b.half, from = middle - reach, to = middle + reach,
            last = select(slope > zero, b.half, -b.half);
    const Mask meet = (from <= a.half) & (to >= -a.half);
    const S share = select(radii > zero, radius_a / select(radii > zero, radii, one), zero);
    const auto put = [&](typename SegmentContact<S>::Slot& slot, const S& on_a, const S& on_b) -> Mask {
      // What the two axes are apart across the normal is shared, so that both points lie on the rounded sides.
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

}  // namespace round

}  // namespace graze
