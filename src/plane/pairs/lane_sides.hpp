// The straight sides of cores that face a normal, across lanes, and the points of contact between two of them.
//
// Guarantee: the points that `manifold` of `plane/manifold.hpp` gives, up to rounding, under the same names: no side is
// the reference of the other, so that a swap of the shapes mirrors the points and their features.
#pragma once

#include "plane/pairs/lane_pair.hpp"
#include "plane/shared_stretch.hpp"

namespace graze::plane {

/// The least cosine between the normal of a side and that of the contact for the side to be clipped by the other's: 60
/// degrees.
inline constexpr double least_facing_side = 0.5;

/// A straight side seen along a normal: its ends by their place across it and their height along it.
template <class S>
struct LaneSide {
  using Mask = decltype(S(0) < S(0));
  Mask straight;              ///< whether there is one that faces the normal
  S low_across, high_across;  ///< in order
  S low_height, high_height;  ///< of the core
  S low_vertex, high_vertex;  ///< features
  S radius;                   ///< that rounds it
  S facing, leaning;          ///< cosine and sine between its own normal and the given one
  S reach;                    ///< the coordinates of both ends, added up: what rounding refers to
  bool endless = false;       ///< of a half-plane

  /// Height of the surface at a place across that lies between the ends.
  [[gnu::always_inline]] S height_at(const S& across) const {
    if (endless) return radius;
    const S slope = -leaning / facing;
    const S straight_height = low_height + radius * facing + (across - (low_across + radius * leaning)) * slope;
    // Beyond the straight piece the disc at the end.
    const auto below = across<low_across + radius * leaning, beyond = across> high_across + radius * leaning;
    if (!any(below | beyond)) return straight_height;
    const S off = across - select(below, low_across, high_across), under = radius * radius - off * off;
    const S on_disc = select(below, low_height, high_height) + sqrt(greatest(under, S(0)));
    return select(below | beyond, on_disc, straight_height);
  }
};

/// A side between two vertices in its core's frame, the second one to the left of its own normal.
template <class S>
[[gnu::always_inline]] inline LaneSide<S>
side_between(const Vec2<S>& right_end, const Vec2<S>& left_end, const S& right_feature, const S& left_feature,
             const Vec2<S>& own, const Vec2<S>& n, const typename LaneSide<S>::Mask& usable, const S& radius) {
  LaneSide<S> side;
  const Vec2<S> along = left(n);
  side.facing = dot(own, n);
  side.leaning = dot(own, along);
  side.straight = usable & (side.facing >= S(least_facing_side));
  side.low_across = dot(right_end, along);
  side.high_across = dot(left_end, along);
  side.low_height = dot(right_end, n);
  side.high_height = dot(left_end, n);
  side.low_vertex = vertex_number(right_feature);
  side.high_vertex = vertex_number(left_feature);
  side.radius = radius;
  side.reach = reach_of(right_end, left_end);
  return side;
}

/// The side of a shape's core towards `n`, unit and in the shape's frame.
template <LaneCore core, class S>
[[gnu::always_inline]] inline LaneSide<S> side_towards(const LaneShape<S>& shape, const Vec2<S>& n) {
  const S zero(0), one(1);
  if constexpr (core == LaneCore::box) {
    const S hx = shape.size[0], hy = shape.size[1];
    // A side without a length faces nothing.
    const auto long_x = hy > zero, long_y = hx > zero;
    const auto x = long_x & ((abs(n.x) >= abs(n.y)) | !long_y);
    const S s = sign_of(select(x, n.x, n.y)), minus = -s;
    const Vec2<S> own{select(x, s, zero), select(x, zero, s)};
    const Vec2<S> right_end{s * hx, select(x, minus, s) * hy}, left_end{select(x, s, minus) * hx, s * hy};
    const auto positive = s > zero;
    // Sides begin at vertices 0 (below), 1, 2 and 3.
    const S first = select(positive, select(x, one, S(2)), select(x, S(3), zero));
    return side_between(right_end, left_end, first, select(first == S(3), zero, first + one), own, n, long_x | long_y,
                        shape.radius);
  } else if constexpr (core == LaneCore::segment) {
    const Vec2<S> p{shape.size[0], shape.size[1]}, q{shape.size[2], shape.size[3]};
    const Vec2<S> u = q - p;
    const S squared = length_squared(u);
    const auto extended = squared > zero;
    const S inverse_length = one / sqrt(select(extended, squared, one));
    const Vec2<S> outward = right(u) * inverse_length;
    const auto forward = dot(outward, n) >= zero;
    return side_between(select(forward, p, q), select(forward, q, p), select(forward, zero, one),
                        select(forward, one, zero), select(forward, outward, -outward), n, extended, shape.radius);
  } else {
    static_assert(core == LaneCore::half_plane);
    LaneSide<S> side{};
    side.straight = zero <= one;
    side.low_across = S(-std::numeric_limits<double>::infinity());
    side.high_across = S(std::numeric_limits<double>::infinity());
    side.low_vertex = side.high_vertex = side_number(zero);
    side.radius = shape.radius;
    side.facing = one;
    side.reach = zero;
    side.endless = true;
    return side;
  }
}

/// B's side seen from A: across the other way round, its heights growing against the normal.
template <class S>
[[gnu::always_inline]] inline LaneSide<S> seen_from_a(const LaneSide<S>& of_b, const Vec2<S>& translation,
                                                      const Vec2<S>& n) {
  const S across = dot(translation, left(n)), height = -dot(translation, n);
  LaneSide<S> side = of_b;
  side.low_across = across - of_b.high_across;
  side.high_across = across - of_b.low_across;
  side.low_height = of_b.high_height + height;
  side.high_height = of_b.low_height + height;
  side.low_vertex = of_b.high_vertex;
  side.high_vertex = of_b.low_vertex;
  side.leaning = -of_b.leaning;
  return side;
}

/// A point of contact in A's frame.
template <class S>
struct LanePoint {
  Vec2<S> a, b;
  S distance, feature, weight;
};

/// At most two points of contact that share a normal, in A's frame.
template <class S>
struct LaneManifold {
  using Mask = decltype(S(0) < S(0));
  Vec2<S> normal;
  LanePoint<S> first, second;
  Mask has_first, has_second;
};

/// The most points of contact of two cores.
template <LaneCore a, LaneCore b>
inline constexpr int most_points = a == LaneCore::point || b == LaneCore::point ? 1 : 2;

template <class S>
[[gnu::always_inline]] inline S joined_features(const S& of_a, const S& of_b) {
  return of_a * S(65536) + of_b;
}

/// The point where the shapes are nearest. Between two discs it is weighted by their radii.
template <bool discs, class S>
[[gnu::always_inline]] inline LanePoint<S> nearest_point(const LanePair<S>& pair, const LaneNearest<S>& found) {
  LanePoint<S> point;
  point.distance = found.distance - pair.radius();
  point.a = found.a + found.normal * pair.a.radius;
  point.b = point.a + found.normal * point.distance;
  point.feature = joined_features(found.feature_a, found.feature_b);
  point.weight = S(0.5);
  if constexpr (discs) {
    const S radii = pair.radius();
    point.weight = select(radii > S(0), pair.a.radius / select(radii > S(0), radii, S(1)), point.weight);
  }
  return point;
}

template <class M, class S>
[[gnu::always_inline]] inline LanePoint<S> select(const M& condition, const LanePoint<S>& yes, const LanePoint<S>& no) {
  return {select(condition, yes.a, no.a), select(condition, yes.b, no.b), select(condition, yes.distance, no.distance),
          select(condition, yes.feature, no.feature), select(condition, yes.weight, no.weight)};
}

/// The point of two sides that face each other at a place across.
template <class S>
[[gnu::always_inline]] inline LanePoint<S> point_between(const LaneSide<S>& a, const LaneSide<S>& b, const Vec2<S>& n,
                                                         const S& across, const S& feature) {
  const S height_a = a.height_at(across), height_b = -b.height_at(across);
  const Vec2<S> foot = left(n) * across;
  return {foot + n * height_a, foot + n * height_b, height_b - height_a, feature, S(0.5)};
}

/// The points of two shapes, `found` their nearest ones, that are up to `margin` apart. There is no second one where a
/// core is a point.
template <LaneCore core_a, LaneCore core_b, class S>
[[gnu::always_inline]] inline LaneManifold<S> manifold(const LanePair<S>& pair, const LaneNearest<S>& found,
                                                       const S& margin) {
  LaneManifold<S> out;
  out.normal = found.normal;
  out.has_first = found.distance - pair.radius() <= margin;
  out.has_second = S(1) < S(0);
  out.first = nearest_point < core_a == LaneCore::point && core_b == LaneCore::point > (pair, found);
  if constexpr (most_points<core_a, core_b> == 2) {
    const auto near = out.has_first;
    out.second = out.first;
    if (!any(near)) return out;
    const Vec2<S> n = found.normal;
    const LaneSide<S> a = side_towards<core_a>(pair.a, n);
    const LaneSide<S> b =
        seen_from_a(side_towards<core_b>(pair.b, inverse_rotate(pair.b_in_a.rotation, -n)), pair.b_in_a.translation, n);
    const S low = greatest(a.low_across, b.low_across), high = least(a.high_across, b.high_across);
    const auto facing =
        near & a.straight & b.straight & share_a_stretch(low, high, a.reach, b.reach, pair.b_in_a.translation);
    if (!any(facing)) return out;
    const LanePoint<S> at_low = point_between(a, b, n, low, joined_features(a.low_vertex, b.low_vertex)),
                       at_high = point_between(a, b, n, high, joined_features(a.high_vertex, b.high_vertex));
    const auto has_low = facing & (at_low.distance <= margin);
    out.has_second = facing & (at_high.distance <= margin);
    // The nearest points remain where both ends of the shared stretch are further away.
    const auto alone = near & !(has_low | out.has_second);
    out.has_first = alone | has_low;
    out.first = select(alone, out.first, at_low);
    out.second = at_high;
  }
  return out;
}

}  // namespace graze::plane
