// Colours of contacts: pairs of one colour have no body in common that can be pushed, so that they may be solved on any
// threads, in any order, with the same bits.
//
// Guarantee: a function of the pairs in their order alone: each gets the first colour that neither of its bodies has
// yet (greedy colouring). A body that nothing pushes takes no colour. A pair for which no colour is left is put into
// the last, which is solved in order on one thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/islands.hpp"

namespace graze {

class Coloring {
 public:
  /// Pairs from `first` up to `end` of the order.
  struct Range {
    std::uint32_t first, end;
    bool ordered;  ///< of the last colour: pairs that share bodies
  };

  /// Colours the pairs. `movable[i]`: whether body i can be pushed.
  void find(std::span<const std::uint8_t> movable, std::span<const IslandLink> pairs);

  /// Places among the pairs, colour by colour, and in each in their own order.
  std::span<const std::uint32_t> order() const { return order_; }
  std::span<const Range> colors() const { return colors_; }

 private:
  std::vector<std::uint64_t> used_;  ///< colours of each body, as bits
  std::vector<std::uint8_t> color_;  ///< of each pair
  std::vector<std::uint32_t> order_;
  std::vector<Range> colors_;
};

}  // namespace graze
