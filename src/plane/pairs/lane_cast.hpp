// The first contact of two polygons, rounded or not, of which one moves along a line, one pair a lane: the ray of
// `straight_contact.hpp` against their Minkowski difference.
//
// Guarantee: a known answer has the bits of the walk around the difference. The edge or vertex that the ray meets is
// proven to be the only one within rounding: nothing of the difference lies beyond its line, and the hit is far from
// its ends. Lanes without that proof, those that may touch at the start among them, are not known.
#pragma once

#include <limits>

#include "plane/pairs/lane_polygons.hpp"

namespace graze::plane {

/// Room for rounding, relative to sizes and the way between the shapes. Heights of a few products are some 2^-50 off.
/// A ray this far beside an edge's line does not run along the edge: where it crosses the line is known to 2^-26 too.
inline constexpr double beside_margin = 0x1p-26;
/// Shapes further apart than this at the start are far from touching by `touching_rounding` (`plane/nearest.hpp`).
inline constexpr double apart_margin = 0x1p-40;
/// The least distance of a hit from the ends of its edge or arc: where the ray crosses a line is known to
/// `beside_margin` of the sizes, and 2^7 of that leaves room for rays that run almost along an edge.
inline constexpr double lane_end_margin = 0x1p-19;

/// The first contact of a pair in A's frame: the way to it along the unit direction, infinite where there is none.
template <class S>
struct LaneContact {
  decltype(S(0) < S(0)) known;
  S way;
  Vec2<S> normal, point;  ///< unit, from A to B; on A's surface
};

/// The sides of the ray on which the vertices of the difference lie.
template <class S, std::size_t N, std::size_t M>
struct LaneSides {
  using Mask = decltype(S(0) < S(0));
  Mask passes, crosses;  ///< whether the rounded difference surely lies beside the ray's line, or on both sides of it

  [[gnu::always_inline]] LaneSides(const LanePolygons<S, N, M>& pair, const Vec2<S>& direction, const S& radius,
                                   const S& margin) {
    S low_a = cross(direction, pair.a.vertex[0]), high_a = low_a;
    for (std::size_t i = 1; i < N; ++i) {
      const S beside = cross(direction, pair.a.vertex[i]);
      low_a = least(low_a, beside);
      high_a = greatest(high_a, beside);
    }
    S low_b = cross(direction, pair.b.vertex[0]), high_b = low_b;
    for (std::size_t j = 1; j < M; ++j) {
      const S beside = cross(direction, pair.b.vertex[j]);
      low_b = least(low_b, beside);
      high_b = greatest(high_b, beside);
    }
    const S low = low_a - high_b, high = high_a - low_b, beyond = radius + margin, within = radius - margin;
    passes = (low > beyond) | (high < -beyond);
    crosses = (low < within) & (high > -within);
  }
};

/// The line of a moved edge that the ray enters last (Cyrus and Beck 1978), found without divisions: times are kept as
/// fractions.
template <class S>
struct LaneEntry {
  using Mask = decltype(S(0) < S(0));
  S above = S(-1), toward = S(0);  ///< height and descent of the ray, times the edge's length
  Vec2<S> edge{}, from{}, to{};    ///< that edge, and the ends of it in its own polygon
  Mask of_a = S(1) < S(0);
  Mask leaves = S(1) < S(0);  ///< whether the ray begins above an edge's line and does not come nearer to it

  [[gnu::always_inline]] void offer(const S& height, const Vec2<S>& e, const Vec2<S>& direction, const S& clear,
                                    const Vec2<S>& start, const Vec2<S>& end, const Mask& is_of_a) {
    const S descent = cross(e, direction);
    leaves = leaves | ((descent <= S(0)) & (height > clear));
    const Mask later = (descent > S(0)) & (height * toward > above * descent);
    above = select(later, height, above);
    toward = select(later, descent, toward);
    edge = select(later, e, edge);
    from = select(later, start, from);
    to = select(later, end, to);
    of_a = select(later, is_of_a, of_a);
  }
};

template <class S, std::size_t N, std::size_t M>
[[gnu::always_inline]] inline LaneEntry<S> last_entry(const LanePolygons<S, N, M>& pair, const Vec2<S>& direction,
                                                      const S& radius, const S& clear) {
  LaneEntry<S> out;
  const auto& a = pair.a;
  const auto& b = pair.b;
  const bool rounded = any(radius > S(0));
  const auto moved = [&](const S& height, const Vec2<S>& e) __attribute__((always_inline)) {
    return rounded ? height - radius * sqrt(length_squared(e)) : height;
  };
  if constexpr (N > 1)
    for (std::size_t i = 0; i < N; ++i) {
      const Vec2<S> e = a.edge[i];
      S lowest = cross(b.vertex[0], e);
      for (std::size_t j = 1; j < M; ++j) lowest = least(lowest, cross(b.vertex[j], e));
      out.offer(moved(lowest - cross(a.vertex[i], e), e), e, direction, clear, a.vertex[i],
                a.vertex[i + 1 == N ? 0 : i + 1], S(0) < S(1));
    }
  if constexpr (M > 1)
    for (std::size_t j = 0; j < M; ++j) {
      const Vec2<S> e = b.edge[j];
      S most = cross(a.vertex[0], e);
      for (std::size_t i = 1; i < N; ++i) most = greatest(most, cross(a.vertex[i], e));
      out.offer(moved(cross(b.vertex[j], e) - most, e), e, direction, clear, b.vertex[j],
                b.vertex[j + 1 == M ? 0 : j + 1], S(1) < S(0));
    }
  return out;
}

/// An edge of the difference: an edge of one polygon, swept by a vertex of the other.
template <class S>
struct LaneSwept {
  using Mask = decltype(S(0) < S(0));
  Mask of_a, known;
  Vec2<S> edge, from, to, vertex;
  /// Whether an edge of the other polygon in the same direction comes before it or behind it.
  Mask follows = S(1) < S(0), is_followed = S(1) < S(0);
  Vec2<S> other_edge{}, other_from{}, other_to{};
  /// Whether the difference of the two is a segment, of which the back side has a vertex between these edges too.
  Mask flat = S(1) < S(0);

  [[gnu::always_inline]] LaneSwept(const LaneEntry<S>& entry)
      : of_a(entry.of_a), known(entry.toward > S(0)), edge(entry.edge), from(entry.from), to(entry.to) {}

  /// The vertices of A and B where it begins, and where it ends.
  [[gnu::always_inline]] Vec2<S> first_a() const { return select(of_a, from, vertex); }
  [[gnu::always_inline]] Vec2<S> first_b() const { return select(of_a, vertex, from); }
  [[gnu::always_inline]] Vec2<S> last_a() const { return select(of_a, to, vertex); }
  [[gnu::always_inline]] Vec2<S> last_b() const { return select(of_a, vertex, to); }

  /// Finds the vertex of the other polygon that lies deepest below the edge: of two, the ends of an edge in the same
  /// direction, the one at which the walk comes to it. Not known where more are as deep.
  template <std::size_t N, std::size_t M>
  [[gnu::always_inline]] void find_vertex(const LanePolygons<S, N, M>& pair, const S& rounding) {
    if constexpr (M == 1)
      vertex = pair.b.vertex[0];
    else if constexpr (N == 1)
      vertex = pair.a.vertex[0];
    else
      find_deepest(pair, rounding);
  }
  /// Moves on to the edge in the same direction where that is wanted.
  [[gnu::always_inline]] void step(const Mask& wanted) {
    vertex = select(wanted, select(is_followed, to, from), vertex);
    const Vec2<S> was = edge;
    edge = select(wanted, other_edge, edge);
    other_edge = select(wanted, was, other_edge);
    from = select(wanted, other_from, from);
    to = select(wanted, other_to, to);
    of_a = select(wanted, !of_a, of_a);
    const Mask was_followed = is_followed;
    is_followed = select(wanted, follows, is_followed);
    follows = select(wanted, was_followed, follows);
  }
  /// Whether a place along the edge is further than `margin` from the vertex on the back side of a flat difference,
  /// which stands at the length of the second of the two edges.
  [[gnu::always_inline]] Mask clear_of_back(const S& at, const S& length, const S& margin) const {
    const S other = plane::length(other_edge);
    const Mask solid = !flat;
    return solid | (abs(at - select(is_followed, other, length - other)) > margin);
  }

 private:
  /// The k-th vertex of the other polygon, or its edge, where both have that many.
  template <std::size_t N, std::size_t M>
  [[gnu::always_inline]] Vec2<S> other(const Vec2<S> (&of_other_a)[N], const Vec2<S> (&of_other_b)[M],
                                       std::size_t k) const {
    return select(of_a, of_other_b[k < M ? k : 0], of_other_a[k < N ? k : 0]);
  }
  template <std::size_t N, std::size_t M>
  [[gnu::always_inline]] void find_deepest(const LanePolygons<S, N, M>& pair, const S& rounding) {
    const S sign = select(of_a, S(1), S(-1)), count = select(of_a, pair.b.count, pair.a.count);
    constexpr std::size_t most = N > M ? N : M;
    vertex = other(pair.a.vertex, pair.b.vertex, 0);
    S lowest = cross(vertex, edge) * sign, next(std::numeric_limits<double>::infinity());
    for (std::size_t k = 1; k < most; ++k) {
      const Vec2<S> v = other(pair.a.vertex, pair.b.vertex, k);
      const S height = cross(v, edge) * sign;
      const Mask there = S(double(k)) < count, lower = there & (height < lowest);
      next = select(lower, lowest, select(there, least(next, height), next));
      lowest = select(lower, height, lowest);
      vertex = select(lower, v, vertex);
    }
    const S limit = lowest + rounding * max_abs(edge);
    const Mask one = next > limit;
    if (any(known & !one)) settle(pair, lowest, limit, one);
  }
  template <std::size_t N, std::size_t M>
  [[gnu::always_inline]] void settle(const LanePolygons<S, N, M>& pair, const S& lowest, const S& limit,
                                     const Mask& one) {
    const S sign = select(of_a, S(1), S(-1)), count = select(of_a, pair.b.count, pair.a.count);
    const S infinite(std::numeric_limits<double>::infinity());
    S high = -infinite, low = infinite, deep(0);
    Vec2<S> high_vertex{}, high_edge{}, low_vertex{}, low_edge{};
    for (std::size_t k = 0; k < (N > M ? N : M); ++k) {
      const Vec2<S> v = other(pair.a.vertex, pair.b.vertex, k), e = other(pair.a.edge, pair.b.edge, k);
      const Mask near = (S(double(k)) < count) & (cross(v, edge) * sign <= limit);
      const S along = dot(v, edge);
      const Mask higher = near & (along > high), lower = near & (along < low);
      high = select(higher, along, high);
      high_vertex = select(higher, v, high_vertex);
      high_edge = select(higher, e, high_edge);
      low = select(lower, along, low);
      low_vertex = select(lower, v, low_vertex);
      low_edge = select(lower, e, low_edge);
      deep = select(near, deep + S(1), deep);
    }
    // Vertices of A lie along the outline as they do along the edge, those of B the other way round.
    other_edge = select(of_a, high_edge, low_edge);
    other_from = select(of_a, high_vertex, low_vertex);
    other_to = select(of_a, low_vertex, high_vertex);
    const S turn = cross(edge, other_edge);
    const Mask two = (deep == S(2)) & (dot(edge, other_edge) > S(0)),
               a_first = (turn == S(0)) | ((turn > S(0)) & of_a) | ((turn < S(0)) & !of_a);
    follows = two & select(of_a, !a_first, a_first);
    is_followed = two & !follows;
    vertex = select(one, vertex, select(a_first, high_vertex, low_vertex));
    known = known & (one | two);
    flat = two & (deep == count);
    for (std::size_t k = 0; k < (N > M ? N : M); ++k) {
      const Vec2<S> own = select(of_a, pair.a.vertex[k < N ? k : 0], pair.b.vertex[k < M ? k : 0]);
      flat = flat & (abs(cross(own - from, edge)) <= limit - lowest);
    }
  }
};

/// The hit of the ray on an edge of the difference moved outward, in the operations of `meet_edge`.
template <class S>
struct LaneEdgeHit {
  Vec2<S> start, normal;
  S height, way;
  S at, length;  ///< along the edge

  [[gnu::always_inline]] LaneEdgeHit(const LaneSwept<S>& e, const S& radius, const Vec2<S>& direction)
      : start(e.first_a() - e.first_b()), length(plane::length(e.edge)) {
    const Vec2<S> along = e.edge / length;
    normal = right(along);
    const S toward = -dot(normal, direction);
    height = -dot(normal, start) - radius;
    way = height / toward;
    at = dot(direction * way - start, along);
  }
};

/// The hit of the ray on the disc about a vertex of the difference, in the operations of `meet_disc`.
template <class S>
struct LaneDiscHit {
  S way, height;  ///< the latter of the ray's origin above the tangent at the hit
  Vec2<S> normal;

  [[gnu::always_inline]] LaneDiscHit(const Vec2<S>& center, const S& radius, const Vec2<S>& direction) {
    const S along = dot(center, direction), across = cross(direction, center);
    const S under = (radius - across) * (radius + across);
    way = along - sqrt(under);
    const Vec2<S> outward = direction * way - center;
    normal = outward / sqrt(length_squared(outward));
    height = -dot(normal, center) - radius;
  }
};

/// Whether a vertex of a polygon is the only one that lies furthest along a direction, by so much that the edges beside
/// it begin further than `margin` from the arc's point in that direction.
template <class S, std::size_t N>
[[gnu::always_inline]] inline auto surely_furthest(const LaneVertices<S, N>& polygon, const Vec2<S>& vertex,
                                                   const Vec2<S>& radius_vector, const S& margin) {
  auto out = S(0) < S(1);
  if constexpr (N > 1)
    for (std::size_t k = 0; k < N; ++k) {
      const Vec2<S> back = vertex - polygon.vertex[k], sides = abs(back);
      const S no_shorter = sides.x + sides.y;
      out = out & ((dot(radius_vector, back) > margin * no_shorter) | (no_shorter == S(0)));
    }
  return out;
}

/// The first contact while B moves along the unit vector `direction` in A's frame.
template <class S, std::size_t N, std::size_t M>
[[gnu::always_inline]] inline LaneContact<S> straight_contact_in_lanes(const LanePolygons<S, N, M>& pair,
                                                                       const Vec2<S>& direction) {
  const S infinite(std::numeric_limits<double>::infinity()), zero(0);
  const S radius = pair.radius_a + pair.radius_b, scale = pair.size + radius;
  const S least_height = S(apart_margin) * scale;
  const LaneSides<S, N, M> sides(pair, direction, radius, S(beside_margin) * scale);
  auto missed = sides.passes;
  LaneContact<S> out;
  out.known = missed;
  const auto take_disc = [&](const Vec2<S>& on_a, const Vec2<S>& on_b, const auto& wanted)
      __attribute__((always_inline)) {
    const LaneDiscHit<S> disc(on_a - on_b, radius, direction);
    const S margin = S(lane_end_margin) * (abs(disc.way) + scale);
    const Vec2<S> outward = disc.normal * radius;
    const auto hit = wanted & (radius > S(beside_margin) * scale) & (disc.height > least_height) &
                     surely_furthest(pair.a, on_a, outward, margin) & surely_furthest(pair.b, on_b, -outward, margin);
    out.known = out.known | hit;
    out.way = select(hit, disc.way, out.way);
    out.normal = select(hit, disc.normal, out.normal);
    out.point = select(hit, on_a, out.point);
  };
  if constexpr (N == 1 && M == 1) {
    const Vec2<S> center = pair.a.vertex[0] - pair.b.vertex[0];
    const S along = dot(center, direction), reach = radius + least_height;
    missed = missed | ((along < zero) & (length_squared(center) * S(1 - apart_margin) > reach * reach));
    out.known = missed;
    out.way = infinite;
    take_disc(pair.a.vertex[0], pair.b.vertex[0], sides.crosses & !missed & (along > zero));
  } else {
    // Heights are times the length of an edge, which is at most four sizes.
    const LaneEntry<S> entry = last_entry(pair, direction, radius, least_height * scale * S(4));
    missed = missed | entry.leaves;
    LaneSwept<S> e(entry);
    e.find_vertex(pair, S(apart_margin) * scale);
    LaneEdgeHit<S> hit(e, radius, direction);
    const auto margin = [&]() __attribute__((always_inline)) { return S(lane_end_margin) * (abs(hit.way) + scale); };
    const auto off = e.known & ((e.is_followed & (hit.at > hit.length)) | (e.follows & (hit.at < zero)));
    if (any(off)) {
      e.step(off);
      hit = LaneEdgeHit<S>(e, radius, direction);
    }
    const auto wanted = e.known & sides.crosses & !missed;
    auto clear = wanted;
    if (any(e.flat)) clear = clear & e.clear_of_back(hit.at, hit.length, margin());
    const auto on_edge = clear & (hit.height > least_height) & (hit.at > margin()) & (hit.at < hit.length - margin());
    out.known = missed | on_edge;
    out.way = select(on_edge, hit.way, infinite);
    out.normal = hit.normal;
    const S along = dot(direction * hit.way - hit.start, e.edge) / length_squared(e.edge);
    out.point = select(e.of_a, e.from + e.edge * along, e.vertex);
    const auto before = (hit.at < -margin()), behind = (hit.at > hit.length + margin());
    const auto on_arc = wanted & (radius > zero) & (before | behind);
    if (any(on_arc))
      take_disc(select(before, e.first_a(), e.last_a()), select(before, e.first_b(), e.last_b()), on_arc);
  }
  out.point = out.point + out.normal * pair.radius_a;
  out.known = out.known & pair.known;
  return out;
}

}  // namespace graze::plane
