// From bounds to the pairs worth asking about: candidates, then filters.
//
// Guarantee: every pair whose bounds overlap and whose filters and predicate agree, each once, sorted; nothing is
// dropped, whatever the number. Both stages can be used alone.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "graze/broad_phase.hpp"
#include "graze/executor.hpp"
#include "graze/filter.hpp"

namespace graze {

template <class T>
class KeptPairs;

/// All overlapping pairs of many boxes, frame after frame; see `BroadPhase` for structures that also answer queries.
/// Remembers the pairs of boxes with some room around them, which serve for as long as most boxes stay in it: what
/// stands still or drifts then costs an eighth of finding all anew. What moves far is found in the rows of a grid over
/// two axes, swept along the third. The answer is a function of the boxes alone, whatever is remembered.
template <class T>
class GRAZE_API PairFinder {
 public:
  PairFinder();
  ~PairFinder();
  PairFinder(PairFinder&&) noexcept;             ///< takes over what the other one holds
  PairFinder& operator=(PairFinder&&) noexcept;  ///< takes over what the other one holds

  /// The pairs of places in `boxes`, sorted, the smaller first. Boxes with lower <= upper; infinite ones cost a look at
  /// all others. Cost N log N for any sizes and places, and the number of pairs; no allocation where a frame needs no
  /// more room than those before. Compares 4 to 16 boxes at a time, as the machine can (environment variable GRAZE_ISA:
  /// baseline, avx2 or avx512 forces how many); the pairs are the same.
  void find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out);
  /// The same pairs; those of a frame in which little moved are found by as many threads as `executor` has.
  void find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out, Executor& executor);

  /// Bytes that are held for the next frame: some 270 a box in single precision, twice as many in double.
  std::size_t memory() const;

 private:
  std::unique_ptr<KeptPairs<T>> kept_;
};

/// Drops from `pairs` those that their filters (`filters[id]`) or `predicate(a, b)` forbid; keeps the order.
template <class Predicate>
void keep_allowed(std::vector<IdPair>& pairs, std::span<const Filter> filters, const Predicate& predicate) {
  std::erase_if(pairs,
                [&](const IdPair& p) { return !may_collide(filters[p.a], filters[p.b]) || !predicate(p.a, p.b); });
}

}  // namespace graze
