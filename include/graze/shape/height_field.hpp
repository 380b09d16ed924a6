// Height fields: surfaces over a grid, without thickness, of which both sides count by default.
//
// Guarantee: any finite heights; input is checked once, by the constructor. Shared and immutable, safe to query from
// any thread. Triangles are made on demand: besides the heights an eighth of their memory is kept, the lowest and
// highest of each four by four cells, of each four by four of those, and so on.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "graze/aabb.hpp"
#include "graze/detail/lent.hpp"
#include "graze/detail/validate.hpp"
#include "graze/pose.hpp"
#include "graze/shape/sides.hpp"

namespace graze {

template <class T>
struct HeightFieldData;

/// A grid of heights: heights[r * columns + c] stands at x = (c - (columns - 1) / 2) spacing_x, z = (r - (rows - 1) /
/// 2) spacing_z, y up. A cell is split along (c, r) - (c + 1, r + 1) into two triangles that face +Y: first the one
/// with (c + 1, r), then the one with (c, r + 1). A cell with a hole at a corner is missing.
template <class T>
class GRAZE_API HeightField {
 public:
  static constexpr const char* name = "heightfield";

  /// At least two columns and rows; spacings finite and >= 0; columns * rows heights, finite, or NaN for a hole. At
  /// least one cell has to be whole. Throws `InvalidValue`. Cost: the number of heights.
  HeightField(std::size_t columns, std::size_t rows, std::vector<T> heights, T spacing_x = T(1), T spacing_z = T(1),
              Sides sides = Sides::both);

  /// A height field whose holes are given apart: a flag for each height, not zero for a hole.
  HeightField(std::size_t columns, std::size_t rows, std::vector<T> heights, std::span<const std::uint8_t> holes,
              T spacing_x = T(1), T spacing_z = T(1), Sides sides = Sides::both);
  HeightField(const HeightField& lender, Lent) : data_(std::shared_ptr<void>(), lender.data_.get()) {}

  std::size_t columns() const;  ///< number of samples along X
  std::size_t rows() const;     ///< number of samples along Z
  T spacing_x() const;          ///< distance between columns
  T spacing_z() const;          ///< distance between rows
  Sides sides() const;          ///< sides that push
  /// The heights as given, with NaN for holes.
  std::span<const T> heights() const;
  /// Whether the cell that begins at this sample is missing.
  bool hole(std::size_t column, std::size_t row) const;
  /// The data that copies of the shape share.
  const HeightFieldData<T>& data() const { return *data_; }

  /// The number of triangle numbers, missing cells included: 2 (r (columns - 1) + c), and one more for the second of a
  /// cell.
  std::uint32_t triangle_numbers() const;
  /// Whether a number's cell is whole.
  bool has_triangle(std::uint32_t number) const;
  std::array<Vec3<T>, 3> triangle(std::uint32_t number) const;  ///< corners of a triangle, counter-clockwise seen from
                                                                ///< above

  T core_extent() const;
  /// The bounds under a pose. For a turned field of more than 256 triangles up to 1/128 of its size too wide on each
  /// side.
  Aabb<T> core_bounds(const Pose<T>& pose) const;

 private:
  std::shared_ptr<const HeightFieldData<T>> data_;
};

}  // namespace graze
