// The updates by which a dynamic tree follows its boxes: they change the speed of answers, and no answer.
#include <algorithm>

#include "broad/dynamic_tree.hpp"

namespace graze {

namespace {

/// The room that a node leaves around each of its boxes, in lengths of that box. Measured, frames of boxes that drift
/// by a hundredth or by a twentieth of their length take the same time with half and with twice as much.
constexpr double room_share = 0.1;
/// The multiple of the area that a node was built with from which on it is worn, and its parent is built anew. Measured
/// on the same frames: 1.3 is as good, 2 takes a tenth longer and 3 a third.
constexpr double worn_area = 1.5;
/// The shares of boxes to be put in and of worn nodes, one in so many, above which everything is built anew.
constexpr std::size_t max_far_share = 4, max_worn_share = 4;
/// The number of boxes that each box that leaves its node allows to be built anew, so that a box that jumps about does
/// not make the tree be built over and over.
constexpr std::size_t credit_per_change = 16;
/// The depth of an insertion above which the tree is built anew: no tree is built so deep, so that one box after the
/// other has been put into the same place.
constexpr unsigned max_depth = 100;
/// A tree with fewer children a node than one in so many is built anew.
constexpr std::size_t max_empty_share = 6;

template <class T>
Aabb<T> with_room(const Aabb<T>& box) {
  return inflated(box, static_cast<T>(room_share) * max_abs(box.extent()));
}
/// The area in double, where squares of floats do not overflow.
template <class T>
double area(const Aabb<T>& box) {
  return surface_area(Aabb<double>{converted<double>(box.lower), converted<double>(box.upper)});
}
template <class T>
bool is_open(const Aabb<T>& box) {
  return !(max_abs(box.extent()) <= std::numeric_limits<T>::max());
}

}  // namespace

template <class T>
void DynamicTree<T>::update() {
  Storage& s = *kept_;
  // Building everything costs less than looking at each box where most of them wait.
  const bool most = s.waiting.size() > s.ids.size() / 2;
  s.credit += credit_per_change * s.waiting.size();
  s.far.clear();
  for (const std::uint32_t leaf : s.waiting) {
    if ((state_[leaf] & waiting) == 0) continue;  // it has gone, or came back under the same number
    state_[leaf] &= static_cast<std::uint8_t>(~waiting);
    const Aabb<T>& box = box_[leaf];
    const bool endless = is_open(box), in_tree = where_[leaf] != nowhere && (state_[leaf] & open) == 0;
    if (endless) {
      if ((state_[leaf] & open) != 0) continue;
      take_out(leaf);
      state_[leaf] |= open;
      where_[leaf] = static_cast<std::uint32_t>(open_.size());
      open_.push_back(leaf);
    } else if (!in_tree) {
      take_out(leaf);
      s.far.push_back(leaf);
    } else if (!most) {
      const std::uint32_t n = where_[leaf] / width;
      if (overlap(nodes_[n].bounds, box)) {
        nodes_[n].set_box(where_[leaf] % width, box);
        stretch(n, with_room(box));
      } else {
        take_out(leaf);
        s.far.push_back(leaf);
      }
    }
  }
  s.waiting.clear();
  if (most || s.far.size() > s.ids.size() / max_far_share) return build_all();
  for (const std::uint32_t leaf : s.far) put(leaf);
  rebuild_worn();
}

template <class T>
std::uint32_t DynamicTree<T>::take_node() {
  Storage& s = *kept_;
  if (s.free_nodes.empty()) {
    nodes_.emplace_back();
    s.built_area.push_back(0);
    s.worn_mark.push_back(0);
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t n = s.free_nodes.back();
  s.free_nodes.pop_back();
  nodes_[n] = WideNode<T>();
  return n;
}
template <class T>
void DynamicTree<T>::free_node(std::uint32_t n) {
  kept_->worn_mark[n] = 0;
  kept_->free_nodes.push_back(n);
}

template <class T>
void DynamicTree<T>::hang(std::uint32_t n, std::uint32_t place, const Aabb<T>& box, std::uint32_t child) {
  nodes_[n].set(place, box, child);
  if (TreeChild::is_leaf(child)) {
    where_[TreeChild::leaf(child)] = n * width + place;
  } else {
    nodes_[child].parent = n;
    nodes_[child].place = place;
  }
}

/// Takes a leaf out of the tree or the list of open ones, if it is in one. Bounds stay as they are; empty nodes go.
template <class T>
void DynamicTree<T>::take_out(std::uint32_t leaf) {
  Storage& s = *kept_;
  const std::uint32_t at = where_[leaf];
  if (at == nowhere) return;
  where_[leaf] = nowhere;
  if ((state_[leaf] & open) != 0) {
    state_[leaf] &= static_cast<std::uint8_t>(~open);
    open_[at] = open_.back();
    where_[open_[at]] = at;
    where_[leaf] = nowhere;
    open_.pop_back();
    return;
  }
  std::uint32_t n = at / width;
  nodes_[n].clear(at % width);
  while (n != 0 && nodes_[n].present() == 0) {
    const std::uint32_t place = nodes_[n].place;
    free_node(n);
    n = nodes_[n].parent;
    nodes_[n].clear(place);
  }
  const std::size_t used = nodes_.size() - s.free_nodes.size();
  if (used * width > max_empty_share * s.ids.size() + 64) {
    s.all_worn = true;
    stale_.store(true, std::memory_order_release);
  }
}

/// Puts a leaf into the node or beside the leaf whose bounds grow least. A free place where nothing else has to grow
/// costs nothing: it is tested with its neighbours in any case.
template <class T>
void DynamicTree<T>::put(std::uint32_t leaf) {
  const Aabb<T>& box = box_[leaf];
  const Aabb<T> room = with_room(box);
  std::uint32_t n = 0;
  for (unsigned depth = 0;; ++depth) {
    if (depth > max_depth) kept_->all_worn = true;
    const WideNode<T>& node = nodes_[n];
    std::uint32_t best = width, free = width;
    double least = 0;
    for (std::uint32_t i = 0; i < width; ++i) {
      if (node.child[i] == TreeChild::none) {
        free = i;
        continue;
      }
      const Aabb<T> now = node.box(i);
      const double grown = area(merged(now, room)) - (TreeChild::is_leaf(node.child[i]) ? 0 : area(now));
      if (best != width && !(grown < least)) continue;
      least = grown;
      best = i;
    }
    if (free != width && (best == width || !(least <= 0))) {
      hang(n, free, box, leaf | TreeChild::leaf_bit);
      break;
    }
    const std::uint32_t child = node.child[best];
    if (!TreeChild::is_leaf(child)) {
      n = child;
      continue;
    }
    // A free place is better than a new node with another leaf, even where that adds no area.
    if (free != width) {
      hang(n, free, box, leaf | TreeChild::leaf_bit);
      break;
    }
    const Aabb<T> other = node.box(best);
    const std::uint32_t both = take_node();
    hang(both, 0, other, child);
    hang(both, 1, box, leaf | TreeChild::leaf_bit);
    nodes_[both].bounds = merged(with_room(other), room);
    kept_->built_area[both] = area(nodes_[both].bounds);
    hang(n, best, nodes_[both].bounds, both);
    return stretch(n, nodes_[both].bounds);
  }
  stretch(n, room);
}

/// Makes the node and its ancestors as large as needed.
template <class T>
void DynamicTree<T>::stretch(std::uint32_t n, const Aabb<T>& by) {
  Storage& s = *kept_;
  for (;;) {
    WideNode<T>& node = nodes_[n];
    node.bounds = merged(node.bounds, by);
    if (n == 0) return;
    nodes_[node.parent].set_box(node.place, node.bounds);
    if (s.worn_mark[n] == 0 && area(node.bounds) > worn_area * s.built_area[n]) {
      s.worn_mark[n] = 1;
      s.worn.push_back(n);
    }
    if (contains(nodes_[node.parent].bounds, by)) return;
    n = node.parent;
  }
}
/// Makes the ancestors of the node as small as they can be.
template <class T>
void DynamicTree<T>::tighten(std::uint32_t n) {
  while (n != 0) {
    const WideNode<T>& node = nodes_[n];
    nodes_[node.parent].set_box(node.place, node.bounds);
    n = node.parent;
    Aabb<T> bounds = Aabb<T>::empty();
    for (std::uint32_t i = 0; i < width; ++i) {
      const std::uint32_t child = nodes_[n].child[i];
      if (child == TreeChild::none) continue;
      const Aabb<T> box = nodes_[n].box(i);
      bounds = merged(bounds, TreeChild::is_leaf(child) ? with_room(box) : box);
    }
    nodes_[n].bounds = bounds;
  }
}

template <class T>
void DynamicTree<T>::rebuild_worn() {
  Storage& s = *kept_;
  if (s.all_worn || s.worn.size() > 1 + (nodes_.size() - s.free_nodes.size()) / max_worn_share) return build_all();
  std::size_t kept = 0;
  for (const std::uint32_t worn : s.worn) {
    if (s.worn_mark[worn] == 0) continue;  // it went with what was around it
    // Boxes that left a worn node have gone to those beside it.
    std::uint32_t top = nodes_[worn].parent;
    while (s.worn_mark[top] != 0) top = nodes_[top].parent;
    if (top == 0 && s.credit >= s.ids.size()) return build_all();
    if (top != 0 && build_below(top))
      tighten(top);
    else
      s.worn[kept++] = worn;
  }
  s.worn.resize(kept);
}

template <class T>
void DynamicTree<T>::build_all() {
  Storage& s = *kept_;
  s.splits.items.clear();
  for (std::uint32_t leaf = 0; leaf < box_.size(); ++leaf)
    if ((state_[leaf] & (present | open)) == present) s.splits.items.push_back({box_[leaf], leaf});
  nodes_.assign(1, {});
  s.built_area.assign(1, 0);
  s.worn_mark.assign(1, 0);
  s.free_nodes.clear();
  s.worn.clear();
  s.all_worn = false;
  s.credit = 0;
  build(0);
}
/// Builds all below a node anew and returns true, unless it is more than there is credit for.
template <class T>
bool DynamicTree<T>::build_below(std::uint32_t top) {
  Storage& s = *kept_;
  auto& items = s.splits.items;
  items.clear();
  s.order.assign(1, top);
  for (std::size_t i = 0; i < s.order.size(); ++i) {
    for (const std::uint32_t child : nodes_[s.order[i]].child) {
      if (child == TreeChild::none) continue;
      if (TreeChild::is_leaf(child))
        items.push_back({box_[TreeChild::leaf(child)], TreeChild::leaf(child)});
      else
        s.order.push_back(child);
    }
    if (items.size() > s.credit) return false;
  }
  s.credit -= items.size();
  for (const std::uint32_t n : s.order)
    if (n != top) free_node(n);
  const std::uint32_t parent = nodes_[top].parent, place = nodes_[top].place;
  nodes_[top] = WideNode<T>();
  nodes_[top].parent = parent;
  nodes_[top].place = place;
  s.worn_mark[top] = 0;
  build(top);
  return true;
}

/// Builds the items of `splits` into and below a node.
template <class T>
void DynamicTree<T>::build(std::uint32_t root) {
  Storage& s = *kept_;
  const auto& items = s.splits.items;
  s.order.clear();
  s.tasks.clear();
  if (!items.empty()) s.tasks.push_back({root, 0, static_cast<std::uint32_t>(items.size()), 0});
  while (!s.tasks.empty()) {
    const typename Storage::Task task = s.tasks.back();
    s.tasks.pop_back();
    s.order.push_back(task.node);
    if (task.end - task.begin <= width) {
      for (std::uint32_t i = task.begin; i < task.end; ++i)
        hang(task.node, i - task.begin, items[i].box, items[i].leaf | TreeChild::leaf_bit);
      continue;
    }
    // The largest part is split until there are as many as children.
    typename Storage::Task parts[width] = {task};
    std::uint32_t count = 1;
    while (count < width) {
      auto* largest = std::max_element(parts, parts + count,
                                       [](const auto& a, const auto& b) { return a.end - a.begin < b.end - b.begin; });
      if (largest->end - largest->begin <= width && count > 1) break;
      const std::uint32_t middle = s.splits(largest->begin, largest->end, largest->depth++, width);
      parts[count] = *largest;
      parts[count++].begin = middle;
      largest->end = middle;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto& part = parts[i];
      if (part.end - part.begin == 1) {
        hang(task.node, i, items[part.begin].box, items[part.begin].leaf | TreeChild::leaf_bit);
      } else {
        const std::uint32_t n = take_node();
        hang(task.node, i, {}, n);
        s.tasks.push_back({n, part.begin, part.end, part.depth});
      }
    }
  }
  // Parents come before their children in the order, so from its end each node's children are known.
  for (std::size_t i = s.order.size(); i-- > 0;) {
    const std::uint32_t n = s.order[i];
    WideNode<T>& node = nodes_[n];
    node.bounds = Aabb<T>::empty();
    for (std::uint32_t c = 0; c < width; ++c)
      if (node.child[c] != TreeChild::none)
        node.bounds = merged(node.bounds, TreeChild::is_leaf(node.child[c]) ? with_room(node.box(c)) : node.box(c));
    s.built_area[n] = area(node.bounds);
    if (n != root) nodes_[node.parent].set_box(node.place, node.bounds);
  }
}

template class DynamicTree<float>;
template class DynamicTree<double>;

}  // namespace graze
