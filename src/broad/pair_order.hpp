// Puts found pairs in order: by the smaller place, then by the larger.
//
// Guarantee: linear in boxes and pairs for the places that spatial scenes give, N log N for any. Memory is kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "graze/broad_phase.hpp"

namespace graze {

/// A number that orders pairs as they are put in order.
inline std::uint64_t order_key(const IdPair& p) { return std::uint64_t{p.a} << 32 | p.b; }

class PairOrder {
 public:
  /// Sorts the pairs of `first[i]` and `second[i]` into `to`, each with the smaller place first. Places are below
  /// `boxes`.
  void sort(std::span<const std::uint32_t> first, std::span<const std::uint32_t> second, std::size_t boxes, IdPair* to);

  std::size_t memory() const;

 private:
  template <class Source>
  void sort_bucket(const Source& source, std::size_t count, std::uint32_t lowest, std::uint32_t places, IdPair* to,
                   std::size_t boxes);
  void sort_many(IdPair* pairs, std::size_t count, std::size_t boxes);

  std::vector<IdPair> scratch_;
  std::vector<std::size_t> begins_;      ///< where the pairs of a bucket begin
  std::vector<std::uint32_t> counts_;    ///< of pairs, by the smaller place within a bucket
  std::vector<std::uint64_t> is_there_;  ///< a bit for each place
};

}  // namespace graze
