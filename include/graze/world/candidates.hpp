// The second stage of a world: which bodies' bounds overlap.
//
// Guarantee: exactly the pairs of bodies that are alive and whose boxes overlap, sorted: a function of the boxes alone,
// whichever structure found them. Work proportional to what moved while that is little, else N log N.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "graze/broad_phase.hpp"
#include "graze/pairs.hpp"

namespace graze {

template <class T>
class CandidateFinder {
 public:
  CandidateFinder();

  /// `boxes` and `alive` by index of body; `changes` the indices, sorted, that are new, gone or elsewhere since the last
  /// call.
  std::span<const IdPair> find(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive,
                               std::span<const std::uint32_t> changes);

  /// All boxes as of the last `find`, for queries.
  const BroadPhase<T>& tree() const { return *tree_; }

  std::size_t memory() const;

 private:
  void update_tree(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive,
                   std::span<const std::uint32_t> changes);
  void find_all(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive);
  void find_changed(std::span<const std::uint32_t> changes);

  std::unique_ptr<BroadPhase<T>> tree_;
  PairFinder<T> finder_;
  std::vector<std::uint8_t> in_tree_;
  std::vector<Aabb<T>> compact_;
  std::vector<std::uint32_t> index_;
  std::vector<IdPair> pairs_, moved_, merged_;
};

}  // namespace graze
