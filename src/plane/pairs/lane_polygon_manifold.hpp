// The points of contact of two polygons of few vertices, one pair a lane: the operations of `manifold`.
#pragma once

#include "plane/pairs/lane_polygon_nearest.hpp"
#include "plane/pairs/lane_sides.hpp"

namespace graze::plane {

/// The edge of a polygon that faces a direction most, of the two beside the vertex that lies furthest along it; in the
/// polygon's own frame.
template <class S>
struct LaneFacingEdge {
  Vec2<S> start, end;
  S length, facing, from, to;

  /// `near` is a vertex near that edge. Where the edge that begins there has the direction for its normal, it goes
  /// before others in line with it: lanes in which that may be another one are not known.
  template <std::size_t N>
  [[gnu::always_inline]] LaneFacingEdge(const LaneVertices<S, N>& polygon, const Vec2<S>& n, const S& near,
                                        decltype(S(0) < S(0))& known) {
    const S top = furthest_from(polygon, n, near), after = polygon.next(top), before = polygon.previous(top);
    const Vec2<S> at_top = polygon.at(polygon.own, top), at_after = polygon.at(polygon.own, after),
                  at_before = polygon.at(polygon.own, before);
    const Vec2<S> ahead = at_after - at_top, behind = at_top - at_before;
    const S length_ahead = plane::length(ahead), length_behind = plane::length(behind);
    const S facing_ahead = dot(right(ahead), n) / length_ahead, facing_behind = dot(right(behind), n) / length_behind;
    const auto back = facing_behind > facing_ahead;
    start = select(back, at_before, at_top);
    end = select(back, at_top, at_after);
    length = select(back, length_behind, length_ahead);
    facing = select(back, facing_behind, facing_ahead);
    from = select(back, before, top);
    to = select(back, top, after);
    known = known & ((from == near) | (facing < S(1 - 0x1p-39)) | (polygon.count < S(2)));
  }

 private:
  template <std::size_t N>
  [[gnu::always_inline]] static S furthest_from(const LaneVertices<S, N>& polygon, const Vec2<S>& n, S vertex) {
    S along[N];
    for (std::size_t k = 0; k < N; ++k) along[k] = dot(polygon.own[k], n);
    const auto at = [&](const S& i) __attribute__((always_inline)) {
      S out = along[0];
      for (std::size_t k = 1; k < N; ++k) out = select(i == S(double(k)), along[k], out);
      return out;
    };
    S most = at(vertex);
    for (const bool forward : {true, false}) {
      auto climbing = S(0) < S(1);
      for (std::size_t k = 0; k < N && any(climbing); ++k) {
        const S beside = forward ? polygon.next(vertex) : polygon.previous(vertex), d = at(beside);
        climbing = climbing & (d > most);
        most = select(climbing, d, most);
        vertex = select(climbing, beside, vertex);
      }
    }
    return vertex;
  }
};

/// The straight side of a polygon, seen along a normal, lane by lane like `PolygonSide`.
template <class S>
struct LanePolygonSide {
  S low_across, high_across, low_height, high_height, radius, facing, leaning, slope, low_vertex, high_vertex;
  S reach;  ///< the coordinates of both ends, added up

  [[gnu::always_inline]] LanePolygonSide(const LaneFacingEdge<S>& best, const S& rounding, const Vec2<S>& n,
                                         const Vec2<S>& along, bool forward)
      : radius(rounding) {
    const Vec2<S> own = right(best.end - best.start) / best.length;
    facing = dot(own, n);
    leaning = dot(own, along);
    slope = -leaning / facing;
    low_vertex = forward ? best.from : best.to;
    high_vertex = forward ? best.to : best.from;
    const Vec2<S> low = forward ? best.start : best.end, high = forward ? best.end : best.start;
    low_across = dot(low, along), low_height = dot(low, n);
    high_across = dot(high, along), high_height = dot(high, n);
    reach = reach_of(low, high);
  }
  [[gnu::always_inline]] void move(const S& across, const S& height) {
    low_across += across, high_across += across;
    low_height += height, high_height += height;
  }
  [[gnu::always_inline]] S height_at(const S& across) const {
    const S from = low_across + radius * leaning, to = high_across + radius * leaning;
    const S straight = low_height + radius * facing + (across - from) * slope;
    const auto low = across < from, on_disc = (radius > S(0)) & (low | (across > to));
    if (!any(on_disc)) return straight;
    const S off = across - select(low, low_across, high_across), under = radius * radius - off * off;
    return select(on_disc, select(low, low_height, high_height) + sqrt(greatest(under, S(0))), straight);
  }
};

/// The points up to `margin` apart. `nearest`: the nearest points; its `known` is narrowed to the lanes whose points of
/// contact are known as well.
template <class S, std::size_t N>
[[gnu::always_inline]] inline LaneManifold<S> lane_polygon_manifold(const LanePolygons<S, N>& pair,
                                                                    LanePolygonNearest<S>& nearest, const S& margin) {
  const LaneNearest<S>& found = nearest.points;
  const S distance = found.distance - pair.radius_a - pair.radius_b;
  const Vec2<S> n = found.normal, along = left(n);
  LaneManifold<S> out;
  out.normal = n;
  out.has_first = distance <= margin;
  out.has_second = S(1) < S(0);
  const Vec2<S> on_a = found.a + n * pair.radius_a;
  out.first = {on_a, on_a + n * distance, distance, joined_features(found.feature_a, found.feature_b), S(0.5)};
  out.second = out.first;
  const auto near = out.has_first;
  if (!any(near)) return out;
  const Rot2<S> r = pair.b_in_a.rotation;
  const Vec2<S> toward_a = inverse_rotate(r, -n), along_b = inverse_rotate(r, along), t = pair.b_in_a.translation;
  auto known = nearest.known;
  const LaneFacingEdge<S> edge_a(pair.a, n, nearest.near_a, known), edge_b(pair.b, toward_a, nearest.near_b, known);
  nearest.known = nearest.known & (known | !near);
  const S least_facing(0.5), one(1);
  const LanePolygonSide<S> a(edge_a, pair.radius_a, n, along, true);
  LanePolygonSide<S> b(edge_b, pair.radius_b, toward_a, along_b, false);
  b.move(dot(t, along), -dot(t, n));
  const S low = greatest(a.low_across, b.low_across), high = least(a.high_across, b.high_across);
  const auto facing = near & (pair.a.count > one) & (pair.b.count > one) & (edge_a.facing >= least_facing) &
                      (edge_b.facing >= least_facing) & share_a_stretch(low, high, a.reach, b.reach, t);
  if (!any(facing)) return out;
  const auto point = [&](const S& across, const S& vertex_a, const S& vertex_b) __attribute__((always_inline)) {
    const S height_a = a.height_at(across), height_b = -b.height_at(across);
    const Vec2<S> foot = along * across;
    return LanePoint<S>{foot + n * height_a, foot + n * height_b, height_b - height_a,
                        joined_features(vertex_number(vertex_a), vertex_number(vertex_b)), S(0.5)};
  };
  const LanePoint<S> at_low = point(low, a.low_vertex, b.low_vertex),
                     at_high = point(high, a.high_vertex, b.high_vertex);
  const auto has_low = facing & (at_low.distance <= margin);
  out.has_second = facing & (at_high.distance <= margin);
  // The nearest points remain where both ends of the shared stretch are further away.
  const auto alone = near & !(has_low | out.has_second);
  out.has_first = alone | has_low;
  out.first = select(alone, out.first, at_low);
  out.second = at_high;
  return out;
}

}  // namespace graze::plane
