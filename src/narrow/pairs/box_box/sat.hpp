// Box against box by fifteen separating axes: three of A, three of B, and the nine products of their edges (Gottschalk,
// Lin, Manocha 1996, "OBBTree: a hierarchical structure for rapid interference detection", section 5; the radii as in
// Eberly's table, "Dynamic collision detection using oriented bounding boxes", 2002).
//
// Guarantee: `separation` along each axis is that of the boxes' intervals: the largest of the fifteen is a lower bound
// of the distance, and for overlapping boxes exactly minus the depth. Two edges that are parallel up to rounding have
// no axis: the face axes answer then, and nothing is divided by a vanishing length.
#pragma once

#include <limits>
#include <utility>

#include "narrow/core/core.hpp"
#include "narrow/pairs/box_box/packed_boxes.hpp"

namespace graze {

/// An axis with its number: 0..2 are A's, 3..5 B's, 6 + 3 i + j the product of A's i-th and B's j-th.
template <class S>
struct BoxAxis {
  S separation;
  Vec3<S> normal;  ///< unit, from A to B, in the frame of A
  S number;
};

/// The best axis of each kind. `face_a` and `face_b` always exist; `edge.separation` is minus infinity without an edge
/// axis.
template <class S>
struct BoxAxes {
  BoxAxis<S> face_a, face_b, edge;
};

/// The squared sine below which two edges count as parallel. The product of two edges is a valid axis even if a single
/// rounding turns them, however short it is, since its projections are taken with its own components; leaving it out
/// makes the separation wrong by the sine times an edge: eight roundings.
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

/// The best of A's three axes, which need one row of the rotation each.
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

/// The best of B's three axes, with the absolute rotation that the edges need too.
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

/// The products of A's i-th with each of B's axes, e_i x b_j, not of unit length. A's axis is a unit vector of the
/// frame, so one component is zero and the others are entries of the rotation. B's other axes are projected on these
/// components and not read from the rotation as orthogonality would allow (Eberly's table): an entry is off by a
/// rounding of one, which would matter after division by the length of the product of two nearly parallel edges.
template <class S>
struct BoxEdgeAxes {
  using Row = Packed<S, 3>;
  Row along_1, along_2;  ///< components along the two axes of A that follow the i-th
  Row middle, reach;     ///< projections on it of the centres' offset, signed, and of both half extents
  Row length_squared() const { return along_1 * along_1 + along_2 * along_2; }
  /// The separation times the length of the axis.
  Row gap() const { return abs(middle) - reach; }
};

template <std::size_t I, class S>
BoxEdgeAxes<S> box_edges(const BoxRows<S>& p) {
  using Row = Packed<S, 3>;
  constexpr int i1 = (I + 1) % 3, i2 = (I + 2) % 3;
  const Row &x = p.rotation.row[i1], &y = p.rotation.row[i2];
  // The projection of each of B's axes on the product of the one before, and so of the one before on the product of
  // this.
  const Row across = abs(following(y) * x - following(x) * y);
  return {-y, x, spread<i2>(p.translation) * x - spread<i1>(p.translation) * y,
          spread<i1>(p.half_a) * abs(y) + spread<i2>(p.half_a) * abs(x) + following(p.half_b) * across +
              preceding(p.half_b) * preceding(across)};
}

/// Calls `f(I)` with a constant for each of three axes until it returns true. Constants leave no cyclic index to run
/// time.
template <class F>
bool any_of_three(F&& f) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return (f(std::integral_constant<std::size_t, I>{}) || ...);
  }
  (std::make_index_sequence<3>{});
}

/// Takes the product of A's I-th and B's j-th axis where it is better.
template <std::size_t I, class S>
void keep_edge(const BoxEdgeAxes<S>& edges, int j, BoxAxis<S>& best) {
  using std::sqrt;
  const S squared = edges.length_squared()[j];
  const auto distinct = squared > S(parallel_edges<S>);
  const S scale = S(1) / sqrt(select(distinct, squared, S(1)));
  const S toward = select(edges.middle[j] < S(0), -scale, scale);
  Vec3<S> normal{S(0), S(0), S(0)};
  normal[(I + 1) % 3] = edges.along_1[j] * toward;
  normal[(I + 2) % 3] = edges.along_2[j] * toward;
  const S separation = edges.gap()[j] * scale;
  detail::keep(best, distinct & (separation > best.separation), separation, normal, static_cast<int>(6 + 3 * I) + j);
}

/// All fifteen axes, without those of edges where faces already separate all lanes' boxes by more than `enough`.
template <class S>
BoxAxes<S> box_axes(const BoxPair<S>& p, const S& enough) {
  const Mat3<S> absolute = abs(p.rotation);
  BoxAxes<S> axes{box_axes_of_a(p), box_axes_of_b(p, absolute), detail::no_axis<S>()};
  if (all(greatest(axes.face_a.separation, axes.face_b.separation) > enough)) return axes;
  const BoxRows<S> rows(p);
  any_of_three([&](auto i) {
    const BoxEdgeAxes<S> edges = box_edges<i>(rows);
    for (int j = 0; j < 3; ++j) keep_edge<i>(edges, j, axes.edge);
    return false;
  });
  return axes;
}

}  // namespace graze
