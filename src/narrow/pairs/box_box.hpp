// Box against box by fifteen separating axes: three of A, three of B, and the nine products of their edges (Gottschalk,
// Lin, Manocha 1996, "OBBTree: a hierarchical structure for rapid interference detection", section 5; the radii as in
// Eberly's table, "Dynamic collision detection using oriented bounding boxes", 2002).
//
// Guarantee: `separation` along each axis is that of the boxes' intervals: the largest of the fifteen is a lower bound
// of the distance, and of overlapping boxes exactly minus the depth. An edge axis of two edges that are parallel up to
// rounding is no axis: the face axes answer then, and nothing is divided by a vanishing length.
#pragma once

#include <limits>

#include "graze/mat3.hpp"
#include "graze/wide.hpp"
#include "narrow/core.hpp"

namespace graze {

/// Two boxes in the frame of A. `rotation`'s columns are B's axes.
template <class S>
struct BoxPair {
  Vec3<S> half_a, half_b, translation;
  Mat3<S> rotation;
};

/// An axis with its number: 0..2 are A's, 3..5 B's, 6 + 3 i + j the product of A's i-th and B's j-th.
template <class S>
struct BoxAxis {
  S separation;
  Vec3<S> normal;  ///< unit, from A to B, in the frame of A
  S number;
};

/// The best of each kind. `face_a` and `face_b` always exist; `edge.separation` is minus infinity without an edge axis.
template <class S>
struct BoxAxes {
  BoxAxis<S> face_a, face_b, edge;
};

/// The squared sine below which two edges count as parallel: their product's direction would be rounding.
template <class S>
inline constexpr typename LaneOf<S>::type parallel_edges = 4096 * epsilon<S>* epsilon<S>;

namespace detail {

/// Keeps the axis of larger separation; of equal ones the first.
template <class S, class M>
void keep_better(BoxAxis<S>& best, const M& valid, const S& separation, const Vec3<S>& normal, int number) {
  const auto better = valid & (separation > best.separation);
  best.separation = select(better, separation, best.separation);
  best.normal = select(better, normal, best.normal);
  best.number = select(better, S(static_cast<typename LaneOf<S>::type>(number)), best.number);
}

template <class S>
Vec3<S> unit_axis(std::size_t i) {
  Vec3<S> e{S(0), S(0), S(0)};
  e[i] = S(1);
  return e;
}

template <class S>
BoxAxis<S> no_axis() {
  return {S(-std::numeric_limits<typename LaneOf<S>::type>::infinity()), Vec3<S>{S(0), S(0), S(0)}, S(0)};
}

}  // namespace detail

/// A's three axes. They need one row of the rotation each.
template <class S>
BoxAxis<S> box_axes_of_a(const BoxPair<S>& p) {
  using std::abs;
  BoxAxis<S> best = detail::no_axis<S>();
  for (std::size_t i = 0; i < 3; ++i) {
    const S t = p.translation[i], r = p.half_a[i] + dot(graze::abs(p.rotation.row[i]), p.half_b);
    const Vec3<S> e = detail::unit_axis<S>(i);
    detail::keep_better(best, t == t, abs(t) - r, select(t < S(0), -e, e), static_cast<int>(i));
  }
  return best;
}

/// B's three axes, with the absolute rotation that the edges need too.
template <class S>
BoxAxis<S> box_axes_of_b(const BoxPair<S>& p, const Mat3<S>& absolute) {
  using std::abs;
  BoxAxis<S> best = detail::no_axis<S>();
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3<S> axis = p.rotation.column(j);
    const S t = dot(p.translation, axis), r = p.half_b[j] + dot(absolute.column(j), p.half_a);
    detail::keep_better(best, t == t, abs(t) - r, select(t < S(0), -axis, axis), static_cast<int>(3 + j));
  }
  return best;
}

/// The product of A's i-th and B's j-th axis. A's axis is a unit vector of the frame, so one component is zero and the
/// others are entries of the rotation; with them so are the projections of the other axes.
template <class S>
void box_edge_axis(const BoxPair<S>& p, const Mat3<S>& absolute, std::size_t i, std::size_t j, BoxAxis<S>& best) {
  using std::abs, std::sqrt;
  const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
  const S x = p.rotation.row[i1][j], y = p.rotation.row[i2][j];  // e_i x b_j = -y e_i1 + x e_i2
  const S squared = x * x + y * y;
  const auto distinct = squared > S(parallel_edges<S>);
  const S scale = S(1) / sqrt(select(distinct, squared, S(1)));
  const S t = p.translation[i2] * x - p.translation[i1] * y;
  const S r = p.half_a[i1] * absolute.row[i2][j] + p.half_a[i2] * absolute.row[i1][j] +
              p.half_b[j1] * absolute.row[i][j2] + p.half_b[j2] * absolute.row[i][j1];
  const S toward = select(t < S(0), -scale, scale);
  Vec3<S> normal{S(0), S(0), S(0)};
  normal[i1] = -y * toward;
  normal[i2] = x * toward;
  detail::keep_better(best, distinct, (abs(t) - r) * scale, normal, static_cast<int>(6 + 3 * i + j));
}

/// All fifteen axes.
template <class S>
BoxAxes<S> box_axes(const BoxPair<S>& p) {
  const Mat3<S> absolute = abs(p.rotation);
  BoxAxes<S> axes{box_axes_of_a(p), box_axes_of_b(p, absolute), detail::no_axis<S>()};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) box_edge_axis(p, absolute, i, j, axes.edge);
  return axes;
}

/// The largest separation along A's, then B's axes, then those of the edges, and no further than to the first kind
/// that keeps all lanes' boxes more than `enough` apart: a lower bound of the distance. With `faces_only` the nine edge
/// axes are left out: it is then too small for some pairs, never too large.
template <class S>
S box_separation(const BoxPair<S>& p, const S& enough, bool faces_only = false) {
  S most = box_axes_of_a(p).separation;
  if (all(most > enough)) return most;
  const Mat3<S> absolute = abs(p.rotation);
  most = greatest(most, box_axes_of_b(p, absolute).separation);
  if (faces_only || all(most > enough)) return most;
  BoxAxis<S> edge = detail::no_axis<S>();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) box_edge_axis(p, absolute, i, j, edge);
    if (all(greatest(most, edge.separation) > enough)) break;
  }
  return greatest(most, edge.separation);
}

}  // namespace graze
