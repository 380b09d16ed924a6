// All overlapping pairs of many boxes at once, without any memory of the last frame.
//
// Boxes are binned into the rows of a grid over Y and Z by their lower corner, sorted along X within a row, and each row
// is swept with itself and the four rows ahead of it: no box of a cell's size reaches further. What is larger than a
// cell goes to a level of its own with larger cells, and is swept over the rows below it. Everything is sorted by radix
// into arrays of one coordinate each.
//
// Guarantee: exactly the overlapping pairs of closed boxes, sorted; a function of the boxes alone. Cost N log N for any
// sizes and places, and the number of pairs; each level has at most half the boxes of the one below.
#pragma once

#include <span>
#include <vector>

#include "broad/radix_sort.hpp"
#include "graze/broad_phase.hpp"

namespace graze {

template <class T>
class RowSweep {
 public:
  /// The pairs of places in `boxes`, sorted, the smaller first.
  void find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out);

  std::size_t memory() const;

 private:
  /// Boxes of about one size: sorted by row and then along X, a coordinate an array.
  struct Level {
    std::vector<T> lower_x, upper_x, lower_y, upper_y, lower_z, upper_z;
    std::vector<std::uint32_t> place;
    struct Row {
      std::int32_t y, z;
      std::uint32_t begin, end;
    };
    std::vector<Row> rows;
    T cell{};
    Vec3<T> origin{};
    std::size_t memory() const;
  };

  void build(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, Level& level);
  void sort_into_rows(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, Level& level);
  void sweep_level(const Level& level);
  void sweep_row(const Level& level, std::uint32_t begin, std::uint32_t end);
  void sweep_rows(const Level& level, const typename Level::Row& r, const typename Level::Row& s);
  void test_range(const Level& level, std::uint32_t i, std::uint32_t from, std::uint32_t end);
  void sweep_over(const Level& level, const Aabb<T>& box, std::uint32_t place);
  void sweep_unbounded(std::span<const Aabb<T>> boxes);
  void sort_pairs(std::size_t boxes, std::vector<IdPair>& out);

  std::vector<Level> levels_;
  std::vector<std::uint32_t> small_, large_, unbounded_;
  std::vector<KeyedPlace> items_, scratch_;
  std::vector<IdPair> found_;
  std::vector<std::uint32_t> begins_;
};

}  // namespace graze
