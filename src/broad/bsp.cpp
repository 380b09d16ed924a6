#include <algorithm>
#include <numeric>

#include "broad/hierarchy_queries.hpp"
#include "broad/rebuilt.hpp"

namespace graze {

namespace {

/// The most boxes of a leaf: testing all of them costs less than another plane.
constexpr std::size_t max_leaf = 8;

/// A k-d tree over the boxes of a table. Each plane goes through the median of the centres, so that at most half of the
/// boxes are on either side and log2(n) bounds the depth. A box that touches the plane stays with it; hence boxes on
/// different sides never overlap. Each node has the bounds of all boxes in and below it.
template <class T>
class Tree {
 public:
  void build(const BoxTable<T>& boxes) {
    order_.resize(boxes.size());
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.assign(1, {});
    // Infinite boxes have no centre to divide by: they stay at the root.
    const auto infinite = std::partition(order_.begin(), order_.end(), [&](std::uint32_t place) {
      return max_abs(boxes[place].box.extent()) <= std::numeric_limits<T>::max();
    });
    const auto finite = static_cast<std::uint32_t>(infinite - order_.begin());
    nodes_[0].items = {finite, static_cast<std::uint32_t>(boxes.size()), 0};
    sort(boxes, nodes_[0].items);
    nodes_[0].left = divide(boxes, {0, finite, 0});
    for (std::size_t n = nodes_.size(); n-- > 0;) bound(boxes, nodes_[n]);  // children come after their parents
  }

  /// Calls `test(place, place)` for all pairs that may overlap.
  template <class Test>
  void for_each_pair(const BoxTable<T>& boxes, Test& test) {
    for (const Node& node : nodes_) {
      const Range& r = node.items;
      for (std::uint32_t i = r.begin; i < r.end; ++i) {
        const Aabb<T>& box = boxes[order_[i]].box;
        for (std::uint32_t j = i + 1; j < r.end; ++j) {
          if (boxes[order_[j]].box.lower[r.axis] > box.upper[r.axis]) break;
          test(order_[i], order_[j]);
        }
        stack_.clear();
        push_children(node, stack_);
        visit([&](const Aabb<T>& bounds) { return test.overlapping(bounds, box); },
              [&](std::uint32_t other) { test(order_[i], other); }, stack_);
      }
    }
  }
  /// Calls `see(place)` for all boxes, except below where `enter(bounds)` refuses.
  template <class Enter, class See>
  void for_each(const Enter& enter, const See& see) const {
    std::vector<std::uint32_t> stack(1, 0u);
    visit(enter, see, stack);
  }

  /// The bounds of all nodes that hold something, parents before their children.
  void parts(std::vector<BroadPhasePart<T>>& out) const {
    std::vector<std::uint32_t> depths(nodes_.size(), 0);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      const Node& node = nodes_[n];
      for (const std::uint32_t child : {node.left, node.right})
        if (child != 0) depths[child] = depths[n] + 1;
      if (node.items.size() != 0 || node.left != 0 || node.right != 0) out.push_back({node.bounds, depths[n]});
    }
  }

  std::size_t memory() const {
    return nodes_.capacity() * sizeof(Node) + (order_.capacity() + stack_.capacity()) * sizeof(std::uint32_t) +
           centers_.capacity() * sizeof(T);
  }

 private:
  /// Part of the order, sorted by the lower ends along an axis.
  struct Range {
    std::uint32_t begin = 0, end = 0;
    std::size_t axis = 0;

    std::uint32_t size() const { return end - begin; }
  };
  struct Node {
    Aabb<T> bounds = Aabb<T>::empty();  ///< of what is in and below it
    Range items;
    std::uint32_t left = 0, right = 0;  ///< 0 for none
  };

  auto at(std::uint32_t index) { return order_.begin() + static_cast<std::ptrdiff_t>(index); }

  /// Makes the node of a range and all nodes below it, and returns its number; 0 for an empty range.
  std::uint32_t divide(const BoxTable<T>& boxes, Range range) {
    if (range.size() == 0) return 0;
    const auto n = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Range left = range, right = range;
    if (range.size() > max_leaf) {
      const std::size_t axis = best_axis(boxes, range, 3);
      const T plane = median(boxes, range, axis);
      const auto below = [&](std::uint32_t place) { return boxes[place].box.upper[axis] < plane; };
      const auto above = [&](std::uint32_t place) { return boxes[place].box.lower[axis] > plane; };
      const auto middle = std::partition(at(range.begin), at(range.end), below);
      const auto last = std::partition(middle, at(range.end), [&](std::uint32_t place) { return !above(place); });
      range.begin = left.end = static_cast<std::uint32_t>(middle - order_.begin());
      range.end = right.begin = static_cast<std::uint32_t>(last - order_.begin());
      // All boxes meet the plane, so another axis separates them better.
      range.axis = best_axis(boxes, range, axis);
    } else {
      left.end = left.begin;
      right.begin = right.end;
    }
    sort(boxes, range);
    nodes_[n].items = range;
    const std::uint32_t first = divide(boxes, left), second = divide(boxes, right);
    nodes_[n].left = first;
    nodes_[n].right = second;
    return n;
  }
  /// The centre of a box, kept inside it: overflow or denormal numbers could take it out, and a plane
  /// leave all boxes on one side.
  static Vec3<T> center(const Aabb<T>& box) { return greatest(box.lower, least(box.center(), box.upper)); }
  void sort(const BoxTable<T>& boxes, const Range& range) {
    std::sort(at(range.begin), at(range.end), [&](std::uint32_t i, std::uint32_t j) {
      return boxes[i].box.lower[range.axis] < boxes[j].box.lower[range.axis];
    });
  }
  /// The axis, other than `excluded`, on which the centres spread most relative to the boxes' lengths: there a plane
  /// meets the fewest. In double, where no sum of floats overflows; an overflow of doubles only makes a worse choice.
  std::size_t best_axis(const BoxTable<T>& boxes, const Range& range, std::size_t excluded) const {
    Aabb<T> centers = Aabb<T>::empty();
    Vec3<double> lengths{};
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const Aabb<T>& box = boxes[order_[i]].box;
      centers = merged(centers, center(box));
      lengths += converted<double>(box.extent());
    }
    std::size_t best = excluded == 0 ? 1 : 0;
    double most = -1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double spread = static_cast<double>(centers.upper[axis]) - static_cast<double>(centers.lower[axis]);
      const double ratio = lengths[axis] > 0 ? spread / lengths[axis] : spread > 0 ? most + 1 : 0;
      if (axis != excluded && ratio > most) {
        most = ratio;
        best = axis;
      }
    }
    return best;
  }
  T median(const BoxTable<T>& boxes, const Range& range, std::size_t axis) {
    centers_.clear();
    for (std::uint32_t i = range.begin; i < range.end; ++i) centers_.push_back(center(boxes[order_[i]].box)[axis]);
    const auto middle = centers_.begin() + static_cast<std::ptrdiff_t>(centers_.size() / 2);
    std::nth_element(centers_.begin(), middle, centers_.end());
    return *middle;
  }
  void bound(const BoxTable<T>& boxes, Node& node) {
    for (std::uint32_t i = node.items.begin; i < node.items.end; ++i)
      node.bounds = merged(node.bounds, boxes[order_[i]].box);
    for (const std::uint32_t child : {node.left, node.right})
      if (child != 0) node.bounds = merged(node.bounds, nodes_[child].bounds);
  }

  static void push_children(const Node& node, std::vector<std::uint32_t>& stack) {
    if (node.left != 0) stack.push_back(node.left);
    if (node.right != 0) stack.push_back(node.right);
  }
  template <class Enter, class See>
  void visit(const Enter& enter, const See& see, std::vector<std::uint32_t>& stack) const {
    while (!stack.empty()) {
      const Node& node = nodes_[stack.back()];
      stack.pop_back();
      if (!enter(node.bounds)) continue;
      for (std::uint32_t i = node.items.begin; i < node.items.end; ++i) see(order_[i]);
      push_children(node, stack);
    }
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;  ///< places in the table, those of a node together
  std::vector<std::uint32_t> stack_;  ///< kept for its storage
  std::vector<T> centers_;            ///< likewise
};

template <class T>
class Bsp final : public Rebuilt<T, Tree<T>> {
 public:
  void query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const override {
    graze::query(this->index(), this->boxes(), box, out);
  }
  void sweep(const Aabb<T>& box, const Vec3<T>& motion, std::vector<std::uint32_t>& out) const override {
    graze::sweep(this->index(), this->boxes(), box, motion, out);
  }
  void parts(std::vector<BroadPhasePart<T>>& out) const override {
    out.clear();
    this->index().parts(out);
  }
};

}  // namespace

template <class T>
std::unique_ptr<BroadPhase<T>> make_bsp() {
  return std::make_unique<Bsp<T>>();
}

template std::unique_ptr<BroadPhase<float>> make_bsp();
template std::unique_ptr<BroadPhase<double>> make_bsp();

}  // namespace graze
