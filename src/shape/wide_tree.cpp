#include "shape/wide_tree.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace graze {

namespace {

constexpr std::size_t most_bins = 16;

template <class T>
Vec3<T> middle(const Aabb<T>& box) {
  return box.lower * T(0.5) + box.upper * T(0.5);  // the sum of the two might overflow
}

/// Some pieces: their bounds, and the bounds of their middles.
template <class T>
struct Range {
  std::size_t begin, end;
  Aabb<T> box = Aabb<T>::empty(), middles = Aabb<T>::empty();

  std::size_t count() const { return end - begin; }
  void add(const TreePiece<T>& piece) {
    box = merged(box, piece.box);
    middles = merged(middles, middle(piece.box));
  }
};

template <class T>
struct BinaryNode {
  Aabb<T> box;
  std::uint32_t first;  ///< leaf: its first piece; else the right child (the left one follows its parent)
  std::uint32_t count;  ///< leaf: how many pieces; else 0
};

template <class T>
struct Split {
  std::size_t axis = 0, bins = 0, at = 0;  ///< bins below `at` go left; none for 0
  T first{}, per_length{};

  std::size_t bin(const TreePiece<T>& piece) const {
    const T along = (piece.box.lower[axis] * T(0.5) + piece.box.upper[axis] * T(0.5) - first) * per_length;
    return std::min(static_cast<std::size_t>(along), bins - 1);
  }
};

/// A binary tree by the surface-area heuristic.
template <class T>
class BinaryBuilder {
 public:
  explicit BinaryBuilder(std::vector<TreePiece<T>>& pieces) : pieces_(pieces) {
    nodes_.reserve(pieces.size());
    Range<T> all{0, pieces.size()};
    for (const TreePiece<T>& piece : pieces) all.add(piece);
    build(all, WideTree<T>::deepest);
  }

  const std::vector<BinaryNode<T>>& nodes() const { return nodes_; }

 private:
  std::uint32_t build(const Range<T>& range, int levels) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({range.box, static_cast<std::uint32_t>(range.begin), static_cast<std::uint32_t>(range.count())});
    if (range.count() <= WideTree<T>::leaf_size) return index;

    // Halving takes as many levels as the count has bits: once no more are left, only that.
    const bool free = levels > static_cast<int>(std::bit_width(range.count()));
    const Split<T> split = free ? best_split(range) : Split<T>{};
    Range<T> left{range.begin, range.begin}, right{range.end, range.end};
    split.at > 0 ? partition(range, split, left, right) : halve(range, left, right);
    build(left, levels - 1);
    const std::uint32_t second = build(right, levels - 1);
    nodes_[index].first = second;
    nodes_[index].count = 0;
    return index;
  }

  static std::size_t widest_axis(const Range<T>& range) {
    const Vec3<T> spread = range.middles.extent();
    return spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
  }

  /// The split between two bins along the axis on which the middles spread most that costs least: the sum of both
  /// sides' areas times their counts. None when the middles coincide, or areas over- or underflow.
  Split<T> best_split(const Range<T>& range) const {
    Split<T> split;
    split.axis = widest_axis(range);
    split.bins = std::min(most_bins, 4 + range.count() / 4);
    split.first = range.middles.lower[split.axis];
    split.per_length = static_cast<T>(split.bins) / (range.middles.upper[split.axis] - split.first);
    if (!std::isfinite(split.per_length) || !(split.per_length > T(0))) return split;

    Aabb<T> boxes[most_bins];
    std::size_t counts[most_bins];
    for (std::size_t i = 0; i < split.bins; ++i) {
      boxes[i] = Aabb<T>::empty();
      counts[i] = 0;
    }
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const std::size_t bin = split.bin(pieces_[i]);
      boxes[bin] = merged(boxes[bin], pieces_[i].box);
      ++counts[bin];
    }

    T right_cost[most_bins];
    Aabb<T> box = Aabb<T>::empty();
    std::size_t count = 0;
    for (std::size_t i = split.bins - 1; i > 0; --i) {
      box = merged(box, boxes[i]);
      count += counts[i];
      right_cost[i] = surface_area(box) * static_cast<T>(count);
    }
    box = Aabb<T>::empty();
    count = 0;
    T least_cost = std::numeric_limits<T>::infinity();
    for (std::size_t i = 1; i < split.bins; ++i) {
      box = merged(box, boxes[i - 1]);
      count += counts[i - 1];
      if (count == 0 || count == range.count()) continue;
      const T cost = surface_area(box) * static_cast<T>(count) + right_cost[i];
      if (!(cost < least_cost)) continue;
      least_cost = cost;
      split.at = i;
    }
    return split;
  }

  void partition(const Range<T>& range, const Split<T>& split, Range<T>& left, Range<T>& right) {
    std::size_t i = range.begin, end = range.end;
    while (i < end) {
      if (split.bin(pieces_[i]) < split.at)
        left.add(pieces_[i++]);
      else {
        right.add(pieces_[i]);
        std::swap(pieces_[i], pieces_[--end]);
      }
    }
    left.end = right.begin = i;
  }

  void halve(const Range<T>& range, Range<T>& left, Range<T>& right) {
    const std::size_t axis = widest_axis(range), half = range.begin + range.count() / 2;
    const auto at = [&](std::size_t i) { return pieces_.begin() + static_cast<std::ptrdiff_t>(i); };
    if (range.middles.lower[axis] < range.middles.upper[axis])
      std::nth_element(at(range.begin), at(half), at(range.end), [&](const TreePiece<T>& a, const TreePiece<T>& b) {
        const T ca = middle(a.box)[axis], cb = middle(b.box)[axis];
        return ca != cb ? ca < cb : a.number < b.number;
      });
    left.end = right.begin = half;
    for (std::size_t i = range.begin; i < half; ++i) left.add(pieces_[i]);
    for (std::size_t i = half; i < range.end; ++i) right.add(pieces_[i]);
  }

  std::vector<TreePiece<T>>& pieces_;
  std::vector<BinaryNode<T>> nodes_;
};

/// The frame of a box: steps so wide that the last one reaches the upper side, as `at` rounds it.
template <class T>
void set_frame(TreeNode<T>& node, const Aabb<T>& box) {
  constexpr unsigned steps = TreeNode<T>::steps;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const T top = box.upper[axis];
    T &origin = node.origin[axis], &step = node.step[axis];
    origin = box.lower[axis];
    const T extent = top - origin;
    step = std::isfinite(extent) ? extent / T(steps) : top / T(steps) - origin / T(steps);
    // The rounding of `at` is a few units of the larger side: doubled, a step soon passes it.
    for (T more = std::numeric_limits<T>::epsilon() * greatest(std::abs(top), std::abs(origin)) / T(steps);
         node.at(axis, steps) < top; more *= T(2))
      step = greatest(step + more, std::nextafter(step, std::numeric_limits<T>::max()));
  }
}

template <class T>
void set_lane(TreeNode<T>& node, std::size_t i, const Aabb<T>& box) {
  constexpr unsigned steps = TreeNode<T>::steps;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = [&](unsigned q) { return node.at(axis, q); };
    const auto nearest = [&](T value) {
      if (!(node.step[axis] > T(0))) return 0u;
      const T q = (value - node.origin[axis]) / node.step[axis];
      return q > T(0) ? static_cast<unsigned>(least(q, T(steps))) : 0u;
    };
    unsigned low = nearest(box.lower[axis]), high = nearest(box.upper[axis]);
    while (low < steps && at(low + 1) <= box.lower[axis]) ++low;
    while (low > 0 && at(low) > box.lower[axis]) --low;
    while (high > 0 && at(high - 1) >= box.upper[axis]) --high;
    while (high < steps && at(high) < box.upper[axis]) ++high;
    node.lower[axis][i] = static_cast<std::uint8_t>(low);
    node.upper[axis][i] = static_cast<std::uint8_t>(high);
  }
}

/// Which nodes of a binary tree to make wide: the choice whose nodes and leaves are met least often by what is met in
/// proportion to area (Ylitie, Karras, Laine 2017, section 4).
template <class T>
class Collapse {
 public:
  static constexpr std::size_t width = WideTree<T>::width;
  using Lanes = std::uint32_t[width];

  explicit Collapse(const std::vector<BinaryNode<T>>& binary) : binary_(binary), costs_(binary.size()) {
    for (std::size_t i = binary.size(); i-- > 0;) costs_[i] = cost_of(static_cast<std::uint32_t>(i));
  }

  /// The children of the wide node that a binary one becomes, from left to right; a leaf is its own. Returns how many.
  std::size_t children(std::uint32_t node, Lanes& lanes) const {
    std::size_t count = 0;
    if (binary_[node].count > 0)
      lanes[count++] = node;
    else
      split(node, width, lanes, count);
    return count;
  }

 private:
  /// What the pieces below a node cost as children of another: as one, as at most two, and so on.
  using Costs = std::array<T, width>;
  struct Choice {
    T cost;
    std::size_t left;  ///< children from the left one of two
  };

  /// The best way to make at most so many children of what is below a node's two.
  Choice best(std::uint32_t node, std::size_t most) const {
    const Costs &left = costs_[node + 1], &right = costs_[binary_[node].first];
    Choice found{left[0] + right[most - 2], 1};
    for (std::size_t i = 2; i < most; ++i)
      if (const T cost = left[i - 1] + right[most - i - 1]; cost < found.cost) found = {cost, i};
    return found;
  }

  Costs cost_of(std::uint32_t node) const {
    Costs costs;
    const T area = surface_area(binary_[node].box);
    costs[0] = binary_[node].count > 0 ? area : area + best(node, width).cost;
    for (std::size_t most = 2; most <= width; ++most)
      costs[most - 1] = binary_[node].count > 0 ? area : least(costs[most - 2], best(node, most).cost);
    return costs;
  }

  void split(std::uint32_t node, std::size_t most, Lanes& lanes, std::size_t& count) const {
    const std::size_t left = best(node, most).left;
    add(node + 1, left, lanes, count);
    add(binary_[node].first, most - left, lanes, count);
  }
  /// Adds at most so many children: fewer where more cost more.
  void add(std::uint32_t node, std::size_t most, Lanes& lanes, std::size_t& count) const {
    if (binary_[node].count > 0) most = 1;
    while (most > 1 && costs_[node][most - 2] < best(node, most).cost) --most;
    if (most > 1) return split(node, most, lanes, count);
    lanes[count++] = node;
  }

  const std::vector<BinaryNode<T>>& binary_;
  std::vector<Costs> costs_;
};

}  // namespace

/// Makes the binary tree wide.
template <class T>
class WideTree<T>::Builder {
 public:
  Builder(WideTree& tree, const std::vector<TreePiece<T>>& pieces, const std::vector<BinaryNode<T>>& binary)
      : tree_(tree), pieces_(pieces), binary_(binary) {
    const Collapse<T> collapse(binary);
    tree_.order_.reserve(pieces.size());
    std::vector<std::uint32_t> sources{0};  // the binary node of each wide one
    tree_.nodes_.push_back({});
    for (std::uint32_t at = 0; at < sources.size(); ++at) {
      std::uint32_t lanes[width];
      const std::size_t count = collapse.children(sources[at], lanes);
      const auto inner =
          std::stable_partition(lanes, lanes + count, [&](std::uint32_t i) { return binary_[i].count == 0; });
      tree_.nodes_[at] = node_of(binary_[sources[at]].box, lanes, count, static_cast<std::size_t>(inner - lanes));
      for (const std::uint32_t* lane = lanes; lane != inner; ++lane) sources.push_back(*lane);
      tree_.nodes_.resize(sources.size());
    }
  }

 private:
  Node node_of(const Aabb<T>& box, const std::uint32_t (&lanes)[width], std::size_t count, std::size_t inner) {
    Node node{};
    set_frame(node, box);
    node.first_child = static_cast<std::uint32_t>(tree_.nodes_.size());
    node.first_piece = static_cast<std::uint32_t>(tree_.order_.size());
    node.first_leaf = static_cast<std::uint32_t>(tree_.leaves_);
    tree_.leaves_ += count - inner;
    node.inner = static_cast<std::uint8_t>(inner);
    node.count = static_cast<std::uint8_t>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const BinaryNode<T>& child = binary_[lanes[i]];
      set_lane(node, i, child.box);
      if (i < inner) continue;
      node.pieces[i] = static_cast<std::uint8_t>(8 * (tree_.order_.size() - node.first_piece) + child.count);
      for (std::uint32_t k = 0; k < child.count; ++k) tree_.order_.push_back(pieces_[child.first + k].number);
    }
    return node;
  }

  WideTree& tree_;
  const std::vector<TreePiece<T>>& pieces_;
  const std::vector<BinaryNode<T>>& binary_;
};

template <class T>
WideTree<T>::WideTree(std::vector<TreePiece<T>> pieces) {
  if (pieces.empty()) return;
  const BinaryBuilder<T> binary(pieces);
  bounds_ = binary.nodes().front().box;
  Builder(*this, pieces, binary.nodes());
  nodes_.shrink_to_fit();
}

template class WideTree<float>;
template class WideTree<double>;

}  // namespace graze
