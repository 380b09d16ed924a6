// The data of a height field, and its search by a pyramid of lowest and highest heights.
//
// Guarantee: the box of each block contains the triangles of its cells; blocks all of whose cells are holes are never
// children. The hierarchy has sixteen children a node and half as many levels as the longer side has bits.
//
// Source: Tevs, Ihrke, Seidel 2008, "Maximum mipmaps for fast, accurate, and scalable dynamic height field rendering".
#pragma once

#include <cmath>

#include "graze/shape/height_field.hpp"
#include "shape/field_pyramid.hpp"
#include "shape/hierarchy.hpp"
#include "shape/level_sine.hpp"
#include "shape/triangles_across.hpp"

namespace graze {

template <class T>
struct HeightFieldData {
  using Scalar = T;
  /// A block of a level; level 0 are the cells.
  struct Ref {
    std::uint32_t column, row, level;
  };
  static constexpr std::size_t width = 16;
  static constexpr std::uint32_t side = FieldPyramid<T>::side;
  using Children = ChildBoxes<T, Ref, width>;

  /// Low and high of a block; low > high when all its cells are holes.
  struct Span {
    T low = std::numeric_limits<T>::infinity(), high = -std::numeric_limits<T>::infinity();
  };
  /// The blocks of one level above the cells.
  struct Level {
    std::uint32_t columns, rows;
    std::vector<Span> spans;  ///< and three more, for `FieldPyramid`
  };

  std::uint32_t columns, rows;
  T spacing_x, spacing_z;
  std::vector<T> heights;
  std::vector<Level> levels;  ///< the last is one block
  T extent = T(0);            ///< the greatest distance of a corner from the frame's origin
  Aabb<T> all;
  double radius = 0;          ///< of a ball about the centre of the bounds, as rounded, that holds all of them
  FieldPyramid<T> pyramid{};  ///< the same data as kernels read it
  Sides sides = Sides::both;

  const HeightFieldData& hierarchy() const { return *this; }

  T x(std::uint32_t column) const { return (T(column) - T(columns - 1) / T(2)) * spacing_x; }
  T z(std::uint32_t row) const { return (T(row) - T(rows - 1) / T(2)) * spacing_z; }
  T height(std::uint32_t column, std::uint32_t row) const { return heights[std::size_t{row} * columns + column]; }
  Vec3<T> point(std::uint32_t column, std::uint32_t row) const { return {x(column), height(column, row), z(row)}; }

  /// The span of a cell's corners, empty for a hole.
  Span cell(std::uint32_t column, std::uint32_t row) const {
    const T a = height(column, row), b = height(column + 1, row), c = height(column, row + 1),
            d = height(column + 1, row + 1);
    if (std::isnan(a) || std::isnan(b) || std::isnan(c) || std::isnan(d)) return {};
    return {least(least(a, b), least(c, d)), greatest(greatest(a, b), greatest(c, d))};
  }

  std::array<Vec3<T>, 3> triangle(std::uint32_t number) const {
    const std::uint32_t at = number / 2, c = at % (columns - 1), r = at / (columns - 1);
    const Vec3<T> first = point(c, r), last = point(c + 1, r + 1);
    if (number % 2 == 0) return {first, last, point(c + 1, r)};
    return {first, point(c, r + 1), last};
  }

  /// The triangles across the edges of one. Each cell is cut from its first corner to its last: the even triangle lies
  /// at the next column, the odd at the next row.
  TrianglesAcross across(std::uint32_t number) const {
    const std::uint32_t at = number / 2, c = at % (columns - 1), r = at / (columns - 1), odd = number % 2;
    const auto in_cell = [&](std::uint32_t column, std::uint32_t row) {
      if (column >= columns - 1 || row >= rows - 1) return no_triangle;  // below zero they wrap round
      const Span s = cell(column, row);
      return s.low <= s.high ? 2 * (row * (columns - 1) + column) + 1 - odd : no_triangle;
    };
    if (odd != 0) return {in_cell(c - 1, r), in_cell(c, r + 1), number - 1};
    return {number + 1, in_cell(c + 1, r), in_cell(c, r - 1)};
  }

  /// Whether a triangle lies level with all that share a corner with it, the surface going on all around. All of these
  /// lie in the nine cells about its own; where their edges along x and along z climb as its own do, up to a bound, so
  /// do their planes, and two unit normals differ by no more than the slopes of their planes.
  bool lies_level(std::uint32_t number) const {
    const std::uint32_t at = number / 2, c = at % (columns - 1), r = at / (columns - 1), odd = number % 2;
    if (c < 1 || r < 1 || c + 2 >= columns || r + 2 >= rows) return false;
    // A triangle's slopes along x and along z may be off this one's by a third of the sine each: together by less than
    // half of it, so that no two of them are off each other by more than all.
    const T most_x = level_sine<T> / T(3) * spacing_x, most_z = level_sine<T> / T(3) * spacing_z;
    const T along_x = height(c + 1, r + odd) - height(c, r + odd),
            along_z = height(c + 1 - odd, r + 1) - height(c + 1 - odd, r);
    // Heights of holes are no numbers, of which no comparison is true.
    for (std::uint32_t i = 0; i < 4; ++i)
      for (std::uint32_t j = 0; j < 3; ++j) {
        const std::uint32_t row = r - 1 + i, column = c - 1 + i;
        const T of_row = height(c + j, row) - height(c - 1 + j, row),
                of_column = height(column, r + j) - height(column, r - 1 + j);
        if (!(std::abs(of_row - along_x) < most_x && std::abs(of_column - along_z) < most_z)) return false;
      }
    return true;
  }

  bool empty() const { return false; }
  std::size_t size() const { return std::size_t{2} * (columns - 1) * (rows - 1); }
  const Aabb<T>& bounds() const { return all; }
  Ref root() const { return {0, 0, static_cast<std::uint32_t>(levels.size())}; }
  bool leaf(const Ref& ref) const { return ref.level == 0; }

  Aabb<T> box(const Ref& ref) const { return box_of(ref, span(ref)); }

  void children(const Ref& ref, Children& out) const {
    const std::uint32_t level = ref.level - 1;
    const auto [end_column, end_row] = size_of(level);
    const std::uint32_t first_column = ref.column * side, first_row = ref.row * side;
    out.count = 0;
    for (std::uint32_t r = first_row; r < least(first_row + side, end_row); ++r)
      for (std::uint32_t c = first_column; c < least(first_column + side, end_column); ++c) {
        const Ref child{c, r, level};
        const Span s = span(child);
        if (s.low > s.high) continue;
        set_lane(out, out.count, child, box_of(child, s));
        ++out.count;
      }
    for (std::size_t i = out.count; i < width; ++i) set_lane(out, i, ref, Aabb<T>{});
  }

  template <class F>
  bool each_piece(const Ref& ref, F& f) const {
    const std::uint32_t number = 2 * (ref.row * (columns - 1) + ref.column);
    return go_on(f, number) && go_on(f, number + 1);
  }

  /// Calls `f(number)` for the triangles of the cells that a region reaches into, and perhaps of some beside it, holes
  /// left out; `f` may return false to end the visit. A few cells follow from the grid without a search.
  template <class F>
  bool each_at(const Aabb<T>& region, F& f) const {
    const auto [first_column, end_column] = cells_between(region.lower.x, region.upper.x, spacing_x, columns - 1);
    const auto [first_row, end_row] = cells_between(region.lower.z, region.upper.z, spacing_z, rows - 1);
    constexpr std::uint32_t few = 4;
    if (end_column - first_column > few || end_row - first_row > few)
      return visit(
          *this, region, [] { return T(0); }, f);
    for (std::uint32_t r = first_row; r < end_row; ++r)
      for (std::uint32_t c = first_column; c < end_column; ++c) {
        const Span s = cell(c, r);
        if (s.low <= s.high && !each_piece({c, r, 0}, f)) return false;
      }
    return true;
  }

 private:
  /// The cells, of a row or a column of `count`, that an interval reaches into, and one more on either side where
  /// rounding may hide that; all, if they have no width.
  static std::pair<std::uint32_t, std::uint32_t> cells_between(T low, T high, T spacing, std::uint32_t count) {
    if (!(spacing > T(0))) return {0, count};
    const T middle = T(count) / T(2), rounding = T(8) * std::numeric_limits<T>::epsilon() * T(count);
    const T first = clamp(std::floor(low / spacing + middle - rounding), T(0), T(count));
    const T end = clamp(std::floor(high / spacing + middle + rounding) + T(1), T(0), T(count));
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end)};
  }

  std::pair<std::uint32_t, std::uint32_t> size_of(std::uint32_t level) const {
    if (level == 0) return {columns - 1, rows - 1};
    return {levels[level - 1].columns, levels[level - 1].rows};
  }
  Span span(const Ref& ref) const {
    if (ref.level == 0) return cell(ref.column, ref.row);
    const Level& level = levels[ref.level - 1];
    return level.spans[std::size_t{ref.row} * level.columns + ref.column];
  }
  Aabb<T> box_of(const Ref& ref, const Span& s) const {
    const auto scaled = [&](std::uint32_t i, std::uint32_t end) {
      return static_cast<std::uint32_t>(least(std::uint64_t{i} << (2 * ref.level), std::uint64_t{end}));
    };
    return {{x(scaled(ref.column, columns - 1)), s.low, z(scaled(ref.row, rows - 1))},
            {x(scaled(ref.column + 1, columns - 1)), s.high, z(scaled(ref.row + 1, rows - 1))}};
  }
  static void set_lane(Children& out, std::size_t i, const Ref& ref, const Aabb<T>& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out.lower[axis][i] = box.lower[axis];
      out.upper[axis][i] = box.upper[axis];
    }
    out.ref[i] = ref;
  }
};

}  // namespace graze
