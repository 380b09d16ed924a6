// All overlapping pairs of many boxes at once, without any memory of the last frame.
//
// Boxes are sorted into the rows of a grid (row_grid.hpp), and each row is swept with itself and the four rows ahead of
// it: no box reaches further. What is much longer than others goes to a level of its own with larger strips, and is
// swept over the rows below it; or, where it overlaps a good part of everything, is compared with everything
// (wide_boxes.hpp). Pairs are sorted at the end (pair_order.hpp).
//
// Guarantee: exactly the overlapping pairs of closed boxes, sorted; a function of the boxes alone. Cost N log N for any
// sizes and places, and the number of pairs; each level has at most half the boxes of the one below. No allocation
// where a frame needs no more room than those before.
#pragma once

#include <span>
#include <vector>

#include "broad/pair_order.hpp"
#include "broad/row_grid.hpp"
#include "broad/wide_boxes.hpp"
#include "graze/broad_phase.hpp"

namespace graze {

template <class T>
class RowSweep {
 public:
  /// Runs at `level`, which must be available.
  explicit RowSweep(Isa level = chosen_isa()) : isa_(level) {}

  /// The pairs of places in `boxes`, sorted, the smaller first.
  void find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out);

  std::size_t memory() const;

 private:
  bool all_alike(std::span<const Aabb<T>> boxes, Spans<T>& spans);
  Spans<T> split(std::span<const Aabb<T>> boxes);
  void sweep(std::span<const Aabb<T>> boxes, std::size_t level, PairSink& sink);

  Isa isa_;
  std::vector<RowGrid<T>> levels_;
  std::vector<std::uint32_t> members_, larger_;
  std::vector<std::uint32_t> wide_;  ///< that are compared with all others
  std::vector<SweptOver<T>> over_;
  std::vector<std::uint32_t> first_, second_;  ///< the pairs as they are found
  std::vector<IdPair> inner_;                  ///< the sorted pairs of others than the wide ones
  PairOrder order_;
  WideBoxes<T> compare_wide_;
};

}  // namespace graze
