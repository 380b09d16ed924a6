// Two polygons of few vertices in A's frame, one pair a lane, and the edges of their Minkowski difference A - B.
//
// Guarantee: vertices and edges have the bits that `DifferenceOutline` gives them.
#pragma once

#include <type_traits>

#include "plane/pairs/lane_pair.hpp"
#include "plane/pairs/polygon_kernels.hpp"
#include "plane/unit_rotation.hpp"

namespace graze::plane {

/// The numbers of one polygon of at most N vertices, gone along.
template <class S, std::size_t N>
struct LaneVertices {
  Vec2<S> own[N];     ///< in its own frame
  Vec2<S> vertex[N];  ///< in A's frame
  Vec2<S> edge[N];    ///< to the next vertex, in A's frame; of B those of -B
  S count;

  [[gnu::always_inline]] S next(const S& i) const { return select(i + S(1) == count, S(0), i + S(1)); }
  [[gnu::always_inline]] S previous(const S& i) const { return select(i == S(0), count - S(1), i - S(1)); }
  /// The vectors at places that differ from lane to lane.
  [[gnu::always_inline]] Vec2<S> at(const Vec2<S> (&all)[N], const S& i) const {
    Vec2<S> out = all[0];
    for (std::size_t k = 1; k < N; ++k) out = select(i == S(double(k)), all[k], out);
    return out;
  }
};

/// An edge of the difference, lane by lane like `DifferenceEdge`.
template <class S>
struct LaneEdge {
  using Mask = decltype(S(0) < S(0));
  Mask of_a;
  S i, j;
  Vec2<S> start, edge;
};
template <class M, class S>
[[gnu::always_inline]] inline LaneEdge<S> select(const M& condition, const LaneEdge<S>& yes, const LaneEdge<S>& no) {
  return {select(condition, yes.of_a, no.of_a), select(condition, yes.i, no.i), select(condition, yes.j, no.j),
          select(condition, yes.start, no.start), select(condition, yes.edge, no.edge)};
}

/// A polygon in place of at most N vertices, rounded by a radius: its vertices counter-clockwise in its own frame, with
/// the first one again behind the last.
template <class S, std::size_t N>
struct LanePolygon {
  Pose2<S> pose;
  Vec2<S> own[N];
  S count, radius;
};

template <class S, std::size_t N>
[[gnu::always_inline]] inline LanePolygon<S, N> polygon_at(const PolygonColumns& columns, std::size_t first) {
  const auto at = [&](const double* column) __attribute__((always_inline)) { return S::load(column + first); };
  LanePolygon<S, N> out;
  out.pose = {{at(columns.pose[0]), at(columns.pose[1])}, {at(columns.pose[2]), at(columns.pose[3])}};
  for (std::size_t k = 0; k < N; ++k) out.own[k] = {at(columns.x[k]), at(columns.y[k])};
  out.count = at(columns.count);
  out.radius = at(columns.radius);
  return out;
}

/// Two polygons, A with at most N vertices and B with at most M.
template <class S, std::size_t N, std::size_t M = N>
struct LanePolygons {
  using Mask = decltype(S(0) < S(0));
  LaneVertices<S, N> a;
  LaneVertices<S, M> b;
  Pose2<S> pose_a, b_in_a;
  S radius_a, radius_b;
  S size;  ///< of coordinates, which roundings refer to
  Mask known;

  [[gnu::always_inline]] LanePolygons(const PolygonBlock& block, std::size_t first)
      : LanePolygons(polygon_at<S, N>(block.a, first), polygon_at<S, M>(block.b, first)) {}
  [[gnu::always_inline]] LanePolygons(const LanePolygon<S, N>& of_a, const LanePolygon<S, M>& of_b)
      : radius_a(of_a.radius), radius_b(of_b.radius), known(S(0) < S(1)) {
    const auto unit = [&](const Pose2<S>& p) __attribute__((always_inline)) {
      const Rot2<S> q = p.rotation;
      const S excess = q.cosine * q.cosine + q.sine * q.sine - S(1);
      known = known & (abs(excess) <= S(nearly_unit));
      const S scale = S(1) - excess * (S(0.5) - S(0.375) * excess);
      return Pose2<S>{p.translation, {q.cosine * scale, q.sine * scale}};
    };
    pose_a = unit(of_a.pose);
    b_in_a = relative(pose_a, unit(of_b.pose));
    size = max_abs(b_in_a.translation);
    take(of_a, a);
    take(of_b, b);
    for (std::size_t k = 0; k < N; ++k) {
      a.vertex[k] = a.own[k];
      a.edge[k] = a.own[k + 1 == N ? 0 : k + 1] - a.own[k];
    }
    for (std::size_t k = 0; k < M; ++k) {
      b.vertex[k] = transform(b_in_a, b.own[k]);
      b.edge[k] = rotate(b_in_a.rotation, -(b.own[k + 1 == M ? 0 : k + 1] - b.own[k]));
    }
    known = known & (size >= S(least_lane_size)) & (size <= S(most_lane_size));
  }
  /// The edge of the difference at the vertices i and j.
  [[gnu::always_inline]] LaneEdge<S> made(const Mask& of_a, const S& i, const S& j, const Vec2<S>& edge) const {
    return {of_a, i, j, a.at(a.vertex, i) - b.at(b.vertex, j), edge};
  }

 private:
  /// Bounds of sizes whose sixth power, as of the squares of heights times squares of lengths that are compared without
  /// roots, is a normal double with room for edges that are shorter: other pairs are answered one by one.
  static constexpr double least_lane_size = 1e-14, most_lane_size = 1e14;

  template <std::size_t K>
  [[gnu::always_inline]] void take(const LanePolygon<S, K>& from, LaneVertices<S, K>& to) {
    to.count = from.count;
    for (std::size_t k = 0; k < K; ++k) to.own[k] = from.own[k];
    S reach = max_abs(to.own[0]);
    for (std::size_t k = 1; k < K; ++k) reach = greatest(reach, max_abs(to.own[k]));
    size += reach;
  }
};

/// Calls `f` with the least number of vertices that the kernels are written for and no polygon exceeds.
template <class F>
[[gnu::always_inline]] inline void with_vertices(const PolygonBlock& block, const F& f) {
  const std::size_t most = block.a.most > block.b.most ? block.a.most : block.b.most;
  if (most <= 4)
    f(std::integral_constant<std::size_t, 4>());
  else if (most <= 6)
    f(std::integral_constant<std::size_t, 6>());
  else
    f(std::integral_constant<std::size_t, lane_vertices>());
}

}  // namespace graze::plane
