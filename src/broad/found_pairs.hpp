// The arrays into which kernels put the pairs that they find.
//
// Guarantee: grows as needed, up to a limit where one is set, and keeps its memory for the next frame.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad/row_kernels.hpp"
#include "graze/broad_phase.hpp"

namespace graze {

/// Pairs as kernels take them: two places each.
inline std::uint32_t* numbers(std::span<IdPair> pairs) {
  static_assert(sizeof(IdPair) == 2 * sizeof(std::uint32_t));
  return reinterpret_cast<std::uint32_t*>(pairs.data());
}
inline const std::uint32_t* numbers(std::span<const IdPair> pairs) {
  return reinterpret_cast<const std::uint32_t*>(pairs.data());
}

class FoundPairs {
 public:
  /// Empties the arrays. Kernels stop at some number of pairs between `most` and four times as many: then `is_full`,
  /// and the pairs that are held are of no use.
  void clear(std::size_t most = ~std::size_t{0}) { count_ = 0, most_ = most, is_full_ = false; }
  bool is_full() const { return is_full_; }
  /// A sink for one kernel or several; give it to `take` before the next use of this object.
  PairSink sink() {
    return {first_.data(),
            second_.data(),
            count_,
            first_.size(),
            [](PairSink& s) {
              static_cast<FoundPairs*>(s.owner)->grow(s); },
            this};
  }
  void take(const PairSink& sink) { count_ = sink.count; }

  std::span<const std::uint32_t> first() const { return {first_.data(), count_}; }
  std::span<const std::uint32_t> second() const { return {second_.data(), count_}; }

  void add(std::uint32_t first, std::uint32_t second) {
    PairSink s = sink();
    if (count_ == s.capacity) grow(s);
    first_[count_] = first, second_[count_++] = second;
  }
  /// Drops, of the pairs from `from` on, all but those for which `keep(first, second)` holds; `fetch(second)` is called
  /// some pairs ahead.
  template <class Keep, class Fetch>
  void keep_if(std::size_t from, const Keep& keep, const Fetch& fetch) {
    constexpr std::size_t pairs_ahead = 16;
    std::size_t kept = from;
    for (std::size_t i = from; i < count_; ++i) {
      fetch(second_[std::min(i + pairs_ahead, count_ - 1)]);
      const std::uint32_t a = first_[i], b = second_[i];
      first_[kept] = a, second_[kept] = b;
      kept += keep(a, b) ? 1 : 0;
    }
    count_ = kept;
  }

  std::size_t memory() const { return (first_.capacity() + second_.capacity()) * sizeof(std::uint32_t); }

 private:
  static constexpr std::size_t first_room = 1024;

  void grow(PairSink& s) {
    if (first_.size() / 2 >= most_ && !first_.empty()) {
      s.count = 0, s.is_full = is_full_ = true;
      return;
    }
    const std::size_t more = std::max(first_room, first_.size() * 2);
    first_.resize(more), second_.resize(more);
    s.first = first_.data(), s.second = second_.data(), s.capacity = more;
  }

  std::vector<std::uint32_t> first_, second_;
  std::size_t count_ = 0, most_ = ~std::size_t{0};
  bool is_full_ = false;
};

}  // namespace graze
