// Two polygons of few vertices in A's frame, one pair a lane, and the edges of their Minkowski difference A - B.
//
// Guarantee: vertices and edges have the bits that `DifferenceOutline` gives them.
#pragma once

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

template <class S, std::size_t N>
struct LanePolygons {
  using Mask = decltype(S(0) < S(0));
  LaneVertices<S, N> a, b;
  Pose2<S> pose_a, b_in_a;
  S radius_a, radius_b;
  S size;  ///< of coordinates, which roundings refer to
  Mask known;

  [[gnu::always_inline]] LanePolygons(const PolygonBlock& block, std::size_t first) {
    const auto pose = [&](const PolygonColumns& c) __attribute__((always_inline)) {
      return Pose2<S>{{S::load(c.pose[0] + first), S::load(c.pose[1] + first)},
                      {S::load(c.pose[2] + first), S::load(c.pose[3] + first)}};
    };
    const auto unit = [&](const Pose2<S>& p) __attribute__((always_inline)) {
      const Rot2<S> q = p.rotation;
      const S excess = q.cosine * q.cosine + q.sine * q.sine - S(1);
      known = known & (abs(excess) <= S(nearly_unit));
      const S scale = S(1) - excess * (S(0.5) - S(0.375) * excess);
      return Pose2<S>{p.translation, {q.cosine * scale, q.sine * scale}};
    };
    known = S(0) < S(1);
    pose_a = unit(pose(block.a));
    b_in_a = relative(pose_a, unit(pose(block.b)));
    radius_a = S::load(block.a.radius + first), radius_b = S::load(block.b.radius + first);
    size = max_abs(b_in_a.translation);
    load(block.a, first, a);
    load(block.b, first, b);
    for (std::size_t k = 0; k < N; ++k) {
      const std::size_t after = k + 1 == N ? 0 : k + 1;
      a.vertex[k] = a.own[k];
      a.edge[k] = a.own[after] - a.own[k];
      b.vertex[k] = transform(b_in_a, b.own[k]);
      b.edge[k] = rotate(b_in_a.rotation, -(b.own[after] - b.own[k]));
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

  [[gnu::always_inline]] void load(const PolygonColumns& from, std::size_t first, LaneVertices<S, N>& to) {
    to.count = S::load(from.count + first);
    for (std::size_t k = 0; k < N; ++k) to.own[k] = {S::load(from.x[k] + first), S::load(from.y[k] + first)};
    S reach = max_abs(to.own[0]);
    for (std::size_t k = 1; k < N; ++k) reach = greatest(reach, max_abs(to.own[k]));
    size += reach;
  }
};

}  // namespace graze::plane
