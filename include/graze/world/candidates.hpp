// The second stage of a world: pairs of bodies whose bounds overlap.
//
// Guarantee: exactly the pairs of bodies that are alive, not both fixed, and whose boxes overlap, sorted: a function of
// these alone, whichever structure found them. While little moves, the work is proportional to the moved bodies and the
// pairs (fixed bodies have none among themselves); else N log N.
#pragma once

#include <span>
#include <vector>

#include "graze/dynamic_tree.hpp"
#include "graze/pairs.hpp"

namespace graze {

/// Finds the pairs whose boxes overlap.
template <class T>
class GRAZE_API CandidateFinder {
 public:
  /// The overlapping pairs. `boxes`, `alive` and `fixed` are by index of body; `changes` holds the indices, sorted,
  /// that are new, gone or elsewhere since the last call.
  std::span<const IdPair> find(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive,
                               std::span<const std::uint8_t> fixed, std::span<const std::uint32_t> changes,
                               Executor& executor);
  /// The tree of the boxes, as the last call left it.
  const DynamicTree<T>& tree() const { return tree_; }

  /// The boxes of all living bodies, for queries: brought up to date for the changes given to `find` and for `changes`.
  /// Must not be called from several threads at a time; the tree itself may be read from several.
  const DynamicTree<T>& tree(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive,
                             std::span<const std::uint32_t> changes);

  std::size_t memory() const;

 private:
  void note_stale(std::size_t bodies, std::span<const std::uint32_t> changes);
  void find_all(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive,
                std::span<const std::uint8_t> fixed, Executor& executor);
  void find_changed(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive,
                    std::span<const std::uint8_t> fixed);

  DynamicTree<T> tree_;
  PairFinder<T> finder_;
  std::vector<std::uint8_t> in_tree_, is_stale_;
  std::vector<std::uint32_t> stale_;  ///< indices that are out of date in the tree
  std::vector<Aabb<T>> compact_;
  std::vector<std::uint32_t> index_;
  std::vector<IdPair> all_, pairs_, moved_, merged_;
};

}  // namespace graze
