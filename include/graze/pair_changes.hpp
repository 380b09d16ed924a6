// Which pairs of boxes began and which ended to overlap, for callers who keep what they made of a pair from frame to
// frame.
//
// Guarantee: applied one after the other, the changes give the pairs of `BroadPhase::pairs`: what began was not there
// at the last call, what ended was. Sorted, the smaller id first; a function of the boxes and ids alone, whichever
// broad phase finds them. What did not move costs nothing but memory: a call costs the search for the pairs of what was
// inserted, moved or removed, and a look at each such pair of now and then.
#pragma once

#include <memory>
#include <vector>

#include "graze/broad_phase.hpp"
#include "graze/small_vector.hpp"

namespace graze {

/// A broad phase that tells what has changed. It keeps the pairs that it told.
template <class T>
class GRAZE_API PairChanges {
 public:
  /// Above a broad phase without boxes, which nobody else changes.
  explicit PairChanges(std::unique_ptr<BroadPhase<T>> boxes = make_dynamic_tree<T>()) : boxes_(std::move(boxes)) {}

  /// As those of `BroadPhase`. An id that is removed may be inserted anew before the next call.
  void insert(std::uint32_t id, const Aabb<T>& box);
  void remove(std::uint32_t id);                    ///< its pairs end
  void move(std::uint32_t id, const Aabb<T>& box);  ///< the box of `id` from now on

  /// The pairs that overlap and did not at the last call, and those that did and do not any more.
  void find(std::vector<IdPair>& begun, std::vector<IdPair>& ended);

  /// For everything that is asked.
  const BroadPhase<T>& boxes() const { return *boxes_; }
  /// Bytes that are held, with those of the broad phase; lists of more than eight partners of a box are left out.
  std::size_t memory() const;

 private:
  using Ids = SmallVector<std::uint32_t, 8>;

  void touch(std::uint32_t id);
  void gather_pairs_of_touched();
  void compare(std::uint32_t id, std::vector<IdPair>& begun, std::vector<IdPair>& ended);

  std::unique_ptr<BroadPhase<T>> boxes_;
  std::vector<Ids> told_;               ///< by id, those that overlapped it at the last call, in ascending order
  std::vector<Ids> now_;                ///< the same now, of what was touched
  std::vector<std::uint32_t> touched_;  ///< what was inserted, moved or removed since
  std::vector<char> is_touched_;        ///< by id
  std::vector<IdPair> found_;
};

}  // namespace graze
