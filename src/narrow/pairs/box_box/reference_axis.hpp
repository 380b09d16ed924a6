// Box against box: the reference axis of contacts, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The distance of overlapping boxes is minus their depth
// up to rounding; for disjoint ones it is a lower bound. The choice of the axis has no influence on whether they touch.
#pragma once

#include "graze/shape.hpp"
#include "narrow/core/relative_frame.hpp"
#include "narrow/pairs/box_box/sat.hpp"
#include "narrow/sat/choose_axis.hpp"

namespace graze {

/// Two boxes in place, transformed to the frame of A.
template <class S>
BoxPair<S> box_pair(const Vec3<S>& half_a, const Pose<S>& pose_a, const Vec3<S>& half_b, const Pose<S>& pose_b) {
  const RelativeFrame<S> b_in_a = relative_frame(pose_a, pose_b);
  return {half_a, half_b, b_in_a.translation, b_in_a.rotation};
}

/// Rounding of the separation of two boxes along an axis, relative to the largest coordinate: in double as on the
/// general path, so that both agree on touching; in float the roundings of a relative pose and of a sum of six
/// products.
template <class T>
inline constexpr T box_rounding = 32 * std::numeric_limits<T>::epsilon();
template <>
inline constexpr float box_rounding<float> = 8 * std::numeric_limits<float>::epsilon();

template <class S>
S box_noise(const BoxPair<S>& p, const S& size_a, const S& size_b) {
  using T = typename LaneOf<S>::type;
  return S(box_rounding<T>) * (greatest(size_a, size_b) + max_abs(p.translation));
}
template <class S>
S box_noise(const BoxRows<S>& p, const S& size_a, const S& size_b) {
  using T = typename LaneOf<S>::type;
  return S(box_rounding<T>) * (greatest(size_a, size_b) + greatest_of(abs(p.translation)));
}
/// The length of a vector.
template <class S>
S length(const Packed<S, 3>& v) {
  using std::sqrt;
  return sqrt(sum(v * v));
}

/// The axis along which contacts are found.
template <class S>
struct BoxReferenceAxis {
  S distance;  ///< signed distance; a lower bound where it exceeds the margin
  S axis;      ///< number of the axis: 0..2 are A's, 3..5 B's, 6 + 3 i + j the product of A's i-th and B's j-th
};

/// The separations along A's axes.
template <class S>
Packed<S, 3> box_faces_of_a(const BoxRows<S>& p) {
  using Row = Packed<S, 3>;
  const Rows<S> axes = transposed(p.rotation);
  const Row reach = abs(axes.row[0]) * spread<0>(p.half_b) + abs(axes.row[1]) * spread<1>(p.half_b) +
                    abs(axes.row[2]) * spread<2>(p.half_b);
  return abs(p.translation) - (p.half_a + reach);
}

/// The reach of A along B's axes.
template <class S>
Packed<S, 3> reach_along_b(const BoxRows<S>& p) {
  const auto* const row = p.rotation.row;
  return abs(row[0]) * spread<0>(p.half_a) + abs(row[1]) * spread<1>(p.half_a) + abs(row[2]) * spread<2>(p.half_a);
}
/// The separations along B's axes, with its half extents.
template <class S>
Packed<S, 3> box_faces_of_b(const BoxRows<S>& p, const Packed<S, 3>& half_b) {
  return abs(transposed_times(p.rotation, p.translation)) - (half_b + reach_along_b(p));
}

/// The axis of a face along which the boxes are furthest apart, the first of equal ones.
template <class S>
struct BoxFace {
  S separation, number;
};
template <class S>
BoxFace<S> best_face(const BoxRows<S>& p) {
  using T = typename LaneOf<S>::type;
  using Row = Packed<S, 3>;
  const Row of_a = box_faces_of_a(p), of_b = box_faces_of_b(p, p.half_b);
  // The number is found after the separation, on which all that follows depends, and without a branch.
  const S separation = greatest_of(greatest(of_a, of_b));
  const Row numbers_a(S(0), S(1), S(2)), numbers_b(S(3), S(4), S(5)), none(S(T(6)));
  const Row all(separation);
  return {separation, least_of(select(of_a == all, numbers_a, select(of_b == all, numbers_b, none)))};
}

/// The largest separation along a product of edges if it exceeds `least`, and the number of that axis; else minus
/// infinity and 0.
template <class S>
S best_edges(const BoxRows<S>& p, const S& least, S& number) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  using Row = Packed<S, 3>;
  // Separations along edges are compared by their signed squares, a product each in place of a root: first each of B's
  // edges with A's three, then the best of these.
  Row gap(least * abs(least)), squared(S(1)), numbers(S(0));
  any_of_three([&](auto i) {
    const BoxEdgeAxes<S> edges = box_edges<i>(p);
    const Row gaps = edges.gap(), lengths = edges.length_squared(), signed_squares = gaps * abs(gaps);
    const auto better = (lengths > Row(S(parallel_edges<S>))) & (signed_squares * squared > gap * lengths);
    constexpr T first = 6 + 3 * static_cast<int>(i);
    gap = select(better, signed_squares, gap);
    squared = select(better, lengths, squared);
    numbers = select(better, Row(S(first), S(first + 1), S(first + 2)), numbers);
    return false;
  });
  const S none(-std::numeric_limits<T>::infinity());
  number = S(0);
  if (Row::joined && !any(numbers > Row(S(0)))) return none;
  S best = gap[0], over = squared[0];
  number = numbers[0];
  for (int j = 1; j < 3; ++j) {
    const auto better = gap[j] * over > best * squared[j];
    best = select(better, gap[j], best);
    over = select(better, squared[j], over);
    number = select(better, numbers[j], number);
  }
  const S length = sqrt(abs(best) / over);
  return select(number > S(0), select(best < S(0), -length, length), none);
}

/// Bounds of a length whose fourth power, as in squares of areas and of gaps along edges, neither overflows nor loses
/// digits after it is multiplied by `parallel_edges`.
template <class T>
inline constexpr T smallest_length = sizeof(T) == 4 ? T(1e-7) : T(1e-70);
template <class T>
inline constexpr T largest_length = sizeof(T) == 4 ? T(1e9) : T(1e70);

/// Whether lengths from `low` to `high` are within these bounds, for a pair, for lanes or for three at once.
template <class T, class Lengths>
auto regular_lengths(const Lengths& low, const Lengths& high) {
  return (low > Lengths(smallest_length<T>)) & (high < Lengths(largest_length<T>));
}
/// Whether the routines for boxes answer for a box: its length along every side is neither too large nor too small.
template <class S>
auto regular_box(const Vec3<S>& half) {
  return regular_lengths<typename LaneOf<S>::type>(least(half.x, least(half.y, half.z)), max_abs(half));
}
/// Whether the lengths of a rectangle's two sides are neither too large nor too small.
template <class S>
auto regular_rectangle(const S& half_x, const S& half_z) {
  return regular_lengths<typename LaneOf<S>::type>(least(half_x, half_z), greatest(half_x, half_z));
}
/// Whether both boxes of a single pair are regular.
template <class S>
bool regular_boxes(const Packed<S, 3>& half_a, const Packed<S, 3>& half_b) {
  return !any(!regular_lengths<S>(least(half_a, half_b), greatest(half_a, half_b)));
}

/// The shape as a regular box without rounding; null if it is none.
template <class T>
const Box<T>* plain_box(const Shape<T>& shape) {
  const auto* box = shape.template as<Box<T>>();
  return box && shape.rounding() == T(0) && regular_box(box->half_extents()) ? box : nullptr;
}

}  // namespace graze
