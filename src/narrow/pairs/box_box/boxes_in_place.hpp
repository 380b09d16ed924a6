// Two boxes in place, and the axis that their contacts stand on, whichever of them is called A.
//
// Guarantee: in every lane the bits that the pair gives alone, and those of the swapped pair mirrored. The view of one
// box from the other is never found from the opposite view, which would round once more.
#pragma once

#include "narrow/pairs/box_box/reference_axis.hpp"

namespace graze {

/// Two boxes in place, each seen from the other.
template <class S>
struct BoxesInPlace {
  using Row = Packed<S, 3>;

  Rows<S> turn_a, turn_b;  ///< their axes in the world
  BoxRows<S> rows;         ///< B seen from A
  Row from_b;              ///< the way from A's middle to B's in B's frame
  /// B comes first where two choices are as good: its middle lies lower along a direction that the middles of boxes in
  /// rows, stacks and grids seldom lie across.
  decltype(S() < S()) b_first;

  BoxesInPlace(const Row& half_a, const PoseRows<S>& a, const Row& half_b, const PoseRows<S>& b)
      : BoxesInPlace(half_a, a, a.length_squared(), half_b, b, b.length_squared(), b.translation - a.translation) {}

 private:
  BoxesInPlace(const Row& half_a, const PoseRows<S>& a, const S& squared_a, const Row& half_b, const PoseRows<S>& b,
               const S& squared_b, const Row& between)
      : turn_a(rotation_rows(a.vector, a.w, S(2) / squared_a, S(1))),
        turn_b(rotation_rows(b.vector, b.w, S(2) / squared_b, S(1))),
        rows(half_a, half_b, transposed_times(turn_a, between),
             relative_rotation(a, b, S(2) / (squared_a * squared_b), S(1))),
        from_b(transposed_times(turn_b, between)),
        b_first(sum(between * direction()) < S(0)) {}
  static Row direction() {
    using T = typename LaneOf<S>::type;
    return {S(T(0.5)), S(T(0.7)), S(T(0.6))};
  }
};

/// The rounding error of a separation, as that of a `BoxPair`, with the way between the middles as either box sees it.
template <class S>
S box_noise(const BoxesInPlace<S>& p, const S& size_a, const S& size_b) {
  using T = typename LaneOf<S>::type;
  return S(box_rounding<T>) *
         (greatest(size_a, size_b) + greatest_of(greatest(abs(p.rows.translation), abs(p.from_b))));
}

/// The face of `best_face`, whichever box is A: of faces equal within rounding, the first one of the box that is first.
template <class S>
BoxFace<S> reference_face(const BoxesInPlace<S>& p, const S& noise) {
  using T = typename LaneOf<S>::type;
  using Row = Packed<S, 3>;
  const Row of_a = box_faces_of_a(p.rows), of_b = abs(p.from_b) - (p.rows.half_b + reach_along_b(p.rows));
  const S separation = greatest_of(greatest(of_a, of_b));
  const Row as_good(separation - noise), numbers_a(S(0), S(1), S(2)), none(S(T(6))),
      numbers_b = numbers_a + Row(select(p.b_first, S(T(-3)), S(T(3))));
  const S number = least_of(least(select(of_a >= as_good, numbers_a, none), select(of_b >= as_good, numbers_b, none)));
  return {separation, select(number < S(0), number + S(T(6)), number)};
}

/// The first number of the products of edges along which B's face clips; below are those along which A's does.
inline constexpr int first_of_b_clipping = 15;

/// The reference axis for contacts up to `margin` apart. A face is preferred to an edge that is better by less than
/// `face_preference`.
template <class S>
BoxReferenceAxis<S> box_reference_axis(const BoxesInPlace<S>& p, const S& margin) {
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S size_a = length(p.rows.half_a), size_b = length(p.rows.half_b), noise = box_noise(p, size_a, size_b);
  const auto [face, face_number] = reference_face(p, noise);
  // Edges need no test where a face separates the boxes by more than the margin.
  const Mask decided = face > margin + noise;
  S edge(-std::numeric_limits<T>::infinity()), edge_number(0);
  if (!all(decided)) edge = select(decided, edge, best_edges(p.rows, face + noise, edge_number));
  const AxisChoice<S> choice = choose_axis(face, edge, noise, least(size_a, size_b));
  const S distance = choice.distance(noise);
  const Mask by_edge = choice.by_edge(distance > margin);
  const S of_edge = edge_number + select(p.b_first, S(T(first_of_b_clipping - 6)), S(0));
  return {distance, select(by_edge, of_edge, face_number)};
}

/// Whether B's face clips, along an axis by its number: else A's.
template <class S, int N>
auto b_clips(const Packed<S, N>& number) {
  using T = typename LaneOf<S>::type;
  using Numbers = Packed<S, N>;
  return ((number >= Numbers(S(3))) & (number < Numbers(S(6)))) | (number >= Numbers(S(T(first_of_b_clipping))));
}

/// The two seen from the one whose face clips, in the place of A.
template <class S>
BoxRows<S> seen_from_clipping(const BoxesInPlace<S>& p, const typename Packed<S, 3>::Mask& by_b) {
  const BoxRows<S>& from_a = p.rows;
  const Rows<S> back = transposed(from_a.rotation);
  const auto turned = [&](int i) { return select(by_b, back.row[i], from_a.rotation.row[i]); };
  return {select(by_b, from_a.half_b, from_a.half_a),
          select(by_b, from_a.half_a, from_a.half_b),
          select(by_b, -p.from_b, from_a.translation),
          {turned(0), turned(1), turned(2)}};
}

}  // namespace graze
