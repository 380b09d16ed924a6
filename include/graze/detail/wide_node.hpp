// A node of a wide tree: the bounds of its children side by side, so that one box is tested against all at once.
//
// Guarantee: the test has no branch and takes each coordinate of all children as lanes; a slot without a child overlaps
// nothing, whatever the box.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "graze/aabb.hpp"
#include "graze/wide.hpp"

namespace graze {

/// Encoding of a child: a node, a leaf, or nothing.
struct TreeChild {
  /// The value for an absent child, and the bit that distinguishes a leaf from a node.
  static constexpr std::uint32_t none = ~0u, leaf_bit = 1u << 31;

  /// Whether the child is a leaf.
  static constexpr bool is_leaf(std::uint32_t child) { return (child & leaf_bit) != 0; }
  /// The number that the leaf holds.
  static constexpr std::uint32_t leaf(std::uint32_t child) { return child & ~leaf_bit; }
};

/// A ray prepared for slab tests: the points origin + t direction with t >= 0, its direction of any length.
template <class T>
struct NodeRay {
  Vec3<T> origin, inverse, margin;  ///< origin, one over the direction, and the margin for rounding and `slack`

  /// A ray whose slab tests enlarge boxes by `slack` on all sides.
  NodeRay(const Vec3<T>& from, const Vec3<double>& direction, double slack) : origin(from) {
    constexpr auto most = static_cast<double>((std::numeric_limits<T>::max)());
    constexpr double rounding = 1 + 8 * static_cast<double>(std::numeric_limits<T>::epsilon());
    for (std::size_t i = 0; i < 3; ++i) {
      // Finite, so that a side that the ray lies in does not give 0 * infinity; and not zero, hence a margin of 1e-18.
      const double d = direction[i], inv = d == 0 ? most : 1 / d;
      inverse[i] = static_cast<T>(inv < -most ? -most : inv > most ? most : inv);
      const double m = d == 0 ? most * greatest(slack * rounding, 0x1p-60) : slack * std::abs(inv) * rounding;
      margin[i] = static_cast<T>(m > most ? most : m);
    }
  }
};

/// A node of a tree, with the boxes of all its children side by side.
template <class T>
struct alignas(64) WideNode {
  /// Number of children. Measured on 30,000 drifting boxes with the 16-byte vectors that every x86-64 has: with four
  /// children a frame takes half as long again, and the tree a fifth more memory.
  static constexpr std::uint32_t width = 8;

  std::array<std::array<T, width>, 3> lower, upper;  ///< the children's boxes, by axis
  std::array<std::uint32_t, width> child;            ///< nodes, leaves or none
  Aabb<T> bounds;                                    ///< box of all children, enlarged by the room they may move in
  std::uint32_t parent = 0, place = 0;               ///< the parent, and the index of this node among its children

  WideNode() {
    for (std::uint32_t i = 0; i < width; ++i) clear(i);
    bounds = Aabb<T>::empty();
  }

  /// The box of the i-th child.
  Aabb<T> box(std::uint32_t i) const {
    return {{lower[0][i], lower[1][i], lower[2][i]}, {upper[0][i], upper[1][i], upper[2][i]}};
  }
  /// Sets the box of the i-th child.
  void set_box(std::uint32_t i, const Aabb<T>& b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis][i] = b.lower[axis];
      upper[axis][i] = b.upper[axis];
    }
  }
  /// Sets the i-th child and its box.
  void set(std::uint32_t i, const Aabb<T>& b, std::uint32_t what) {
    set_box(i, b);
    child[i] = what;
  }
  /// Removes the i-th child. Its box becomes NaN, which overlaps nothing; the infinite ends of the empty box would
  /// overlap all of space.
  void clear(std::uint32_t i) {
    constexpr T nan = std::numeric_limits<T>::quiet_NaN();
    set(i, {{nan, nan, nan}, {nan, nan, nan}}, TreeChild::none);
  }

  /// A bit for each slot that has a child.
  std::uint32_t present() const {
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < width; ++i) bits |= (child[i] != TreeChild::none ? 1u : 0u) << i;
    return bits;
  }
  /// The distance of each child from a box; undefined for a slot without a child. The largest gap of the three axes is
  /// factored out before squaring, so that nothing overflows.
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
      // An infinite largest gap allows no division.
      const auto plain = (largest > zero) & (largest <= Lanes((std::numeric_limits<T>::max)()));
      const Lanes scale = one / select(plain, largest, one);
      Lanes sum = zero;
      for (const Lanes& g : gap) sum += g * scale * (g * scale);
      select(plain, largest * sqrt(sum), largest).store(&out[first]);
    }
  }
  /// The parameter at which a ray enters each child, rounded down, in multiples of its direction; infinity for a miss,
  /// and undefined for a slot without a child (Kay, Kajiya 1986, "Ray tracing complex scenes", on slabs).
  void entries(const NodeRay<T>& ray, std::array<T, width>& out) const {
    constexpr int lanes = 16 / sizeof(T);
    using Lanes = Wide<T, lanes>;
    // The rounding of a difference and of its product with a rounded inverse: each way less than two epsilon.
    const Lanes rounding(T(1) + T(8) * std::numeric_limits<T>::epsilon()),
        less(T(1) - T(4) * std::numeric_limits<T>::epsilon()), never(std::numeric_limits<T>::infinity());
    for (std::size_t at = 0; at < width; at += lanes) {
      Lanes enter(T(0)), leave = never;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool forward = ray.inverse[axis] >= T(0);
        const Lanes entry_plane = Lanes::load(&(forward ? lower : upper)[axis][at]),
                    exit_plane = Lanes::load(&(forward ? upper : lower)[axis][at]);
        const Lanes origin(ray.origin[axis]), inverse(ray.inverse[axis]), margin(ray.margin[axis]);
        const Lanes first = (entry_plane - origin) * inverse - margin, last = (exit_plane - origin) * inverse + margin;
        enter = select(first > enter, first, enter);
        leave = select(last < leave, last, leave);
      }
      select(enter <= leave * rounding, enter * less, never).store(&out[at]);
    }
  }
  /// A bit for each child that overlaps the box.
  std::uint32_t overlapping(const Aabb<T>& b) const {
    // Vectors of the width that every x86-64 has: wider ones than the hardware's are slow in g++.
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
    const auto halves = detail::bits_as<detail::LaneVector<std::uint64_t, 2>>(bits);
    const std::uint64_t both = halves[0] | halves[1];
    return static_cast<std::uint32_t>(both | (sizeof(T) == 4 ? both >> 32 : 0));
  }
};

}  // namespace graze
