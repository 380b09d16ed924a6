// Sorting pairs of ids.
//
// Guarantee: linear in pairs and ids where ids lie close together and each is in few pairs, n log n otherwise.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "graze/broad_phase.hpp"

namespace graze {

class PairSort {
 public:
  /// `ids` is how many ids there may be.
  void operator()(std::vector<IdPair>& pairs, std::size_t ids) {
    std::uint32_t largest = 0;
    for (const IdPair& pair : pairs) largest = std::max(largest, pair.a);
    // Counters for ids that are not there cost a store each, a comparison sort some twenty comparisons a pair.
    if (largest / 4 > ids || pairs.size() * 16 < largest) return std::sort(pairs.begin(), pairs.end());
    begin_.assign(std::size_t{largest} + 2, 0);
    for (const IdPair& pair : pairs) ++begin_[pair.a + 1];
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    second_.resize(pairs.size());
    for (const IdPair& pair : pairs) second_[begin_[pair.a]++] = pair.b;
    std::size_t from = 0;
    for (std::uint32_t a = 0; a <= largest; ++a) {
      const std::size_t end = begin_[a];
      sort(from, end);
      for (; from < end; ++from) pairs[from] = {a, second_[from]};
    }
  }
  std::size_t memory() const {
    return begin_.capacity() * sizeof(std::size_t) + second_.capacity() * sizeof(std::uint32_t);
  }

 private:
  void sort(std::size_t from, std::size_t end) {
    constexpr std::size_t few = 16;
    const auto at = [&](std::size_t i) { return second_.begin() + static_cast<std::ptrdiff_t>(i); };
    if (end - from > few) return std::sort(at(from), at(end));
    for (std::size_t i = from; i < end; ++i) {
      const std::uint32_t b = second_[i];
      std::size_t j = i;
      for (; j > from && second_[j - 1] > b; --j) second_[j] = second_[j - 1];
      second_[j] = b;
    }
  }

  std::vector<std::size_t> begin_;  ///< of each id's pairs, and while they are dealt out where the next goes
  std::vector<std::uint32_t> second_;
};

}  // namespace graze
