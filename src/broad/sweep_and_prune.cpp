#include <algorithm>
#include <iterator>

#include "broad/boxes.hpp"

namespace graze {

namespace {

/// Above this share of new boxes everything is sorted anew: a new box passes all ends on its way in from the far end
/// of the lists, so k of them cost k * 2n exchanges, and sorting costs about 2n * log2(2n) comparisons.
constexpr std::size_t max_new_share = 256;  // one in so many
/// Exchanges per end and axis after which sorting-in is given up for sorting anew. One exchange with its tests costs
/// a few comparisons of a sort, which makes about 16 per end for 10,000 boxes; measured, the two break even near here.
constexpr std::size_t max_exchanges = 24;

/// Keeps, from call to call, the ends of all boxes sorted along each axis and the pairs that overlap. Both are brought
/// up to date by a search for pairs. Queries look at all boxes: a sorted axis halves that at best.
template <class T>
class SweepAndPrune final : public BroadPhase<T> {
 public:
  void insert(std::uint32_t id, const Aabb<T>& box) override {
    boxes_.insert(id, box);
    slot_at_.push_back(take_slot());
    slots_[slot_at_.back()] = {unknown(), static_cast<std::uint32_t>(slot_at_.size() - 1)};
    fresh_.push_back(slot_at_.back());
  }
  void remove(std::uint32_t id) override {
    const std::uint32_t hole = boxes_.remove(id);
    slots_[slot_at_[hole]].place = nowhere;
    gone_.push_back(slot_at_[hole]);
    gone_ids_.push_back(id);
    slot_at_[hole] = slot_at_.back();
    slot_at_.pop_back();
    if (hole < slot_at_.size()) slots_[slot_at_[hole]].place = hole;
  }
  void move(std::uint32_t id, const Aabb<T>& box) override {
    boxes_.move(id, box);
    stale_ = true;
  }

  void pairs(std::vector<IdPair>& out) override {
    update();
    out = pairs_;
    boxes_.settle();
  }
  void moved_pairs(std::vector<IdPair>& out) override {
    update();
    out.clear();
    std::copy_if(pairs_.begin(), pairs_.end(), std::back_inserter(out),
                 [&](const IdPair& pair) { return moved(pair.a) || moved(pair.b); });
    boxes_.settle();
  }

  std::uint64_t tests() const override { return tests_; }

  void query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const override {
    boxes_.collect(out, [&](const Aabb<T>& other) { return overlap(other, box); });
  }
  void sweep(const Aabb<T>& box, const Vec3<T>& motion, std::vector<std::uint32_t>& out) const override {
    boxes_.collect(out, SweptBox<T>(box, motion));
  }
  std::size_t memory() const override {
    return boxes_.memory() + slots_.capacity() * sizeof(Slot) + 3 * ends_[0].capacity() * sizeof(End) +
           (pairs_.capacity() + begun_.capacity() + ended_.capacity() + merged_.capacity()) * sizeof(IdPair) +
           (slot_at_.capacity() + free_.capacity() + fresh_.capacity() + gone_.capacity() + gone_ids_.capacity() +
            active_.capacity()) *
               sizeof(std::uint32_t);
  }

 private:
  static constexpr std::uint32_t nowhere = ~0u;

  /// The box that an end belongs to: a slot stays when places change.
  struct Slot {
    Aabb<T> known;        ///< the box at the last update; NaN before the first
    std::uint32_t place;  ///< in the table, or nowhere
  };
  struct End {
    T value;
    std::uint32_t slot;
    bool upper;

    /// Lower ends before upper ones of the same value, so that boxes that touch overlap.
    bool operator<(const End& other) const {
      return value < other.value || (value == other.value && !upper && other.upper);
    }
  };

  /// A box that overlaps nothing. The empty box would not do: it overlaps all of space, by its infinite ends.
  static constexpr Aabb<T> unknown() {
    constexpr T nan = std::numeric_limits<T>::quiet_NaN();
    return {{nan, nan, nan}, {nan, nan, nan}};
  }
  std::uint32_t take_slot() {
    if (free_.empty()) {
      slots_.emplace_back();
      return static_cast<std::uint32_t>(slots_.size() - 1);
    }
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    return slot;
  }
  bool moved(std::uint32_t id) const { return boxes_[boxes_.place(id)].moved; }
  const Aabb<T>& box_of(std::uint32_t slot) const { return boxes_[slots_[slot].place].box; }
  IdPair ids_of(std::uint32_t s, std::uint32_t t) const {
    return ordered(boxes_[slots_[s].place].id, boxes_[slots_[t].place].id);
  }

  bool compare(const Aabb<T>& a, const Aabb<T>& b) {
    ++tests_;
    return overlap(a, b);
  }

  void update() {
    tests_ = 0;
    if (!stale_ && fresh_.empty() && gone_.empty()) return;
    const bool many_new = fresh_.size() * max_new_share > boxes_.size();
    drop_gone();
    append_fresh();
    if (many_new || !sort_in()) sort_anew();
    for (std::size_t place = 0; place < slot_at_.size(); ++place) slots_[slot_at_[place]].known = boxes_[place].box;
    stale_ = false;
  }

  void drop_gone() {
    if (gone_.empty()) return;
    for (auto& ends : ends_) std::erase_if(ends, [&](const End& end) { return slots_[end.slot].place == nowhere; });
    std::sort(gone_ids_.begin(), gone_ids_.end());
    const auto is_gone = [&](std::uint32_t id) { return std::binary_search(gone_ids_.begin(), gone_ids_.end(), id); };
    std::erase_if(pairs_, [&](const IdPair& pair) { return is_gone(pair.a) || is_gone(pair.b); });
    // These boxes came and went since the last update.
    std::erase_if(fresh_, [&](std::uint32_t slot) { return slots_[slot].place == nowhere; });
    free_.insert(free_.end(), gone_.begin(), gone_.end());
    gone_.clear();
    gone_ids_.clear();
  }

  /// Puts new boxes at the far end, where a box overlaps nothing: from there they are sorted in as if they had moved.
  void append_fresh() {
    for (const std::uint32_t slot : fresh_)
      for (auto& ends : ends_) {
        ends.push_back({T(0), slot, false});
        ends.push_back({T(0), slot, true});
      }
    fresh_.clear();
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (End& end : ends_[axis]) end.value = (end.upper ? box_of(end.slot).upper : box_of(end.slot).lower)[axis];
  }

  /// Sorts by insertion and changes the pairs as ends pass each other. False if that takes too many exchanges: the ends
  /// are all there then, but they are not sorted, and the pairs are not right.
  ///
  /// A pair that overlaps now and did not was apart on some axis, where a lower end then passes an upper one; a pair
  /// that is apart now and was not has an axis where an upper end passes a lower one. Two ends pass at most once.
  bool sort_in() {
    begun_.clear();
    ended_.clear();
    for (auto& ends : ends_)
      if (!sort_in(ends)) return false;
    change_pairs();
    return true;
  }
  bool sort_in(std::vector<End>& ends) {
    std::size_t left = ends.size() * max_exchanges;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const End end = ends[i];
      std::size_t j = i;
      for (; j > 0 && end < ends[j - 1]; --j) {
        if (end.upper != ends[j - 1].upper) pass(end, ends[j - 1]);
        ends[j] = ends[j - 1];
      }
      ends[j] = end;
      if (i - j > left) return false;
      left -= i - j;
    }
    return true;
  }
  /// Records that `end` goes below `other`, which is of the other kind.
  void pass(const End& end, const End& other) {
    const bool overlapped = compare(slots_[end.slot].known, slots_[other.slot].known);
    if (end.upper) {
      if (overlapped) ended_.push_back(ids_of(end.slot, other.slot));
    } else if (!overlapped && compare(box_of(end.slot), box_of(other.slot))) {
      begun_.push_back(ids_of(end.slot, other.slot));
    }
  }
  /// Applies the changes to the pairs. A pair can begin or end on several axes, but not both.
  void change_pairs() {
    for (auto* changes : {&begun_, &ended_}) {
      std::sort(changes->begin(), changes->end());
      changes->erase(std::unique(changes->begin(), changes->end()), changes->end());
    }
    merged_.clear();
    std::set_difference(pairs_.begin(), pairs_.end(), ended_.begin(), ended_.end(), std::back_inserter(merged_));
    pairs_.clear();
    std::merge(merged_.begin(), merged_.end(), begun_.begin(), begun_.end(), std::back_inserter(pairs_));
  }

  void sort_anew() {
    const std::vector<End>* best = &ends_[0];
    double fewest = std::numeric_limits<double>::infinity();
    for (auto& ends : ends_) {
      std::sort(ends.begin(), ends.end());
      const double count = overlapping(ends);
      if (count < fewest) {
        fewest = count;
        best = &ends;
      }
    }
    find_pairs(*best);
    std::sort(pairs_.begin(), pairs_.end());
  }
  /// The number of pairs that overlap along an axis.
  static double overlapping(const std::vector<End>& ends) {
    double open = 0, count = 0;
    for (const End& end : ends) {
      if (!end.upper) count += open;
      open += end.upper ? -1 : 1;
    }
    return count;
  }
  void find_pairs(const std::vector<End>& ends) {
    pairs_.clear();
    active_.clear();
    for (const End& end : ends) {
      if (end.upper) {
        *std::find(active_.begin(), active_.end(), end.slot) = active_.back();
        active_.pop_back();
        continue;
      }
      for (const std::uint32_t other : active_)
        if (compare(box_of(end.slot), box_of(other))) pairs_.push_back(ids_of(end.slot, other));
      active_.push_back(end.slot);
    }
  }

  BoxTable<T> boxes_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> slot_at_;       ///< of each place in the table
  std::vector<std::uint32_t> free_;          ///< slots
  std::vector<std::uint32_t> fresh_, gone_;  ///< slots since the last update
  std::vector<std::uint32_t> gone_ids_;
  bool stale_ = false;  ///< something moved since the last update
  std::uint64_t tests_ = 0;

  std::vector<End> ends_[3];
  std::vector<IdPair> pairs_;                   ///< sorted
  std::vector<IdPair> begun_, ended_, merged_;  ///< kept for their storage
  std::vector<std::uint32_t> active_;           ///< likewise
};

}  // namespace

template <class T>
std::unique_ptr<BroadPhase<T>> make_sweep_and_prune() {
  return std::make_unique<SweepAndPrune<T>>();
}

template std::unique_ptr<BroadPhase<float>> make_sweep_and_prune();
template std::unique_ptr<BroadPhase<double>> make_sweep_and_prune();

}  // namespace graze
