// The default broad phase: a tree of bounds, eight children a node, that follows boxes as they move.
//
// The boxes lie in the nodes; a node's bounds leave them room, so that most moves change one box in one node. A box
// that leaves its node stretches it, or is inserted anew after a long way; parts of the tree that have been stretched
// too much are rebuilt, and so is the whole tree when much has changed. All of that happens at the next query.
//
// Guarantee: that of `BroadPhase`; the history of the tree changes no answer. Queries descend at most 101 levels,
// without recursion. No allocation once the arrays are as large as a scene needs. Const functions may be called from
// several threads at a time.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "graze/broad_phase.hpp"
#include "graze/detail/wide_node.hpp"
#include "graze/small_vector.hpp"

namespace graze {

/// A tree of boxes that are widened by a margin, so that small moves change nothing.
template <class T>
class GRAZE_API DynamicTree final : public BroadPhase<T> {
 public:
  DynamicTree();
  ~DynamicTree() override;
  DynamicTree(const DynamicTree&) = delete;
  DynamicTree& operator=(const DynamicTree&) = delete;

  void insert(std::uint32_t id, const Aabb<T>& box) override;
  void remove(std::uint32_t id) override;
  /// Replaces a box, in constant time while it stays in the room of its node.
  void move(std::uint32_t id, const Aabb<T>& box) override;

  void pairs(std::vector<IdPair>& out) override;
  /// Costs nothing for boxes at rest: the tree is searched for moved boxes only.
  void moved_pairs(std::vector<IdPair>& out) override;
  /// A comparison with the eight children of a node, made at once, counts as eight.
  std::uint64_t tests() const override;

  void query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const override;
  void sweep(const Aabb<T>& box, const Vec3<T>& motion, std::vector<std::uint32_t>& out) const override;
  std::size_t memory() const override;
  void parts(std::vector<BroadPhasePart<T>>& out) const override;

  /// Calls `f(id, box)` for all boxes that overlap `box`, in no particular order.
  template <class F>
  void overlapping(const Aabb<T>& box, const F& f) const {
    refresh();
    each_overlapping(box, [&](std::uint32_t leaf) { f(id_[leaf], box_[leaf]); });
  }
  /// Calls `f(id, box)` for all boxes for which `accept(box)` holds, in no particular order. `accept` must hold for
  /// every box around an accepted one.
  template <class Accept, class F>
  void visit(const Accept& accept, const F& f) const {
    refresh();
    each_accepted(accept, accept, [&](std::uint32_t leaf) { f(id_[leaf], box_[leaf]); });
  }
  /// Visits the boxes no further than `limit` from `from`, the near parts of the tree first. `f(id, box)` returns the
  /// limit from then on, for example the distance of the nearest shape so far; below zero it ends the search. A box
  /// within rounding of the limit may be visited.
  template <class F>
  void nearest(const Aabb<T>& from, T limit, const F& f) const;
  /// Visits the boxes whose key is at most `limit`, those of a node in the order of their keys. `keys(node, out)`
  /// computes the keys of a node's children, which may not exceed that of any box below them; `f(id, box)` returns the
  /// limit from then on, below zero to end the search.
  template <class Keys, class F>
  void in_order(const Keys& keys, T limit, const F& f) const;

 private:
  static constexpr std::uint32_t width = WideNode<T>::width;
  static constexpr std::uint32_t nowhere = ~0u;

  /// State flags of a box, whose index in the arrays stays while the box is held.
  enum State : std::uint8_t {
    present = 1,
    moved = 2,     ///< since `pairs` or `moved_pairs` was last called
    reported = 4,  ///< its pairs have been reported in the search that is under way
    waiting = 8,   ///< out of its node, or not in the tree yet
    open = 16,     ///< without end, and hence in a list of its own
  };
  struct Storage;  ///< buffers kept from call to call, which no query reads

  void refresh() const {
    if (!stale_.load(std::memory_order_acquire)) return;
    const std::scoped_lock lock(mutex_);
    if (stale_.load(std::memory_order_relaxed)) const_cast<DynamicTree*>(this)->update();
    stale_.store(false, std::memory_order_release);
  }
  void update();
  void wait(std::uint32_t leaf);
  void note_moved(std::uint32_t leaf);

  std::uint32_t take_node();
  void free_node(std::uint32_t n);
  void put(std::uint32_t leaf);
  void take_out(std::uint32_t leaf);
  void hang(std::uint32_t n, std::uint32_t place, const Aabb<T>& box, std::uint32_t child);
  void stretch(std::uint32_t n, const Aabb<T>& by);
  void tighten(std::uint32_t n);
  void rebuild_worn();
  void build_all();
  bool build_below(std::uint32_t top);
  void build(std::uint32_t root);

  template <class Emit>
  std::uint64_t each_pair(const Emit& emit);
  void moved_of(std::vector<IdPair>& out);
  void settle();

  /// Calls `f(leaf)` for all boxes that overlap `box`. Returns the number of boxes that were compared with it.
  template <class F>
  std::uint64_t each_overlapping(const Aabb<T>& box, const F& f) const {
    for (const std::uint32_t leaf : open_)
      if (overlap(box_[leaf], box)) f(leaf);
    return open_.size() + each_overlapping_below(0, box, f);
  }
  template <class F>
  std::uint64_t each_overlapping_below(std::uint32_t root, const Aabb<T>& box, const F& f) const {
    std::uint64_t tests = 0;
    SmallVector<std::uint32_t, 128> stack;
    stack.push_back(root);
    while (!stack.empty()) {
      const WideNode<T>& node = nodes_[stack.back()];
      stack.truncate(stack.size() - 1);
      tests += width;
      for (std::uint32_t left = node.overlapping(box); left != 0; left &= left - 1) {
        const std::uint32_t child = node.child[static_cast<std::size_t>(std::countr_zero(left))];
        if (TreeChild::is_leaf(child))
          f(TreeChild::leaf(child));
        else
          stack.push_back(child);
      }
    }
    return tests;
  }
  template <class Enter, class Accept, class F>
  void each_accepted(const Enter& enter, const Accept& accept, const F& f) const {
    for (const std::uint32_t leaf : open_)
      if (accept(box_[leaf])) f(leaf);
    SmallVector<std::uint32_t, 128> stack;
    stack.push_back(0);
    while (!stack.empty()) {
      const WideNode<T>& node = nodes_[stack.back()];
      stack.truncate(stack.size() - 1);
      for (std::uint32_t i = 0; i < width; ++i) {
        const std::uint32_t child = node.child[i];
        if (child == TreeChild::none) continue;
        if (!TreeChild::is_leaf(child)) {
          if (enter(node.box(i))) stack.push_back(child);
        } else if (accept(node.box(i))) {
          f(TreeChild::leaf(child));
        }
      }
    }
  }

  std::vector<WideNode<T>> nodes_;  ///< the first is the root
  std::vector<Aabb<T>> box_;        ///< box of each leaf; the next three arrays are indexed alike
  std::vector<std::uint32_t> id_;
  std::vector<std::uint32_t> where_;  ///< node * width + slot; for an unbounded box its index in `open_`
  std::vector<std::uint8_t> state_;
  std::vector<std::uint32_t> open_;
  std::unique_ptr<Storage> kept_;
  mutable std::atomic<bool> stale_ = false;
  mutable std::mutex mutex_;
};

template <class T>
template <class F>
void DynamicTree<T>::nearest(const Aabb<T>& from, T limit, const F& f) const {
  // Rounding of some eight operations may put a box nearer than the bounds around it.
  constexpr T slack = T(1) - T(16) * std::numeric_limits<T>::epsilon();
  const auto distances = [&](const WideNode<T>& node, std::array<T, width>& out) {
    node.distances(from, out);
    for (T& distance : out) distance *= slack;
  };
  in_order(distances, limit, f);
}

template <class T>
template <class Keys, class F>
void DynamicTree<T>::in_order(const Keys& keys, T limit, const F& f) const {
  refresh();
  struct Visit {
    T key;
    std::uint32_t child;
  };
  SmallVector<Visit, 128> stack;
  // Reverse order, because the nearest is taken from the end.
  const auto add = [&](const WideNode<T>& node) {
    std::array<T, width> key;
    keys(node, key);
    const std::size_t begin = stack.size();
    for (std::uint32_t i = 0; i < width; ++i) {
      const Visit visit{key[i], node.child[i]};
      if (visit.child == TreeChild::none || !(visit.key <= limit)) continue;
      stack.push_back(visit);
      std::size_t j = stack.size() - 1;
      for (; j > begin && stack[j - 1].key < visit.key; --j) stack[j] = stack[j - 1];
      stack[j] = visit;
    }
  };
  add(nodes_.front());
  while (!stack.empty() && limit >= T(0)) {
    const Visit next = stack.back();
    stack.truncate(stack.size() - 1);
    if (!(next.key <= limit)) continue;
    if (TreeChild::is_leaf(next.child)) {
      const std::uint32_t leaf = TreeChild::leaf(next.child);
      limit = f(id_[leaf], box_[leaf]);
    } else {
      add(nodes_[next.child]);
    }
  }
  for (const std::uint32_t leaf : open_) {
    if (!(limit >= T(0))) return;
    WideNode<T> alone;
    alone.set(0, box_[leaf], leaf);
    std::array<T, width> key;
    keys(alone, key);
    if (key[0] <= limit) limit = f(id_[leaf], box_[leaf]);
  }
}

}  // namespace graze
