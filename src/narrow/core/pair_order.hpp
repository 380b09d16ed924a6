// The order in which two shapes of one kind are answered, whichever of them is called A.
//
// Where two choices are as good (two faces as deep, two corners of which one means nothing) a routine takes the first
// one, or rounding chooses; both depend on which shape comes first. In an order that a swap of the two does not change
// all that follows has the same bits either way.
#pragma once

namespace graze {

/// Of two shapes of one kind the first is the one that lies lower along this direction: none that the middles of shapes
/// in rows, stacks and grids often lie across, so that roundings of a resting pair do not change its order.
template <class T>
inline constexpr T pair_order[3] = {T(0.5), T(0.7), T(0.6)};

/// How much higher one place is than another.
template <class T, class V>
T pair_rise(const V& from, const V& to) {
  return (to.x - from.x) * pair_order<T>[0] + (to.y - from.y) * pair_order<T>[1] + (to.z - from.z) * pair_order<T>[2];
}

}  // namespace graze
