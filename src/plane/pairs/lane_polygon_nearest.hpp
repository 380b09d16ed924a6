// The nearest points of two polygons of few vertices, one pair a lane: the operations of `nearest_by_axes`.
#pragma once

#include "plane/nearest_edge.hpp"
#include "plane/pairs/lane_polygons.hpp"

namespace graze::plane {

template <class S>
struct LanePolygonNearest {
  LaneNearest<S> points;
  S near_a, near_b;  ///< the vertices that the features are or begin at
  decltype(S(0) < S(0)) known;
};

/// The edge of the difference that the origin lies least deep below, or furthest above: found without roots, by squares
/// of heights with their signs. The runner-up is kept too, by which a choice within rounding is recognised.
template <class S>
struct LaneLeastEdge {
  using Mask = decltype(S(0) < S(0));
  S number = S(0);           ///< of the edge, those of B from `lane_vertices` on
  Vec2<S> edge{}, vertex{};  ///< that edge, and where it begins
  S best = S(std::numeric_limits<double>::infinity()), best_length = S(1);
  S next = S(std::numeric_limits<double>::infinity()), next_length = S(1);
  Mask regular = S(0) < S(1);

  [[gnu::always_inline]] void offer(const S& across, const Vec2<S>& e, const Vec2<S>& from, const Mask& there,
                                    std::size_t at) {
    const S squared = length_squared(e), signed_square = across * abs(across);
    regular = regular & ((squared >= S(least_squared_edge)) | !there);
    const Mask better = there & (signed_square * best_length < best * squared);
    const Mask second = there & !better & (signed_square * next_length < next * squared);
    next = select(better, best, select(second, signed_square, next));
    next_length = select(better, best_length, select(second, squared, next_length));
    best = select(better, signed_square, best);
    best_length = select(better, squared, best_length);
    number = select(better, S(double(at)), number);
    edge = select(better, e, edge);
    vertex = select(better, from, vertex);
  }
  /// The height of the origin below the runner-up.
  [[gnu::always_inline]] S next_height() const {
    const S root = sqrt(abs(next) / next_length);
    return select(next < S(0), -root, root);
  }

  /// The square of the shortest edge taken here. A pair alone leaves edges to the walk whose squares are below 1e-36,
  /// near the least float (`edge_axes.kernel.cpp`); ten times that length is clear of it, whatever rounding does.
  static constexpr double least_squared_edge = 1e-34;
};

template <class S, std::size_t N>
[[gnu::always_inline]] inline LaneLeastEdge<S> least_edge(const LanePolygons<S, N>& pair) {
  LaneLeastEdge<S> out;
  const auto &a = pair.a, &b = pair.b;
  const S one(1);
  for (std::size_t i = 0; i < N; ++i) {
    const Vec2<S> e = a.edge[i];
    S lowest = cross(b.vertex[0], e);
    for (std::size_t j = 1; j < N; ++j) lowest = least(lowest, cross(b.vertex[j], e));
    out.offer(cross(a.vertex[i], e) - lowest, e, a.vertex[i], (S(double(i)) < a.count) & (a.count > one), i);
  }
  for (std::size_t j = 0; j < N; ++j) {
    const Vec2<S> e = b.edge[j];
    S most = cross(a.vertex[0], e);
    for (std::size_t i = 1; i < N; ++i) most = greatest(most, cross(a.vertex[i], e));
    out.offer(most - cross(b.vertex[j], e), e, b.vertex[j], (S(double(j)) < b.count) & (b.count > one),
              lane_vertices + j);
  }
  return out;
}

/// The other polygon's vertex that lies deepest below an edge; one of several that are equally deep up to rounding.
template <class S>
struct LaneDeepest {
  S number = S(0), reach, next = S(std::numeric_limits<double>::infinity());
  Vec2<S> vertex;

  template <std::size_t N>
  [[gnu::always_inline]] LaneDeepest(const LanePolygons<S, N>& pair, const decltype(S(0) < S(0))& of_a,
                                     const Vec2<S>& e, const S& count) {
    // Below an edge of -B the vertices of A are those of -A.
    const auto at = [&](std::size_t k) __attribute__((always_inline)) {
      return select(of_a, pair.b.vertex[k], -pair.a.vertex[k]);
    };
    vertex = at(0);
    reach = cross(vertex, e);
    for (std::size_t k = 1; k < N; ++k) {
      const Vec2<S> v = at(k);
      const S across = cross(v, e);
      const auto there = S(double(k)) < count, lower = there & (across < reach);
      next = select(lower, reach, select(there & (across < next), across, next));
      reach = select(lower, across, reach);
      vertex = select(lower, v, vertex);
      number = select(lower, S(double(k)), number);
    }
  }
};

/// Moves to the vertex at which the walk comes to an edge: of two that are equally deep up to rounding the order of
/// directions picks one, with an edge of A before one of B of the same direction. Lanes that are more than a step off
/// are not known.
template <class S, std::size_t N>
[[gnu::always_inline]] inline void settle_deepest(const LanePolygons<S, N>& pair, const decltype(S(0) < S(0))& of_a,
                                                  const Vec2<S>& e, const S& count, LaneDeepest<S>& deepest,
                                                  decltype(S(0) < S(0))& known) {
  const auto next = [&](const S& at) __attribute__((always_inline)) {
    return select(at + S(1) == count, S(0), at + S(1));
  };
  const auto previous = [&](const S& at) __attribute__((always_inline)) {
    return select(at == S(0), count - S(1), at - S(1));
  };
  const auto edge_at = [&](const S& at) __attribute__((always_inline)) {
    return select(of_a, pair.b.at(pair.b.edge, at), pair.a.at(pair.a.edge, at));
  };
  const auto is_back = [&](const S& at) __attribute__((always_inline)) {
    const Vec2<S> before = edge_at(previous(at));
    const S turn = cross(e, before);
    return (count > S(1)) & ((turn > S(0)) | (of_a & (turn == S(0)) & (dot(e, before) > S(0))));
  };
  const auto is_forward = [&](const S& at) __attribute__((always_inline)) {
    const Vec2<S> after = edge_at(at);
    const S turn = cross(e, after);
    return (count > S(1)) & ((turn < S(0)) | ((turn == S(0)) & (dot(e, after) > S(0)) & !of_a));
  };
  S& here = deepest.number;
  const auto back = is_back(here), forward = is_forward(here);
  if (!any(back | forward)) return;
  here = select(back, previous(here), select(forward, next(here), here));
  known = known & !is_back(here) & !is_forward(here);
  deepest.vertex = select(of_a, pair.b.at(pair.b.vertex, here), -pair.a.at(pair.a.vertex, here));
}

/// The edge of the difference at the vertex at which the walk comes to it.
template <class S, std::size_t N>
[[gnu::always_inline]] inline LaneEdge<S> placed_edge(const LanePolygons<S, N>& pair, const LaneLeastEdge<S>& least,
                                                      decltype(S(0) < S(0))& known) {
  const auto of_a = least.number < S(double(lane_vertices));
  const S own = select(of_a, least.number, least.number - S(double(lane_vertices)));
  const S count = select(of_a, pair.b.count, pair.a.count);
  LaneDeepest<S> deepest(pair, of_a, least.edge, count);
  const S rounding = S(16 * std::numeric_limits<double>::epsilon()) * pair.size * max_abs(least.edge);
  if (any(known & !(deepest.next > deepest.reach + rounding)))
    settle_deepest(pair, of_a, least.edge, count, deepest, known);
  const Vec2<S> start = select(of_a, least.vertex - deepest.vertex, -deepest.vertex - least.vertex);
  return {of_a, select(of_a, own, deepest.number), select(of_a, deepest.number, own), start, least.edge};
}

template <class S>
[[gnu::always_inline]] inline Vec2<S> lane_point_between(const Vec2<S>& start, const Vec2<S>& end, const Vec2<S>& edge,
                                                         const S& t) {
  return select(t <= S(0.5), start + edge * t, end - edge * (S(1) - t));
}

/// An edge and its point nearest to the origin, lane by lane like `NearestEdge`.
template <class S>
struct LaneNearestEdge {
  using Mask = decltype(S(0) < S(0));
  LaneEdge<S> edge;
  S parameter, squared;
  Vec2<S> point;

  [[gnu::always_inline]] explicit LaneNearestEdge(const LaneEdge<S>& e) : edge(e) {
    parameter = clamp(-dot(e.start, e.edge) / length_squared(e.edge), S(0), S(1));
    point = lane_point_between(e.start, e.start + e.edge, e.edge, parameter);
    squared = length_squared(point);
  }
  [[gnu::always_inline]] Mask inner() const { return (parameter > S(0)) & (parameter < S(1)); }
  [[gnu::always_inline]] Mask nearer(const LaneNearestEdge& than) const {
    const S wide(1 + same_square);
    const Mask same = (squared <= than.squared * wide) & (than.squared <= squared * wide), in = inner(),
               other = than.inner(), differ = (in & !other) | (other & !in);
    return select(same & differ, in, squared < than.squared);
  }
};
template <class M, class S>
[[gnu::always_inline]] inline LaneNearestEdge<S> select(const M& condition, const LaneNearestEdge<S>& yes,
                                                        const LaneNearestEdge<S>& no) {
  LaneNearestEdge<S> out = no;
  out.edge = select(condition, yes.edge, no.edge);
  out.parameter = select(condition, yes.parameter, no.parameter);
  out.squared = select(condition, yes.squared, no.squared);
  out.point = select(condition, yes.point, no.point);
  return out;
}

/// Whether the walk comes to an edge earlier than to another one.
template <class S>
[[gnu::always_inline]] inline auto lane_earlier(const LaneEdge<S>& e, const LaneEdge<S>& than) {
  const auto lower = [](const Vec2<S>& d) __attribute__((always_inline)) {
    return (d.y < S(0)) | ((d.y == S(0)) & (d.x < S(0)));
  };
  const auto not_after = [&](const Vec2<S>& u, const Vec2<S>& v) __attribute__((always_inline)) {
    const auto u_lower = lower(u), v_lower = lower(v);
    return select((u_lower & !v_lower) | (v_lower & !u_lower), v_lower, cross(u, v) >= S(0));
  };
  return select(e.of_a, not_after(e.edge, than.edge), !not_after(than.edge, e.edge));
}

/// The part of an edge at its ends that `nearest_axes.cpp` calls `beside_end`, to go on at the same edges.
inline constexpr double lane_beside_end = 0x1p-20;

/// The nearest point of the edges that the origin sees, along the outline from the edge whose line is furthest away.
template <class S, std::size_t N>
[[gnu::always_inline]] inline LaneNearestEdge<S>
lane_nearest_seen(const LanePolygons<S, N>& pair, const LaneEdge<S>& from, const decltype(S(0) < S(0))& outside,
                  decltype(S(0) < S(0))& known) {
  const auto &a = pair.a, &b = pair.b;
  LaneNearestEdge<S> best(from);
  const S low(lane_beside_end), high(1 - lane_beside_end);
  const auto forward = best.parameter >= high;
  auto active = outside & known & (forward | (best.parameter <= low));
  LaneEdge<S> at = from;
  for (std::size_t step = 0; any(active); ++step) {
    if (step == 2 * lane_vertices) {
      known = known & !active;
      break;
    }
    const S i = select(forward, select(at.of_a, a.next(at.i), at.i), a.previous(at.i)),
            j = select(forward, select(at.of_a, at.j, b.next(at.j)), b.previous(at.j));
    const Vec2<S> edge_a = a.at(a.edge, i), edge_b = b.at(b.edge, j);
    const S turn = cross(edge_a, edge_b), same = dot(edge_a, edge_b);
    const auto single_a = a.count < S(2), single_b = b.count < S(2);
    const auto first = select(single_a | single_b, single_b, (turn > S(0)) | ((turn == S(0)) & (same > S(0))));
    known = known & !(active & !single_a & !single_b & (turn == S(0)) & !(same > S(0)));
    const auto of_a = select(forward, first, single_b | !(single_a | first));
    const LaneEdge<S> next = pair.made(of_a, select(forward | of_a, i, at.i), select(forward | !of_a, j, at.j),
                                       select(of_a, edge_a, edge_b));
    active = active & (cross(next.start, next.edge) < S(0));
    const LaneNearestEdge<S> offered(next);
    const auto taken = active & (offered.nearer(best) | (lane_earlier(next, best.edge) & !best.nearer(offered)));
    best = select(taken, offered, best);
    at = next;
    active = active & !select(forward, offered.parameter<high, offered.parameter> low);
  }
  return best;
}

/// The points of A and B at a parameter of an edge, and their features.
template <class S, std::size_t N>
[[gnu::always_inline]] inline void take_lane_points(const LanePolygons<S, N>& pair, const LaneEdge<S>& e, const S& t,
                                                    LanePolygonNearest<S>& out) {
  const auto &a = pair.a, &b = pair.b;
  const S from = select(e.of_a, e.i, e.j), end = select(e.of_a, a.next(e.i), b.next(e.j));
  const Vec2<S> on_a = a.at(a.own, e.i), on_b = b.at(b.own, e.j);
  const Vec2<S> p = select(e.of_a, on_a, on_b), q = select(e.of_a, a.at(a.own, end), b.at(b.own, end));
  const Vec2<S> on_edge = lane_point_between(p, q, q - p, t), other = select(e.of_a, on_b, on_a);
  const S zero(0), one(1);
  const S near = select(t >= one, end, from);
  const S feature = select((t > zero) & (t < one), side_number(from), vertex_number(near));
  out.points.a = select(e.of_a, on_edge, other);
  out.points.b = transform(pair.b_in_a, select(e.of_a, other, on_edge));
  out.points.feature_a = select(e.of_a, feature, vertex_number(e.i));
  out.points.feature_b = select(e.of_a, vertex_number(e.j), feature);
  out.near_a = select(e.of_a, near, e.i);
  out.near_b = select(e.of_a, e.j, near);
}

template <class S, std::size_t N>
[[gnu::always_inline]] inline LanePolygonNearest<S> nearest_lanes(const LanePolygons<S, N>& pair) {
  LanePolygonNearest<S> out;
  const LaneLeastEdge<S> least = least_edge(pair);
  out.known = pair.known & least.regular;
  const LaneEdge<S> edge = placed_edge(pair, least, out.known);
  const S height = cross(edge.start, edge.edge) / length(edge.edge);
  // A height can be computed in two ways, both products of sizes: some eight operations, each half a unit off.
  const S slack = S(64 * std::numeric_limits<double>::epsilon()) * pair.size;
  out.known = out.known & (least.next_height() > height + slack);
  const auto outside = height < S(0);
  const LaneNearestEdge<S> seen = lane_nearest_seen(pair, edge, outside, out.known);
  const LaneEdge<S> e = seen.edge;
  const Vec2<S> right_of = right(e.edge), outward = right_of / sqrt(length_squared(right_of));
  const auto inner = seen.inner();
  // Inside a polygon the foot on the nearest edge's line lies on that edge, or on one in line with it.
  out.known = out.known & (outside | (seen.squared <= S(4) * height * height));
  const S sizes =
      max_abs(pair.a.at(pair.a.own, e.i)) + max_abs(pair.b.at(pair.b.own, e.j)) + max_abs(pair.b_in_a.translation);
  const auto touches = seen.squared <= S(touching_rounding * touching_rounding) * (sizes * sizes);
  const auto by_edge = inner | touches | !outside;
  const S far = sqrt(seen.squared);
  out.points.normal = select(by_edge, outward, -seen.point / far);
  out.points.distance = select(outside, select(inner, greatest(-dot(seen.point, outward), S(0)), far), -height);
  take_lane_points(pair, e, seen.parameter, out);
  return out;
}

}  // namespace graze::plane
