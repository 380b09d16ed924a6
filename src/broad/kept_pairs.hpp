// The pairs of a frame from those of frames before: a list of the pairs of boxes with some room around them stays
// complete for as long as each box is in its room, and is in order already (Verlet 1967, "Computer experiments on
// classical fluids", the neighbour lists).
//
// A frame in which all boxes are in their rooms costs one look at each and one comparison for each pair of the list.
// The pairs of boxes that have left their rooms are looked for (row_sweep.hpp) among themselves and with all others;
// where they are many, the list is made anew; and where boxes move so far between frames that it would not last, all
// pairs are found without one. Boxes that overlap a good part of all others stay out of the list, which would be long
// with them, and are compared with all boxes in each frame (wide_boxes.hpp); but for a floor or two.
//
// Guarantee: exactly the overlapping pairs of closed boxes, sorted; a function of the boxes alone, since the list only
// says where to look.
#pragma once

#include <span>
#include <vector>

#include "broad/found_pairs.hpp"
#include "broad/pair_order.hpp"
#include "broad/row_sweep.hpp"
#include "broad/wide_boxes.hpp"
#include "graze/broad_phase.hpp"
#include "graze/executor.hpp"

namespace graze {

template <class T>
class KeptPairs {
 public:
  /// Runs at `level`, which must be available.
  explicit KeptPairs(Isa level = chosen_isa()) : isa_(level), all_(level), left_sweep_(level) {}

  /// The pairs of places in `boxes`, sorted, the smaller first. The list is gone through by as many threads as
  /// `executor` has.
  void find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out, Executor& executor);

  /// Whether the last frame left a list for the next one.
  bool has_list() const { return has_list_; }

  std::size_t memory() const;

 private:
  bool find_by_list(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out, Executor& executor);
  void fit_list(std::size_t boxes);
  void find_pairs_of_left(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> left);
  void keep_overlapping_ones(std::span<const Aabb<T>> boxes, const std::uint64_t* dropped, std::vector<IdPair>& out,
                             Executor& executor);
  void keep_side_by_side(std::span<const Aabb<T>> boxes, const std::uint64_t* dropped, std::vector<IdPair>& out,
                         Executor& executor);
  void merge_found(std::size_t boxes, std::vector<IdPair>& out);
  bool is_worth_a_list(std::span<const Aabb<T>> boxes);
  T room_of_most(std::span<const Aabb<T>> boxes);
  void make_list(std::span<const Aabb<T>> boxes);
  void find_anew(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out);
  void compare_apart(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out);
  std::vector<IdPair>& not_apart(std::vector<IdPair>& out) { return apart_.empty() ? out : inner_; }
  void end_list();
  void pause();
  void take_samples(std::span<const Aabb<T>> boxes);

  Isa isa_;
  RowSweep<T> all_, left_sweep_;
  std::vector<Aabb<T>> rooms_;
  std::vector<IdPair> list_;  ///< the pairs of rooms that overlap
  bool has_list_ = false;
  std::vector<std::uint32_t> apart_;  ///< those that are compared with all others, in ascending order
  std::size_t apart_pairs_ = 0;       ///< of those, when the list was made
  std::vector<IdPair> inner_;         ///< the frame's other pairs
  WideBoxes<T> wide_;
  std::size_t frames_ = 0;            ///< in which the list was of use
  std::size_t wait_ = 0, pause_ = 0;  ///< frames until the next list is tried, and how many there were the last time
  std::size_t last_count_ = 0;        ///< of pairs in the last frame, those apart left out
  std::vector<Aabb<T>> samples_;      ///< some boxes of the last frame
  std::size_t sampled_ = 0;           ///< out of so many
  std::vector<T> lengths_;
  std::vector<std::uint32_t> left_;      ///< the boxes that are not in their rooms
  std::vector<std::uint64_t> has_left_;  ///< a bit for each
  FoundPairs found_;
  PairOrder order_;
  std::vector<IdPair> of_left_;
  std::vector<IdPair> kept_;                            ///< by several threads, with gaps
  std::vector<std::size_t> kept_counts_, kept_places_;  ///< of each task
};

}  // namespace graze
