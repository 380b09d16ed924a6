// All overlapping pairs of many boxes at once, without any memory of the last frame.
//
// Boxes are sorted into the rows of a grid (row_grid.hpp), and each row is swept with itself and the four rows ahead of
// it: no box reaches further. Boxes much longer than others go to a level of their own with larger strips, and are
// swept over the rows below it; a box that overlaps a good part of all others is left to be compared with all of them
// (wide_boxes.hpp). Pairs are sorted at the end (pair_order.hpp).
//
// Guarantee: exactly the overlapping pairs of closed boxes but those left so, sorted; a function of the boxes alone.
// Cost N log N for any sizes and places, and the number of pairs; each level has at most half the boxes of the one
// below. No allocation where a frame needs no more room than those before.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "broad/found_pairs.hpp"
#include "broad/pair_order.hpp"
#include "broad/row_grid.hpp"
#include "graze/broad_phase.hpp"

namespace graze {

/// Whether a grid can hold the box: differences of such coordinates are finite.
template <class T>
bool is_bounded(const Aabb<T>& box) {
  constexpr T most = std::numeric_limits<T>::max() / T(4);
  return greatest(max_abs(box.lower), max_abs(box.upper)) <= most;
}

template <class T>
class RowSweep {
 public:
  /// Runs at `level`, which must be available.
  explicit RowSweep(Isa level = chosen_isa()) : isa_(level) {}

  /// Looks for all pairs but those of boxes at `wide`. Gives up and returns false where there turn out to be some times
  /// more than `most`.
  bool find(std::span<const Aabb<T>> boxes, std::size_t most = ~std::size_t{0});
  /// Writes the pairs of places that `find` found, sorted, the smaller place first.
  void sort_into(std::vector<IdPair>& out);

  /// Adds the pairs among the boxes at `places`, which must be bounded, in any order.
  void find_among(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, FoundPairs& found);
  /// Adds the pairs of the boxes at `places`, which must be bounded, with those that `find` was last given, the latter
  /// second and in any order; but not with those at `wide`.
  void find_over(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, FoundPairs& found);
  /// The boxes that the last `find` left to be compared with all others (wide_boxes.hpp), in ascending order.
  std::span<const std::uint32_t> wide() const { return wide_; }

  std::size_t memory() const;

 private:
  bool all_alike(std::span<const Aabb<T>> boxes, Spans<T>& spans);
  Spans<T> split(std::span<const Aabb<T>> boxes);
  void sweep(std::span<const Aabb<T>> boxes, std::size_t level, PairSink& sink);
  void sweep_over_level(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, std::size_t level,
                        PairSink& sink);

  Isa isa_;
  std::vector<RowGrid<T>> levels_;
  std::size_t level_count_ = 0;  ///< those in use
  std::vector<std::uint32_t> members_, larger_;
  std::vector<std::uint32_t> wide_;
  std::size_t box_count_ = 0;  ///< of the last `find`
  std::vector<SweptOver<T>> over_;
  std::vector<std::uint64_t> by_row_, scratch_;
  FoundPairs found_;
  PairOrder order_;
};

}  // namespace graze
