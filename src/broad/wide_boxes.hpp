// Pairs of boxes that overlap a good part of all others, or that no grid can hold.
//
// Such boxes are compared with all others in the order of places, a register at a time, so that their pairs come about
// in the wanted order: nothing is left to sort, and pairs of other boxes are put in where their turn is.
//
// Guarantee: exactly the overlapping pairs in which at least one is such a box. Cost: their number times that of all
// boxes over the lanes.
#pragma once

#include <span>
#include <vector>

#include "broad/row_kernels.hpp"
#include "graze/broad_phase.hpp"

namespace graze {

template <class T>
class WideBoxes {
 public:
  /// Whether comparing those at `some` with all boxes is cheaper than looking for their pairs and sorting them. A
  /// guess, from a thousand pairs; it depends on the boxes alone.
  static bool worthwhile(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> some);

  /// Writes the pairs of those at `wide`, which ascend, together with `others`: sorted pairs of other boxes, not in
  /// `out`.
  void merge(Isa level, std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> wide,
             std::span<const IdPair> others, std::vector<IdPair>& out);

  std::size_t memory() const;

 private:
  /// Boxes in an order of their own, a coordinate an array.
  struct Columns {
    std::vector<T> bounds[6];
    std::vector<std::uint32_t> place;
    void fill(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places);
    Rows<T> rows() const;
    std::size_t memory() const;
  };

  Columns all_, wide_;
  std::vector<std::uint32_t> places_;
  std::vector<std::uint32_t> ranks_;
};

}  // namespace graze
