// Changes of overlapping pairs from call to call, for callers who keep data for a pair from frame to frame.
//
// Guarantee: applied one after the other, the changes give the pairs of `BroadPhase::pairs`: a begun pair was absent at
// the last call, an ended one present. Sorted, the smaller id first; a function of the boxes and ids alone, whichever
// broad phase finds them. Boxes at rest cost nothing but memory: a call costs the search for the pairs of inserted,
// moved and removed boxes, and a look at each such pair of the last call and of this one.
#pragma once

#include <memory>
#include <vector>

#include "graze/broad_phase.hpp"
#include "graze/small_vector.hpp"

namespace graze {

/// A broad phase that reports changes of its pairs. Keeps the pairs of the last call.
template <class T>
class GRAZE_API PairChanges {
 public:
  /// Takes over a broad phase without boxes, which no other code may change.
  explicit PairChanges(std::unique_ptr<BroadPhase<T>> boxes = make_dynamic_tree<T>()) : boxes_(std::move(boxes)) {}

  /// Adds a box, as `BroadPhase::insert` does. The id of a removed box may be inserted anew before the next call of
  /// `find`.
  void insert(std::uint32_t id, const Aabb<T>& box);
  void remove(std::uint32_t id);                    ///< removes a box, whose pairs end
  void move(std::uint32_t id, const Aabb<T>& box);  ///< replaces the box of `id`

  /// Sets `begun` to the pairs that overlap and did not at the last call, and `ended` to those that did and do not any
  /// more.
  void find(std::vector<IdPair>& begun, std::vector<IdPair>& ended);

  /// The broad phase, for its queries.
  const BroadPhase<T>& boxes() const { return *boxes_; }
  /// Bytes that are held, the broad phase included; lists of more than eight partners of a box are left out.
  std::size_t memory() const;

 private:
  using Ids = SmallVector<std::uint32_t, 8>;

  void touch(std::uint32_t id);
  void gather_pairs_of_touched();
  void compare(std::uint32_t id, std::vector<IdPair>& begun, std::vector<IdPair>& ended);

  std::unique_ptr<BroadPhase<T>> boxes_;
  std::vector<Ids> told_;               ///< by id: the ids that overlapped it at the last call, in ascending order
  std::vector<Ids> now_;                ///< by id of a touched box: the ids that overlap it now
  std::vector<std::uint32_t> touched_;  ///< boxes that were inserted, moved or removed since the last call
  std::vector<char> is_touched_;        ///< by id, whether it is in `touched_`
  std::vector<IdPair> found_;
};

}  // namespace graze
