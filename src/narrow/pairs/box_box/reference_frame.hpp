// The reference frame of two boxes that meet along an axis: coordinates permuted until the axis runs about along z,
// across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone; a single pair takes no branch on the data but whether
// the axis is a product of edges.
#pragma once

#include "narrow/pairs/box_box/boxes_in_place.hpp"

namespace graze::detail {

/// The choice of an `AxisPermutation` for packed rows: a cyclic permutation that puts one of three axes last.
template <class S>
class PackedPermutation {
 public:
  using Number = S;
  using Row = Packed<S, 3>;
  using Mask = typename Row::Mask;

  PackedPermutation() = default;
  /// The permutation that puts axis 0, 1 or 2 last; the number is given three times.
  static PackedPermutation of(const Row& number) { return {number == Row(S(0)), number == Row(S(1))}; }
  /// The permutation that puts last the axis along which a vector is longest, the first of equal ones.
  static PackedPermutation longest(const Row& v) {
    const Row a = abs(v), x = spread<0>(a), y = spread<1>(a), z = spread<2>(a);
    const Mask first = (x >= y) & (x >= z);
    return {first, (!first) & (y >= z)};
  }
  friend PackedPermutation select(const Mask& condition, const PackedPermutation& yes, const PackedPermutation& no) {
    const Mask other = !condition;
    return {(condition & yes.first_) | (other & no.first_), (condition & yes.second_) | (other & no.second_)};
  }

  /// The one of three values that belongs to the last axis.
  Row pick(const Row& x, const Row& y, const Row& z) const { return select(first_, x, select(second_, y, z)); }
  S pick(const S& x, const S& y, const S& z) const { return pick(Row(x), Row(y), Row(z))[0]; }
  /// The components of a vector, or the rows of a matrix, in the permuted order.
  Row operator()(const Row& v) const { return pick(following(v), preceding(v), v); }
  Rows<S> operator()(const Rows<S>& m) const {
    const Row* const row = m.row;
    return {pick(row[1], row[2], row[0]), pick(row[2], row[0], row[1]), pick(row[0], row[1], row[2])};
  }

 private:
  PackedPermutation(const Mask& first, const Mask& second) : first_(first), second_(second) {}
  Mask first_, second_;
};

/// The unit vector of the product of A's i-th axis with B's j-th, from A to B, by the number 3 i + j, given three
/// times.
template <class S>
Packed<S, 3> edges_normal(const BoxRows<S>& p, const Packed<S, 3>& number) {
  using std::sqrt;
  using Row = Packed<S, 3>;
  const Row zero(S(0)), first = select(number < Row(S(3)), zero, select(number < Row(S(6)), Row(S(1)), Row(S(2))));
  const Rows<S> columns = transposed(p.rotation);
  const Row along = PackedPermutation<S>::of(number - first * Row(S(3)))
                        .pick(columns.row[0], columns.row[1], columns.row[2]),
            back = -along;
  const Row product = PackedPermutation<S>::of(first).pick(
      gathered<0, 2, 1>(zero, back, along), gathered<2, 0, 0>(along, zero, back), gathered<1, 0, 0>(back, along, zero));
  const S scale = S(1) / sqrt(sum(product * product));
  return product * Row(scale * select(sum(p.translation * product) < S(0), S(-1), S(1)));
}

/// Two boxes seen from the one whose face is a rectangle along the axis, which is called the clipping one.
template <class S>
struct ReferenceFrame {
  using Row = Packed<S, 3>;
  using Mask = typename Row::Mask;

  Mask by_b;                  ///< the reference box is B
  PackedPermutation<S> face;  ///< the axis of the reference face, and so the order of the coordinates
  Row normal;                 ///< from the reference box to the other; for a face exactly one of its axes
  S steep;                    ///< one over the last component of the normal
  Row half, half_other;       ///< half extents of the reference box, permuted, and of the other, in its own order
  Row translation;            ///< centre of the other box
  Rows<S> rotation;           ///< rotation of the other box

  /// `p` as `seen_from_clipping` has it.
  ReferenceFrame(const BoxRows<S>& p, const S& axis) {
    using T = typename LaneOf<S>::type;
    const Row number(axis), zero(S(0)), one(S(1)), three(S(3)), six(S(T(6)));
    const Mask of_edges = number >= six;
    const bool any_edges = any(of_edges);
    by_b = b_clips(number);
    face = PackedPermutation<S>::of(number - select(by_b, three, zero));
    Row product;
    if (any_edges) {
      const Row of_b = number - Row{S(T(first_of_b_clipping))};
      const Row first = select(of_b < three, zero, select(of_b < six, one, Row(S(T(2)))));
      product = edges_normal(p, select(by_b, three * (of_b - three * first) + first, number - six));
      face = select(of_edges, PackedPermutation<S>::longest(product), face);
    }
    half = face(p.half_a);
    half_other = p.half_b;
    translation = face(p.translation);
    rotation = face(p.rotation);
    const Row far = spread<2>(translation);
    const Row sign = select(far >= zero, one, -one);
    normal = Row(S(0), S(0), S(1)) * sign;
    steep = sign[0];
    if (any_edges) {
      normal = select(of_edges, face(product), normal);
      steep = select(of_edges[0], S(1) / normal[2], steep);
    }
  }
};

}  // namespace graze::detail
