// Boxes of about one size, sorted into rows of a grid over Y and Z and along X within a row.
//
// Guarantee: a box is in each row that it reaches, which are four at the most; within a row boxes ascend along X. Cost
// N log N for any sizes and places. Memory is kept for the next frame.
#pragma once

#include <span>
#include <vector>

#include "broad/row_kernels.hpp"
#include "broad/strips.hpp"
#include "graze/aabb.hpp"

namespace graze {

/// The ranges and lengths of the boxes of a grid.
template <class T>
struct Spans {
  Vec3<T> lowest, highest;  ///< of the lower corners
  Vec3<T> longest;          ///< of the sides
};

template <class T>
class RowGrid {
 public:
  /// Sorts in the boxes at `places`, which must be finite and no further apart than the scalar reaches.
  void build(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, const Spans<T>& spans);

  Rows<T> rows() const;
  /// Makes `strips` and `Rows::reach_x`, which only `sweep_over` needs. Once is enough until the next `build`.
  void prepare_to_be_swept();
  /// The first row with each Y or a larger, and the end.
  const std::uint32_t* strips() const { return first_row_.data(); }
  /// The first row that a box can reach, and the number of rows that there may be.
  std::uint32_t first_row_of(const Aabb<T>& box) const {
    return y_.nearest(box.lower.y) * z_.count() + z_.nearest(box.lower.z);
  }
  std::uint32_t row_limit() const { return y_.count() * z_.count(); }
  /// A box in the form in which it is compared with this grid's.
  SweptOver<T> reach_of(const Aabb<T>& box, std::uint32_t place) const;

  std::size_t memory() const;

 private:
  void cut(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, const Spans<T>& spans);
  void sort_ties(std::span<const Aabb<T>> boxes, std::uint64_t* items, std::size_t count);
  void fill(std::span<const Aabb<T>> boxes, const std::uint64_t* items, std::size_t count);

  /// The bits of an item that is sorted, from the lowest on: place, `began`, place along X, row.
  struct Layout {
    int place_bits, bits_x;
  };

  Layout layout_{};
  bool is_prepared_ = false;
  Strips<T> y_, z_;
  std::vector<T> lower_x_, upper_x_, lower_y_, upper_y_, lower_z_, upper_z_, reach_x_;
  std::vector<typename BitsOf<sizeof(T)>::type> began_;
  std::vector<std::uint32_t> place_, first_row_;
  std::vector<Row> rows_;
  std::vector<std::uint64_t> items_, scratch_, keys_;
  std::vector<T> begins_;
};

}  // namespace graze
