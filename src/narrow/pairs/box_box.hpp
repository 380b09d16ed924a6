// Box against box by fifteen separating axes: three of A, three of B, and the nine products of their edges (Gottschalk,
// Lin, Manocha 1996, "OBBTree: a hierarchical structure for rapid interference detection", section 5; the radii as in
// Eberly's table, "Dynamic collision detection using oriented bounding boxes", 2002).
//
// Guarantee: `separation` along each axis is that of the boxes' intervals: the largest of the fifteen is a lower bound
// of the distance, and of overlapping boxes exactly minus the depth. An edge axis of two edges that are parallel up to
// rounding is no axis: the face axes answer then, and nothing is divided by a vanishing length.
#pragma once

#include <limits>
#include <utility>

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

/// The squared sine below which two edges count as parallel. Their product is an axis of boxes that are turned by a
/// rounding, however small it is, since its projections are taken of its own components; without it the separation is
/// off by the sine times an edge: eight roundings.
template <class S>
inline constexpr typename LaneOf<S>::type parallel_edges = 64 * epsilon<S>* epsilon<S>;

namespace detail {

/// Takes another axis where it is better.
template <class S, class M>
void keep(BoxAxis<S>& best, const M& better, const S& separation, const Vec3<S>& normal, int number) {
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
    const S separation = abs(t) - r;
    detail::keep(best, separation > best.separation, separation, select(t < S(0), -e, e), static_cast<int>(i));
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
    const S separation = abs(t) - r;
    detail::keep(best, separation > best.separation, separation, select(t < S(0), -axis, axis),
                 static_cast<int>(3 + j));
  }
  return best;
}

/// The product of A's i-th and B's j-th axis, e_i x b_j, not of unit length. A's axis is a unit vector of the frame, so
/// one component is zero and the others are entries of the rotation. B's other axes are projected on these components
/// and not read from the rotation as orthogonality would allow (Eberly's table): an entry is off by a rounding of one,
/// and divided by the length of the product of two edges that are nearly parallel that would be seen.
template <class S>
struct BoxEdgeAxis {
  S along_1, along_2;  ///< the components along the two axes of A that follow the i-th
  S middle, reach;     ///< of the centres' distance along it, signed, and of both half extents
  S length_squared() const { return along_1 * along_1 + along_2 * along_2; }
};

template <std::size_t I, std::size_t J, class S>
BoxEdgeAxis<S> box_edge(const BoxPair<S>& p, const Mat3<S>& absolute) {
  using std::abs;
  constexpr std::size_t i1 = (I + 1) % 3, i2 = (I + 2) % 3, j1 = (J + 1) % 3, j2 = (J + 2) % 3;
  const Vec3<S>&r1 = p.rotation.row[i1], &r2 = p.rotation.row[i2];
  const S x = r1[J], y = r2[J];
  const S of_b1 = abs(r2[j1] * x - r1[j1] * y), of_b2 = abs(r2[j2] * x - r1[j2] * y);
  return {-y, x, p.translation[i2] * x - p.translation[i1] * y,
          p.half_a[i1] * absolute.row[i2][J] + p.half_a[i2] * absolute.row[i1][J] + p.half_b[j1] * of_b1 +
              p.half_b[j2] * of_b2};
}

template <std::size_t I, std::size_t J, class S>
void box_edge_axis(const BoxPair<S>& p, const Mat3<S>& absolute, BoxAxis<S>& best) {
  using std::abs, std::sqrt;
  const BoxEdgeAxis<S> edge = box_edge<I, J>(p, absolute);
  const S squared = edge.length_squared();
  const auto distinct = squared > S(parallel_edges<S>);
  const S scale = S(1) / sqrt(select(distinct, squared, S(1)));
  const S toward = select(edge.middle < S(0), -scale, scale);
  Vec3<S> normal{S(0), S(0), S(0)};
  normal[(I + 1) % 3] = edge.along_1 * toward;
  normal[(I + 2) % 3] = edge.along_2 * toward;
  const S separation = (abs(edge.middle) - edge.reach) * scale;
  detail::keep(best, distinct & (separation > best.separation), separation, normal, static_cast<int>(6 + 3 * I + J));
}

/// Calls `f(I, J)`, two constants, for the nine pairs of edges until it says that it knows enough. As constants they
/// leave nothing of the cyclic indices to run time.
template <class F>
bool any_edge_pair(F&& f) {
  return [&]<std::size_t... K>(std::index_sequence<K...>) {
    return (f(std::integral_constant<std::size_t, K / 3>{}, std::integral_constant<std::size_t, K % 3>{}) || ...);
  }
  (std::make_index_sequence<9>{});
}

/// All fifteen axes; without those of edges where faces already keep all lanes' boxes more than `enough` apart.
template <class S>
BoxAxes<S> box_axes(const BoxPair<S>& p, const S& enough) {
  const Mat3<S> absolute = abs(p.rotation);
  BoxAxes<S> axes{box_axes_of_a(p), box_axes_of_b(p, absolute), detail::no_axis<S>()};
  if (all(greatest(axes.face_a.separation, axes.face_b.separation) > enough)) return axes;
  any_edge_pair([&](auto i, auto j) {
    box_edge_axis<i, j>(p, absolute, axes.edge);
    return false;
  });
  return axes;
}

/// Whether some axis shows a gap of more than `enough` >= 0. Each axis is tried only while not all lanes know; the
/// products of edges need neither root nor division for it. With `faces_only` they are left out: of some boxes that are
/// apart it is then not known, of none that touch is it said.
template <class S>
auto boxes_apart(const BoxPair<S>& p, const S& enough, bool faces_only = false) {
  using std::abs;
  auto apart = abs(p.translation.x) - (p.half_a.x + dot(graze::abs(p.rotation.row[0]), p.half_b)) > enough;
  for (std::size_t i = 1; i < 3; ++i) {
    if (all(apart)) return apart;
    const S reach = p.half_a[i] + dot(graze::abs(p.rotation.row[i]), p.half_b);
    apart = apart | (abs(p.translation[i]) - reach > enough);
  }
  const Mat3<S> absolute = abs(p.rotation);
  for (std::size_t j = 0; j < 3; ++j) {
    if (all(apart)) return apart;
    const S reach = p.half_b[j] + dot(absolute.column(j), p.half_a);
    apart = apart | (abs(dot(p.translation, p.rotation.column(j))) - reach > enough);
  }
  if (faces_only) return apart;
  any_edge_pair([&](auto i, auto j) {
    if (all(apart)) return true;
    const BoxEdgeAxis<S> edge = box_edge<i, j>(p, absolute);
    const S gap = abs(edge.middle) - edge.reach, squared = edge.length_squared();
    const auto distinct = squared > S(parallel_edges<S>);
    apart = apart | (distinct & (gap > S(0)) & (gap * gap > enough * enough * squared));
    return false;
  });
  return apart;
}

}  // namespace graze
