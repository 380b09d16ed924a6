// A broad phase whose structure over all boxes is built anew by the first query after a change.
//
// Guarantee: queries from several threads at a time build it once, and none sees it half built.
#pragma once

#include <atomic>
#include <mutex>

#include "broad/boxes.hpp"

namespace graze {

/// `Index`: `build(boxes)`, `for_each_pair(boxes, test)`, which calls `test(place, place)` for all pairs that may
/// overlap and `test.overlapping(bounds, box)` on its way to them (`BoxTable::PairTest`), and `memory()`.
template <class T, class Index>
class Rebuilt : public BroadPhase<T> {
 public:
  void insert(std::uint32_t id, const Aabb<T>& box) override {
    boxes_.insert(id, box);
    stale_ = true;
  }
  void remove(std::uint32_t id) override {
    boxes_.remove(id);
    stale_ = true;
  }
  void move(std::uint32_t id, const Aabb<T>& box) override {
    boxes_.move(id, box);
    stale_ = true;
  }

  void pairs(std::vector<IdPair>& out) override { find(out, false); }
  void moved_pairs(std::vector<IdPair>& out) override { find(out, true); }
  std::uint64_t tests() const override { return tests_; }

  std::size_t memory() const override { return boxes_.memory() + index_.memory(); }

 protected:
  const BoxTable<T>& boxes() const { return boxes_; }
  /// The structure over the boxes as they are now.
  const Index& index() const {
    refresh();
    return index_;
  }

 private:
  void refresh() const {
    if (!stale_) return;
    const std::scoped_lock lock(mutex_);
    if (stale_) index_.build(boxes_);
    stale_ = false;
  }
  void find(std::vector<IdPair>& out, bool moved_only) {
    refresh();
    tests_ = boxes_.collect_pairs(out, moved_only, [&](auto& test) { index_.for_each_pair(boxes_, test); });
  }

  BoxTable<T> boxes_;
  std::uint64_t tests_ = 0;
  mutable Index index_;
  mutable std::atomic<bool> stale_ = true;
  mutable std::mutex mutex_;
};

}  // namespace graze
