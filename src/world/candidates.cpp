#include "graze/world/candidates.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace graze {

namespace {

/// The share of bodies that changed, one in so many, from which on finding all pairs anew costs less than finding
/// those of each body that moved in the tree: measured, the former takes some 90 ns a body and the latter about
/// 1000 ns a body that moved.
constexpr std::size_t few = 12;

}  // namespace

template <class T>
std::span<const IdPair> CandidateFinder<T>::find(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive,
                                                 std::span<const std::uint8_t> fixed,
                                                 std::span<const std::uint32_t> changes, Executor& executor) {
  if (changes.empty()) return pairs_;
  note_stale(boxes.size(), changes);
  if (changes.size() * few > boxes.size())
    find_all(boxes, alive, fixed, executor);
  else
    find_changed(boxes, alive, fixed);
  return pairs_;
}

template <class T>
void CandidateFinder<T>::note_stale(std::size_t bodies, std::span<const std::uint32_t> changes) {
  in_tree_.resize(bodies, 0);
  is_stale_.resize(bodies, 0);
  for (const std::uint32_t i : changes)
    if (std::exchange(is_stale_[i], 1) == 0) stale_.push_back(i);
}

template <class T>
const DynamicTree<T>& CandidateFinder<T>::tree(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive,
                                               std::span<const std::uint32_t> changes) {
  note_stale(boxes.size(), changes);
  for (const std::uint32_t i : stale_) {
    if (in_tree_[i] != 0 && alive[i] != 0)
      tree_.move(i, boxes[i]);
    else if (alive[i] != 0)
      tree_.insert(i, boxes[i]);
    else if (in_tree_[i] != 0)
      tree_.remove(i);
    in_tree_[i] = alive[i];
    is_stale_[i] = 0;
  }
  stale_.clear();
  return tree_;
}

template <class T>
void CandidateFinder<T>::find_all(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive,
                                  std::span<const std::uint8_t> fixed, Executor& executor) {
  const bool all_alive = std::find(alive.begin(), alive.end(), 0) == alive.end();
  if (all_alive && std::count(fixed.begin(), fixed.end(), 0) + 1 >= std::ssize(fixed))
    return finder_.find(boxes, pairs_, executor);
  compact_.clear();
  index_.clear();
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (alive[i] != 0) {
      compact_.push_back(boxes[i]);
      index_.push_back(i);
    }
  finder_.find(compact_, all_, executor);
  pairs_.resize(all_.size());
  // Places and indices are in the same order, so the pairs stay sorted. Each is written and kept or written over.
  std::size_t kept = 0;
  for (const IdPair& p : all_) {
    const IdPair pair{index_[p.a], index_[p.b]};
    pairs_[kept] = pair;
    kept += (fixed[pair.a] & fixed[pair.b]) == 0;
  }
  pairs_.resize(kept);
}

/// Keeps the pairs of bodies that the tree has in their places, and adds those that it finds of all others: of bodies
/// that moved now, or while all pairs were found anew in between.
template <class T>
void CandidateFinder<T>::find_changed(std::span<const Aabb<T>> boxes, std::span<const std::uint8_t> alive,
                                      std::span<const std::uint8_t> fixed) {
  std::erase_if(pairs_, [&](const IdPair& p) { return (is_stale_[p.a] | is_stale_[p.b]) != 0; });
  tree(boxes, alive, {});
  tree_.moved_pairs(moved_);
  std::erase_if(moved_, [&](const IdPair& p) { return (fixed[p.a] & fixed[p.b]) != 0; });
  merged_.clear();
  std::set_union(pairs_.begin(), pairs_.end(), moved_.begin(), moved_.end(), std::back_inserter(merged_));
  pairs_.swap(merged_);
}

template <class T>
std::size_t CandidateFinder<T>::memory() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return tree_.memory() + finder_.memory() + bytes(in_tree_) + bytes(is_stale_) + bytes(stale_) + bytes(compact_) +
         bytes(index_) + bytes(all_) + bytes(pairs_) + bytes(moved_) + bytes(merged_);
}

template class CandidateFinder<float>;
template class CandidateFinder<double>;

}  // namespace graze
