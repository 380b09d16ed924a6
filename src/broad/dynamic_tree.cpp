#include "graze/dynamic_tree.hpp"

#include <algorithm>

#include "broad/boxes.hpp"
#include "broad/dynamic_tree.hpp"

namespace graze {

template <class T>
DynamicTree<T>::DynamicTree() : nodes_(1), kept_(std::make_unique<Storage>()) {
  kept_->built_area.assign(1, 0);
  kept_->worn_mark.assign(1, 0);
}
template <class T>
DynamicTree<T>::~DynamicTree() = default;

template <class T>
void DynamicTree<T>::insert(std::uint32_t id, const Aabb<T>& box) {
  check(box);
  Storage& s = *kept_;
  if (s.ids.find(id) != IdTable::none) throw InvalidValue("id", "an id that is not in use", std::to_string(id));
  auto leaf = static_cast<std::uint32_t>(box_.size());
  if (s.free_leaves.empty()) {
    box_.push_back(box);
    id_.push_back(id);
    where_.push_back(nowhere);
    state_.push_back(present);
  } else {
    leaf = s.free_leaves.back();
    s.free_leaves.pop_back();
    box_[leaf] = box;
    id_[leaf] = id;
    where_[leaf] = nowhere;
    state_[leaf] = present;
  }
  s.ids.insert(id, leaf);
  wait(leaf);
  note_moved(leaf);
}

template <class T>
void DynamicTree<T>::remove(std::uint32_t id) {
  Storage& s = *kept_;
  const std::uint32_t leaf = s.ids.find(id);
  if (leaf == IdTable::none) throw InvalidValue("id", "an id that was inserted", std::to_string(id));
  take_out(leaf);
  s.ids.erase(id);
  s.free_leaves.push_back(leaf);
  state_[leaf] = 0;
  s.lost = true;
}

template <class T>
void DynamicTree<T>::move(std::uint32_t id, const Aabb<T>& box) {
  check(box);
  const std::uint32_t leaf = kept_->ids.find(id);
  if (leaf == IdTable::none) throw InvalidValue("id", "an id that was inserted", std::to_string(id));
  box_[leaf] = box;
  note_moved(leaf);
  if ((state_[leaf] & waiting) != 0) return;
  if ((state_[leaf] & open) == 0) {
    WideNode<T>& node = nodes_[where_[leaf] / width];
    if (contains(node.bounds, box)) return node.set_box(where_[leaf] % width, box);
  }
  wait(leaf);
}

template <class T>
void DynamicTree<T>::wait(std::uint32_t leaf) {
  state_[leaf] |= waiting;
  kept_->waiting.push_back(leaf);
  stale_.store(true, std::memory_order_release);
}
template <class T>
void DynamicTree<T>::note_moved(std::uint32_t leaf) {
  if ((state_[leaf] & moved) != 0) return;
  state_[leaf] |= moved;
  kept_->moved.push_back(leaf);
}
template <class T>
void DynamicTree<T>::settle() {
  for (const std::uint32_t leaf : kept_->moved) state_[leaf] &= static_cast<std::uint8_t>(~(moved | reported));
  kept_->moved.clear();
}

template <class T>
void DynamicTree<T>::pairs(std::vector<IdPair>& out) {
  refresh();
  Storage& s = *kept_;
  if (s.is_known && s.moved.size() < s.ids.size() / max_moved_share) {
    // Pairs of the last call still hold where neither box moved.
    const auto is_old = [&](std::uint32_t id) {
      const std::uint32_t leaf = s.ids.find(id);
      return leaf != IdTable::none && (state_[leaf] & moved) == 0;
    };
    if (s.lost || !s.moved.empty())
      std::erase_if(s.known, [&](const IdPair& pair) { return !is_old(pair.a) || !is_old(pair.b); });
    moved_of(s.found);
    out.clear();
    std::merge(s.known.begin(), s.known.end(), s.found.begin(), s.found.end(), std::back_inserter(out));
  } else {
    out.clear();
    s.tests = each_pair([&](std::uint32_t i, std::uint32_t j) { out.push_back(ordered(id_[i], id_[j])); });
    s.sort(out, s.ids.size());
  }
  // Pairs are kept only where few boxes moved: else they would be of no use the next time.
  s.is_known = s.moved.size() < s.ids.size() / max_moved_share || s.moved.empty();
  if (s.is_known) s.known = out;
  s.lost = false;
  settle();
}

template <class T>
void DynamicTree<T>::moved_pairs(std::vector<IdPair>& out) {
  refresh();
  Storage& s = *kept_;
  if (!s.moved.empty()) s.is_known = false;
  moved_of(out);
  settle();
}

/// Finds the pairs of boxes that moved: one walk through the tree for each, or where many moved one for all pairs.
template <class T>
void DynamicTree<T>::moved_of(std::vector<IdPair>& out) {
  Storage& s = *kept_;
  out.clear();
  if (s.moved.size() > s.ids.size() / max_moved_share) {
    s.tests = each_pair([&](std::uint32_t i, std::uint32_t j) {
      if (((state_[i] | state_[j]) & moved) != 0) out.push_back(ordered(id_[i], id_[j]));
    });
  } else {
    s.tests = 0;
    for (const std::uint32_t leaf : s.moved) {
      if ((state_[leaf] & (moved | reported)) != moved) continue;
      state_[leaf] |= reported;  // and does not overlap itself
      s.tests += each_overlapping(box_[leaf], [&](std::uint32_t other) {
        if ((state_[other] & reported) == 0) out.push_back(ordered(id_[leaf], id_[other]));
      });
    }
  }
  s.sort(out, s.ids.size());
}

template <class T>
template <class Emit>
std::uint64_t DynamicTree<T>::each_pair(const Emit& emit) {
  std::uint64_t tests = 0;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(box_[open_[i]], box_[open_[j]])) emit(open_[i], open_[j]);
    tests += i + each_overlapping_below(0, box_[open_[i]], [&](std::uint32_t leaf) { emit(open_[i], leaf); });
  }
  // The stack holds nodes or leaves whose bounds overlap, or a node with itself.
  auto& stack = kept_->pair_stack;
  const auto visit = [&](std::uint32_t a, std::uint32_t b) {
    if (!TreeChild::is_leaf(a) || !TreeChild::is_leaf(b))
      stack.push_back({a, b});
    else
      emit(TreeChild::leaf(a), TreeChild::leaf(b));
  };
  stack.assign(1, {0, 0});
  while (!stack.empty()) {
    const IdPair next = stack.back();
    stack.pop_back();
    if (TreeChild::is_leaf(next.a) || TreeChild::is_leaf(next.b)) {
      const std::uint32_t leaf = TreeChild::leaf(TreeChild::is_leaf(next.a) ? next.a : next.b);
      tests += each_overlapping_below(TreeChild::is_leaf(next.a) ? next.b : next.a, box_[leaf],
                                      [&](std::uint32_t other) { emit(leaf, other); });
      continue;
    }
    const WideNode<T>&a = nodes_[next.a], &b = nodes_[next.b];
    const bool same = next.a == next.b;
    std::uint32_t left = same ? a.present() : a.overlapping(b.bounds);
    tests += same ? 0 : width;
    for (; left != 0; left &= left - 1) {
      const auto i = static_cast<std::uint32_t>(std::countr_zero(left));
      std::uint32_t others = b.overlapping(a.box(i));
      tests += width;
      if (same) {
        others &= ~((2u << i) - 1);  // after i
        if (!TreeChild::is_leaf(a.child[i])) stack.push_back({a.child[i], a.child[i]});
      }
      for (; others != 0; others &= others - 1)
        visit(a.child[i], b.child[static_cast<std::size_t>(std::countr_zero(others))]);
    }
  }
  return tests;
}

template <class T>
std::uint64_t DynamicTree<T>::tests() const {
  return kept_->tests;
}

template <class T>
void DynamicTree<T>::query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const {
  refresh();
  out.clear();
  each_overlapping(box, [&](std::uint32_t leaf) { out.push_back(id_[leaf]); });
  std::sort(out.begin(), out.end());
}

template <class T>
void DynamicTree<T>::sweep(const Aabb<T>& box, const Vec3<T>& motion, std::vector<std::uint32_t>& out) const {
  refresh();
  out.clear();
  // Rounding might let the bounds of a node be missed though a box in it is just hit: hence a wider box for nodes, by
  // more than the sum of the test's roundings.
  const T reach = greatest(greatest(max_abs(box.lower), max_abs(box.upper)), max_abs(motion));
  const T more = T(32) * std::numeric_limits<T>::epsilon() * reach;
  const SweptBox<T> accept(box, motion);
  const auto see = [&](std::uint32_t leaf) { out.push_back(id_[leaf]); };
  if (more <= std::numeric_limits<T>::max())
    each_accepted(SweptBox<T>(inflated(box, more), motion), accept, see);
  else
    each_accepted([](const Aabb<T>&) { return true; }, accept, see);
  std::sort(out.begin(), out.end());
}

template <class T>
std::size_t DynamicTree<T>::memory() const {
  return nodes_.capacity() * sizeof(WideNode<T>) + box_.capacity() * sizeof(Aabb<T>) +
         (id_.capacity() + where_.capacity() + open_.capacity()) * sizeof(std::uint32_t) + state_.capacity() +
         kept_->memory();
}

template <class T>
void DynamicTree<T>::parts(std::vector<BroadPhasePart<T>>& out) const {
  refresh();
  out.clear();
  std::vector<std::uint32_t> nodes;  // of the parts, level by level
  const auto add = [&](std::uint32_t n, std::uint32_t depth) {
    Aabb<T> box = Aabb<T>::empty();
    for (std::uint32_t left = nodes_[n].present(); left != 0; left &= left - 1)
      box = merged(box, nodes_[n].box(static_cast<std::uint32_t>(std::countr_zero(left))));
    out.push_back({box, depth});
    nodes.push_back(n);
  };
  if (nodes_.front().present() != 0) add(0, 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const WideNode<T>& node = nodes_[nodes[i]];
    for (const std::uint32_t child : node.child)
      if (child != TreeChild::none && !TreeChild::is_leaf(child)) add(child, out[i].depth + 1);
  }
}

template <class T>
std::unique_ptr<BroadPhase<T>> make_dynamic_tree() {
  return std::make_unique<DynamicTree<T>>();
}

template std::unique_ptr<BroadPhase<float>> make_dynamic_tree();
template std::unique_ptr<BroadPhase<double>> make_dynamic_tree();
template class DynamicTree<float>;
template class DynamicTree<double>;

}  // namespace graze
