// Box against box: the axis that contacts stand on, chosen across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The distance of overlapping boxes is minus their depth
// up to rounding; of others a lower bound. Which axis is chosen is no part of whether they touch.
#pragma once

#include "graze/shape.hpp"
#include "narrow/core/relative_frame.hpp"
#include "narrow/pairs/box_box/sat.hpp"

namespace graze {

/// Two boxes in place.
template <class S>
BoxPair<S> box_pair(const Vec3<S>& half_a, const Pose<S>& pose_a, const Vec3<S>& half_b, const Pose<S>& pose_b) {
  const RelativeFrame<S> b_in_a = relative_frame(pose_a, pose_b);
  return {half_a, half_b, b_in_a.translation, b_in_a.rotation};
}

/// How much deeper the normal of a face may be than the least depth and still be chosen, and how much further apart
/// than what is nearest the points along it, relative to the smaller shape. A resting box of size 1 leans by
/// milliradians and sinks in by millimetres; the least depth then changes between faces and edges from frame to frame,
/// and a solver needs the face. It is no part of the decision whether shapes overlap, and every point carries its true
/// distance along the chosen normal.
inline constexpr double face_preference = 1.0 / 200;

/// What rounding may do to the separation of two boxes along an axis, relative to the largest coordinate: in double as
/// on the general path, so that both agree on what touches; in float the roundings of a relative pose and of a sum of
/// six products.
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

/// The axis that contacts stand on.
template <class S>
struct BoxReferenceAxis {
  S distance;  ///< signed; where it is more than the margin, a lower bound
  S axis;      ///< its number: 0..2 are A's, 3..5 B's, 6 + 3 i + j the product of A's i-th and B's j-th
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

/// And along B's, with its half extents.
template <class S>
Packed<S, 3> box_faces_of_b(const BoxRows<S>& p, const Packed<S, 3>& half_b) {
  using Row = Packed<S, 3>;
  const Row* const row = p.rotation.row;
  const Row reach =
      abs(row[0]) * spread<0>(p.half_a) + abs(row[1]) * spread<1>(p.half_a) + abs(row[2]) * spread<2>(p.half_a);
  return abs(transposed_times(p.rotation, p.translation)) - (half_b + reach);
}

/// The first of the axes of faces along which the boxes are furthest apart.
template <class S>
struct BoxFace {
  S separation, number;
};
template <class S>
BoxFace<S> best_face(const BoxRows<S>& p) {
  using T = typename LaneOf<S>::type;
  using Row = Packed<S, 3>;
  const Row of_a = box_faces_of_a(p), of_b = box_faces_of_b(p, p.half_b);
  // The number is found after the separation, which all that follows waits for, and without a jump.
  const S separation = greatest_of(greatest(of_a, of_b));
  const Row numbers_a(S(0), S(1), S(2)), numbers_b(S(3), S(4), S(5)), none(S(T(6)));
  const Row all(separation);
  return {separation, least_of(select(of_a == all, numbers_a, select(of_b == all, numbers_b, none)))};
}

/// The largest separation along those products of edges that show a larger one than `least`, and the number of that
/// axis; minus infinity and 0 where none does.
template <class S>
S best_edges(const BoxRows<S>& p, const S& least, S& number) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  using Row = Packed<S, 3>;
  // Separations along edges are compared by their squares with their signs, a product each in place of a root: first of
  // each of B's edges with A's three, then of the best of these.
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

/// `margin` is up to where contacts are wanted. A face is taken before an edge that is hardly better.
template <class S>
BoxReferenceAxis<S> box_reference_axis(const BoxRows<S>& p, const S& margin) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const auto [face, face_number] = best_face(p);
  const S size_a = length(p.half_a), size_b = length(p.half_b), noise = box_noise(p, size_a, size_b);
  // Where a face tells that they are further apart than anybody asks, edges need not be tried.
  const Mask decided = face > margin + noise;
  S edge(-std::numeric_limits<T>::infinity()), edge_number(0);
  if (!all(decided)) edge = select(decided, edge, best_edges(p, face + noise, edge_number));
  const Mask edge_best = edge > face + noise, edge_chosen = edge > face + S(T(face_preference)) * least(size_a, size_b);
  const S separation = select(edge_best, edge, face);
  const S distance = select(abs(separation) <= noise, S(0), separation);
  const Mask outside = distance > margin;
  const Mask by_edge = (outside & edge_best) | ((!outside) & edge_chosen);
  return {distance, select(by_edge, edge_number, face_number)};
}

/// Between these the fourth power of a length, which squares of areas and of gaps along edges are made of, neither
/// overflows nor loses digits after it is multiplied by `parallel_edges`.
template <class T>
inline constexpr T smallest_length = sizeof(T) == 4 ? T(1e-7) : T(1e-70);
template <class T>
inline constexpr T largest_length = sizeof(T) == 4 ? T(1e9) : T(1e70);

/// Whether lengths from `low` to `high` are such, of a pair, of lanes or of three at once.
template <class T, class Lengths>
auto regular_lengths(const Lengths& low, const Lengths& high) {
  return (low > Lengths(smallest_length<T>)) & (high < Lengths(largest_length<T>));
}
/// Whether a box is one that these answer for: with a length along every side that is neither too large nor too small.
template <class S>
auto regular_box(const Vec3<S>& half) {
  return regular_lengths<typename LaneOf<S>::type>(least(half.x, least(half.y, half.z)), max_abs(half));
}
/// The same of a rectangle along its two sides.
template <class S>
auto regular_rectangle(const S& half_x, const S& half_z) {
  return regular_lengths<typename LaneOf<S>::type>(least(half_x, half_z), greatest(half_x, half_z));
}
/// Whether both are, of a single pair.
template <class S>
bool regular_boxes(const Packed<S, 3>& half_a, const Packed<S, 3>& half_b) {
  return !any(!regular_lengths<S>(least(half_a, half_b), greatest(half_a, half_b)));
}

/// The shape as such a box, without rounding; null if it is not.
template <class T>
const Box<T>* plain_box(const Shape<T>& shape) {
  const auto* box = shape.template as<Box<T>>();
  return box && shape.rounding() == T(0) && regular_box(box->half_extents()) ? box : nullptr;
}

}  // namespace graze
