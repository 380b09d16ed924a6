// Sorting pairs of ids.
//
// Guarantee: linear in pairs and ids where ids lie close together, n log n otherwise.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "graze/broad_phase.hpp"

namespace graze {

class PairSort {
 public:
  /// Sorts the pairs. `ids`: the number of ids that there may be.
  void operator()(std::vector<IdPair>& pairs, std::size_t ids) {
    std::uint32_t largest = 0, largest_b = 0;
    for (const IdPair& pair : pairs) {
      largest = std::max(largest, pair.a);
      largest_b = std::max(largest_b, pair.b);
    }
    // Counters for ids that are not there cost a store each, a comparison sort some twenty comparisons a pair.
    if (largest_b / 4 > ids || pairs.size() * 16 < largest) return std::sort(pairs.begin(), pairs.end());
    bits_.resize(std::max<std::size_t>(bits_.size(), largest_b / 64 + 1));
    words_.resize(bits_.size() / 64 + 1);
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
    return begin_.capacity() * sizeof(std::size_t) + second_.capacity() * sizeof(std::uint32_t) +
           (bits_.capacity() + words_.capacity()) * sizeof(std::uint64_t);
  }

 private:
  void sort(std::size_t from, std::size_t end) {
    constexpr std::size_t few = 24;
    if (end - from > few) return sort_by_bits(from, end);
    for (std::size_t i = from; i < end; ++i) {
      const std::uint32_t b = second_[i];
      std::size_t j = i;
      for (; j > from && second_[j - 1] > b; --j) second_[j] = second_[j - 1];
      second_[j] = b;
    }
  }
  /// Sorts the partners of a box that overlaps many: one bit an id, one for each 64 of these, and then the bits in
  /// order.
  void sort_by_bits(std::size_t from, std::size_t end) {
    const auto bit = [](std::size_t i) { return std::uint64_t{1} << i % 64; };
    const auto lowest = [](std::uint64_t word) { return static_cast<std::size_t>(std::countr_zero(word)); };
    for (std::size_t i = from; i < end; ++i) {
      const std::size_t word = second_[i] / 64;
      bits_[word] |= bit(second_[i]);
      words_[word / 64] |= bit(word);
    }
    for (std::size_t w = 0; from < end; ++w)
      for (std::uint64_t words = std::exchange(words_[w], 0); words != 0; words &= words - 1) {
        const std::size_t word = w * 64 + lowest(words);
        for (std::uint64_t left = std::exchange(bits_[word], 0); left != 0; left &= left - 1)
          second_[from++] = static_cast<std::uint32_t>(word * 64 + lowest(left));
      }
  }

  std::vector<std::size_t> begin_;  ///< of each id's pairs, and while they are dealt out where the next goes
  std::vector<std::uint32_t> second_;
  std::vector<std::uint64_t> bits_, words_;  ///< all 0 between uses
};

}  // namespace graze
