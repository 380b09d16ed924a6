// A node of a wide tree: the bounds of its children side by side, so that one box is tested against all at once.
//
// Guarantee: the test has no branch and takes each coordinate of all children as lanes; a place without a child overlaps
// nothing, whatever is asked.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "graze/aabb.hpp"
#include "graze/wide.hpp"

namespace graze {

/// What a child is: a node, a leaf, or nothing.
struct TreeChild {
  static constexpr std::uint32_t none = ~0u, leaf_bit = 1u << 31;

  static constexpr bool is_leaf(std::uint32_t child) { return (child & leaf_bit) != 0; }
  static constexpr std::uint32_t leaf(std::uint32_t child) { return child & ~leaf_bit; }
};

template <class T>
struct alignas(64) WideNode {
  /// Measured on 30,000 drifting boxes with the 16-byte vectors that every x86-64 has: with four children a frame takes
  /// half as long again, and the tree a fifth more memory.
  static constexpr std::uint32_t width = 8;

  std::array<std::array<T, width>, 3> lower, upper;
  std::array<std::uint32_t, width> child;
  Aabb<T> bounds;                       ///< of all children, and the room they may move in
  std::uint32_t parent = 0, place = 0;  ///< which child of its parent it is

  WideNode() {
    for (std::uint32_t i = 0; i < width; ++i) clear(i);
    bounds = Aabb<T>::empty();
  }

  Aabb<T> box(std::uint32_t i) const {
    return {{lower[0][i], lower[1][i], lower[2][i]}, {upper[0][i], upper[1][i], upper[2][i]}};
  }
  void set_box(std::uint32_t i, const Aabb<T>& b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis][i] = b.lower[axis];
      upper[axis][i] = b.upper[axis];
    }
  }
  void set(std::uint32_t i, const Aabb<T>& b, std::uint32_t what) {
    set_box(i, b);
    child[i] = what;
  }
  /// NaN is what overlaps nothing; the empty box would overlap all of space, by its infinite ends.
  void clear(std::uint32_t i) {
    constexpr T nan = std::numeric_limits<T>::quiet_NaN();
    set(i, {{nan, nan, nan}, {nan, nan, nan}}, TreeChild::none);
  }

  /// One bit a child that is there.
  std::uint32_t present() const {
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < width; ++i) bits |= (child[i] != TreeChild::none ? 1u : 0u) << i;
    return bits;
  }
  /// The distance of each child from a box; anything for a place without a child. The largest gap of the three axes is
  /// taken out before squaring, so that nothing overflows.
  void distances(const Aabb<T>& from, std::array<T, width>& out) const {
    constexpr int lanes = 16 / sizeof(T);
    using Lanes = Wide<T, lanes>;
    const Lanes zero(T(0)), one(T(1));
    for (std::size_t first = 0; first < width; first += lanes) {
      Lanes gap[3];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Lanes low = Lanes::load(&lower[axis][first]), high = Lanes::load(&upper[axis][first]);
        const Lanes from_low(from.lower[axis]), from_high(from.upper[axis]);
        gap[axis] = select(low > from_high, low - from_high, select(from_low > high, from_low - high, zero));
      }
      const Lanes largest = greatest(gap[0], greatest(gap[1], gap[2]));
      // Of equal gaps without end there is no share.
      const auto plain = (largest > zero) & (largest <= Lanes(std::numeric_limits<T>::max()));
      const Lanes scale = one / select(plain, largest, one);
      Lanes sum = zero;
      for (const Lanes& g : gap) sum += g * scale * (g * scale);
      select(plain, largest * sqrt(sum), largest).store(&out[first]);
    }
  }
  /// One bit a child: whether it overlaps the box.
  std::uint32_t overlapping(const Aabb<T>& b) const {
    // As many lanes as every x86-64 has: wider vectors than the hardware's are slow in g++.
    constexpr int lanes = 16 / sizeof(T);
    using Lanes = Wide<T, lanes>;
    using Bits = typename Lanes::BitVector;
    const Lanes low[3] = {b.lower.x, b.lower.y, b.lower.z}, high[3] = {b.upper.x, b.upper.y, b.upper.z};
    Bits bits{};
    for (int first = 0; first < static_cast<int>(width); first += lanes) {
      typename Lanes::Mask mask = Lanes::load(&lower[0][static_cast<std::size_t>(first)]) <= high[0];
      mask = mask & (Lanes::load(&upper[0][static_cast<std::size_t>(first)]) >= low[0]);
      for (std::size_t axis = 1; axis < 3; ++axis) {
        mask = mask & (Lanes::load(&lower[axis][static_cast<std::size_t>(first)]) <= high[axis]);
        mask = mask & (Lanes::load(&upper[axis][static_cast<std::size_t>(first)]) >= low[axis]);
      }
      Bits weights{};
      for (int i = 0; i < lanes; ++i) weights[i] = typename Lanes::Bits{1} << (first + i);
      bits |= mask.bits & weights;
    }
    typedef std::uint64_t Halves __attribute__((vector_size(16)));
    const auto halves = reinterpret_cast<Halves>(bits);
    const std::uint64_t both = halves[0] | halves[1];
    return static_cast<std::uint32_t>(both | (sizeof(T) == 4 ? both >> 32 : 0));
  }
};

}  // namespace graze
