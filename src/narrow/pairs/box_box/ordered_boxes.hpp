// Two boxes in place, in the order of `pair_order`, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone, and those of the swapped pair.
#pragma once

#include "narrow/core/core.hpp"
#include "narrow/core/pair_order.hpp"
#include "narrow/pairs/box_box/packed_boxes.hpp"

namespace graze {

/// Two boxes, of which the one whose middle is the lower takes the place of A. Two with the same middle stay as they
/// are.
template <class S>
struct OrderedBoxes {
  using Row = Packed<S, 3>;
  using Mask = typename Row::Mask;

  Mask swapped;  ///< B takes the place of A
  BoxRows<S> rows;

  OrderedBoxes(const Row& half_a, const PoseRows<S>& a, const Row& half_b, const PoseRows<S>& b)
      : OrderedBoxes(half_a, a, a.length_squared(), half_b, b, b.length_squared(), b.translation - a.translation) {}

 private:
  OrderedBoxes(const Row& half_a, const PoseRows<S>& a, const S& squared_a, const Row& half_b, const PoseRows<S>& b,
               const S& squared_b, const Row& between)
      : swapped(Row(sum(between * order())) < Row(S(0))),
        rows(select(swapped, half_b, half_a), select(swapped, half_a, half_b),
             transposed_times(rotation_rows(select(swapped, b.vector, a.vector), select(swapped, b.w, a.w),
                                            two_over(swapped, squared_b, squared_a), S(1)),
                              select(swapped, -between, between)),
             relative_rotation(a, b, swapped, S(2) / (squared_a * squared_b))) {}

  /// Two over `yes` or `no`. Of a single pair both are divided by before it is known by which: it would be waited for.
  static S two_over(const Mask& condition, const S& yes, const S& no) {
    if constexpr (Row::joined)
      return select(condition, Row(S(2) / yes), Row(S(2) / no))[0];
    else
      return S(2) / select(condition, Row(yes), Row(no))[0];
  }
  static Row order() {
    using T = typename LaneOf<S>::type;
    return {S(pair_order<T>[0]), S(pair_order<T>[1]), S(pair_order<T>[2])};
  }
  // The turn back is the same quaternion with its vector turned round, to the last bit.
  static Rows<S> relative_rotation(const PoseRows<S>& a, const PoseRows<S>& b, const Mask& swapped, const S& per) {
    const auto [vector, w] = relative_quaternion(a, b);
    return rotation_rows(select(swapped, -vector, vector), w, per, S(1));
  }
};

}  // namespace graze
