// From bounds to the pairs worth testing: candidates, then filters.
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

/// Finder of all overlapping pairs of many boxes, frame after frame; `BroadPhase` has structures that also answer
/// queries. Keeps the pairs of boxes enlarged by some room, which serve as long as most boxes stay in it: a scene that
/// stands still or drifts then costs an eighth of a complete search. Boxes that move far are found in the rows of a
/// grid over two axes, swept along the third. The answer is a function of the boxes alone, whatever is kept.
template <class T>
class GRAZE_API PairFinder {
 public:
  PairFinder();
  ~PairFinder();
  PairFinder(PairFinder&&) noexcept;             ///< takes over what the other one holds
  PairFinder& operator=(PairFinder&&) noexcept;  ///< takes over what the other one holds

  /// Sets `out` to the pairs of indices into `boxes` whose boxes overlap, sorted, the smaller first. Boxes need lower
  /// <= upper; infinite ones are compared with all others. Cost N log N for any sizes and places, and the number of
  /// pairs; no allocation where a frame needs no more room than those before. Compares 4 to 16 boxes at a time, as the
  /// machine can (environment variable GRAZE_ISA: baseline, avx2 or avx512 sets how many); the pairs are the same.
  void find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out);
  /// Equals the function above, with the threads of `executor` for frames in which little moved.
  void find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out, Executor& executor);

  /// Bytes that are kept for the next frame: some 270 a box in single precision, twice as many in double.
  std::size_t memory() const;

 private:
  std::unique_ptr<KeptPairs<T>> kept_;
};

/// Removes from `pairs` those that their filters (`filters[id]`) or `predicate(a, b)` forbid; keeps the order.
template <class Predicate>
void keep_allowed(std::vector<IdPair>& pairs, std::span<const Filter> filters, const Predicate& predicate) {
  std::erase_if(pairs,
                [&](const IdPair& p) { return !may_collide(filters[p.a], filters[p.b]) || !predicate(p.a, p.b); });
}

}  // namespace graze
