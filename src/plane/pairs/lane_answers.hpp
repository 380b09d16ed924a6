// The queries of a special pair for the lanes of S, from columns of numbers to columns of numbers. Only for
// `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level. N pairs stand side by side; a pair alone is
// repeated in all lanes.
#pragma once

#include "plane/pairs/lane_sides.hpp"
#include "plane/pairs/pair_kernels.hpp"
#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

namespace plane_answers {

using namespace plane;

template <class S, std::size_t N>
[[gnu::always_inline]] inline S column(const double (&numbers)[N], std::size_t first) {
  if constexpr (N == 1)
    return S(numbers[0]);
  else
    return S::load(numbers + first);
}
template <class S, std::size_t N>
[[gnu::always_inline]] inline void put(double (&numbers)[N], std::size_t first, const S& value) {
  if constexpr (N == 1)
    numbers[0] = value[0];
  else
    value.store(numbers + first);
}
template <class S, std::size_t N>
[[gnu::always_inline]] inline void put(double (&numbers)[2][N], std::size_t first, const Vec2<S>& v) {
  put(numbers[0], first, v.x);
  put(numbers[1], first, v.y);
}
template <class S, std::size_t N, class M>
[[gnu::always_inline]] inline void put_truth(double (&numbers)[N], std::size_t first, const M& mask) {
  put(numbers, first, select(mask, S(1), S(0)));
}

template <class S, std::size_t N>
[[gnu::always_inline]] inline LaneShape<S> shape(const double (&columns)[shape_columns][N], std::size_t first) {
  const auto at = [&](std::size_t k) __attribute__((always_inline)) { return column<S>(columns[k], first); };
  return {{{at(0), at(1)}, {at(2), at(3)}}, {at(4), at(5), at(6), at(7)}, at(8)};
}
/// Whether a pair is seen from an upright frame.
template <class Pair>
constexpr bool upright = Pair::a == LaneCore::point&& Pair::b == LaneCore::point;

template <class Pair, class S, std::size_t N>
[[gnu::always_inline]] inline LanePair<S> pair_at(const PairColumns<N>& columns, std::size_t first) {
  return LanePair<S>(shape<S>(columns.a, first), shape<S>(columns.b, first), upright<Pair>);
}
/// Whether the rotations that matter to a pair are so nearly of unit length that special pairs answer, lane by lane.
template <class Pair, class S>
[[gnu::always_inline]] inline auto known(const LanePair<S>& pair) {
  if constexpr (upright<Pair>)
    return S(0) < S(1);
  else if constexpr (Pair::b == LaneCore::point)
    return near_unit_length(pair.a.pose.rotation);
  else
    return near_unit_length(pair.a.pose.rotation) & near_unit_length(pair.b.pose.rotation);
}
template <class Pair, class S>
[[gnu::always_inline]] inline Vec2<S> turned(const LanePair<S>& pair, const Vec2<S>& v) {
  if constexpr (upright<Pair>)
    return v;
  else
    return rotate(pair.rotation_a, v);
}
template <class Pair, class S>
[[gnu::always_inline]] inline Vec2<S> in_world(const LanePair<S>& pair, const Vec2<S>& p) {
  return pair.a.pose.translation + turned<Pair>(pair, p);
}

template <class Pair, class S, std::size_t N>
[[gnu::always_inline]] inline void overlap_at(const PairColumns<N>& columns, std::size_t first,
                                              OverlapColumns<N>& out) {
  const LanePair<S> pair = pair_at<Pair, S>(columns, first);
  const S radius = pair.radius();
  const LaneNearest<S> found = Pair::nearest(pair, radius);
  put_truth<S>(out.known, first, known<Pair>(pair));
  put_truth<S>(out.overlap, first, found.distance - radius <= S(0));
}

template <class Pair, class S, std::size_t N>
[[gnu::always_inline]] inline void distance_at(const PairColumns<N>& columns, std::size_t first,
                                               DistanceColumns<N>& out) {
  const LanePair<S> pair = pair_at<Pair, S>(columns, first);
  const LaneNearest<S> found = Pair::nearest(pair, S(std::numeric_limits<double>::infinity()));
  put_truth<S>(out.known, first, known<Pair>(pair));
  put(out.distance, first, found.distance - pair.radius());
  put(out.normal, first, turned<Pair>(pair, found.normal));
  put(out.a, first, in_world<Pair>(pair, found.a + found.normal * pair.a.radius));
  put(out.b, first, in_world<Pair>(pair, found.b - found.normal * pair.b.radius));
}

template <class Pair, class S, std::size_t N>
[[gnu::always_inline]] inline void put_point(const LanePair<S>& pair, const LanePoint<S>& p, std::size_t first,
                                             double (&out)[point_columns][N]) {
  const Vec2<S> a = in_world<Pair>(pair, p.a), b = in_world<Pair>(pair, p.b);
  put(out[0], first, a.x);
  put(out[1], first, a.y);
  put(out[2], first, b.x);
  put(out[3], first, b.y);
  put(out[4], first, p.distance);
  put(out[5], first, p.feature);
  put(out[6], first, p.weight);
}

template <class Pair, class S, std::size_t N>
[[gnu::always_inline]] inline void contacts_at(const PairColumns<N>& columns, std::size_t first,
                                               const double (&margins)[N], ContactColumns<N>& out) {
  const LanePair<S> pair = pair_at<Pair, S>(columns, first);
  const S radius = pair.radius();
  const S margin = column<S>(margins, first);
  const LaneNearest<S> found = Pair::nearest(pair, margin + radius);
  const LaneManifold<S> m = manifold<Pair::a, Pair::b>(pair, found, margin);
  put_truth<S>(out.known, first, known<Pair>(pair));
  put_truth<S>(out.overlap, first, found.distance - radius <= S(0));
  put(out.filled, first, select(m.has_first, S(1), S(0)) + select(m.has_second, S(2), S(0)));
  put(out.normal, first, turned<Pair>(pair, m.normal));
  put_point<Pair>(pair, m.first, first, out.points[0]);
  if constexpr (most_points<Pair::a, Pair::b> == 2) put_point<Pair>(pair, m.second, first, out.points[1]);
}

}  // namespace plane_answers

}  // namespace graze::GRAZE_ISA
