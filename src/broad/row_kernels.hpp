// The sweep of rows of boxes: plain arrays in, plain pairs out, so that it can be compiled for each instruction set.
//
// Guarantee: each overlapping pair is found once. Reads up to `row_padding` boxes past the last one, and no further.
#pragma once

#include <cstddef>
#include <cstdint>

#include "simd/dispatch.hpp"

namespace graze {

/// The number of boxes past the last one that can be read from the arrays of `Rows`.
inline constexpr std::size_t row_padding = 16;

/// Boxes of one row of a grid: `index` counts rows along Z first, then along Y.
struct Row {
  std::uint32_t index, begin, end;
};

/// Bits of a box in one of the rows it reaches: whether it begins in a row before, along Y and along Z. The pair of two
/// boxes belongs to the one row in which the later of the two begins, along Y as well as along Z; so they have no bit
/// in common there, and in every other row that has both of them they do.
inline constexpr int began_before_y = 1, began_before_z = 2;

template <std::size_t Size>
struct BitsOf {
  using type = std::int32_t;
};
template <>
struct BitsOf<8> {
  using type = std::int64_t;
};

/// Boxes sorted by row and then along X, a coordinate an array.
template <class T>
struct Rows {
  const T *lower_x, *upper_x, *lower_y, *upper_y, *lower_z, *upper_z;
  const T* reach_x;                               ///< the furthest upper_x from the beginning of the row up to here
  const typename BitsOf<sizeof(T)>::type* began;  ///< `began_before_y` and `_z`
  const std::uint32_t* place;
  const Row* rows;  ///< those with boxes, by index
  std::size_t count;
  std::uint32_t along_z;  ///< how many rows there are along Z, with boxes or without
};

/// The destination of found pairs: two places each, in any order.
struct PairSink {
  std::uint32_t *first, *second;
  std::size_t count, capacity;
  /// Makes room for at least `row_padding` more; or sets `is_full`, and then further pairs may be lost.
  void (*grow)(PairSink&);
  void* owner;
  bool is_full = false;
};

/// A box that is compared with rows: `lower_x`, `upper_x` and so on for Y and Z.
template <class T>
struct SweptOver {
  T bounds[6];
  std::uint32_t place;
  std::uint32_t low_y, high_y, low_z, high_z;  ///< the rows it can reach, all included
};

/// Sorted pairs of one box that are known, to be put in between others. `ranks[b]`: the number of places below b among
/// those from which the others come.
struct KnownPairs {
  const std::uint32_t* pairs;
  std::size_t count;
  const std::uint32_t* ranks;
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Finds the pairs of boxes that share a row.
    template <class T> void sweep_rows(const Rows<T>& rows, PairSink& sink);
    /// Finds the pairs of each box with those in the rows. `strips[y]`: the first place in `rows` with that Y or more.
    template <class T> void sweep_over(const Rows<T>& rows, const std::uint32_t* strips, const SweptOver<T>* boxes,
                                       std::size_t count, PairSink& sink);
    /// Writes the pairs of one box with those at `from` to `end` in the arrays, in that order, and `known` ones
    /// between them, two places each from `to` on; returns the end of what was written. Writes up to
    /// `row_padding` pairs past it.
    template <class T> std::uint32_t* test_all(const Rows<T>& boxes, std::uint32_t from, std::uint32_t end,
                                               const SweptOver<T>& box, const KnownPairs& known, std::uint32_t* to);)
// clang-format on

}  // namespace graze
