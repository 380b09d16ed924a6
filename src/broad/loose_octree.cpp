#include <algorithm>

#include "broad/hierarchy_queries.hpp"

namespace graze {

namespace {

/// Levels below the root: the smallest cells are 2^-20 of it, a millimetre in a kilometre. Bounds all recursion.
constexpr unsigned max_cell_depth = 20;
/// A cell with no more boxes keeps those that would fit its children: as many tests cost less than a level more.
constexpr std::size_t max_crowd = 8;
/// The share of boxes, one in so many, that may lie outside the root before it is chosen anew.
constexpr std::size_t max_astray_share = 8;

/// Cubes halved along each axis. A box belongs to the cell that its centre is in, on the level where a cell is as long
/// as the box or more: then it sticks out by half a cell at most. The places of boxes are a matter of speed only: each
/// node has the bounds of all boxes in and below it, and these alone decide what is looked at.
template <class T>
class LooseOctree final : public BroadPhase<T> {
 public:
  void insert(std::uint32_t id, const Aabb<T>& box) override {
    boxes_.insert(id, box);
    spot_.emplace_back();
    put(static_cast<std::uint32_t>(boxes_.size() - 1));
    if (is_worn()) build();
  }
  void remove(std::uint32_t id) override {
    const std::uint32_t hole = boxes_.place(id);
    take(hole);
    boxes_.remove(id);
    if (hole < boxes_.size()) {
      spot_[hole] = spot_.back();
      nodes_[spot_[hole].node].items[spot_[hole].index] = hole;
    }
    spot_.pop_back();
  }
  void move(std::uint32_t id, const Aabb<T>& box) override {
    const std::uint32_t place = boxes_.move(id, box);
    take(place);
    put(place);
    if (is_worn()) build();
  }

  void pairs(std::vector<IdPair>& out) override { find(out, false); }
  void moved_pairs(std::vector<IdPair>& out) override { find(out, true); }
  std::uint64_t tests() const override { return tests_; }

  void query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const override {
    graze::query(*this, boxes_, box, out);
  }
  void sweep(const Aabb<T>& box, const Vec3<T>& motion, std::vector<std::uint32_t>& out) const override {
    graze::sweep(*this, boxes_, box, motion, out);
  }
  /// Calls `see(place)` for all boxes, except below where `enter(bounds)` refuses.
  template <class Enter, class See>
  void for_each(const Enter& enter, const See& see) const {
    std::vector<std::uint32_t> stack;
    visit(0, enter, see, stack);
  }
  /// The cells as they are halved, without the parts of boxes that stick out of them.
  void parts(std::vector<BroadPhasePart<T>>& out) const override {
    out.clear();
    if (boxes_.size() == 0) return;
    struct Visit {
      std::uint32_t node, depth;
      Cube cube;
    };
    std::vector<std::size_t> held(nodes_.size(), 0);  // in and below each node
    for (std::size_t n = nodes_.size(); n-- > 0;) {   // children come after their parents
      held[n] = nodes_[n].items.size();
      if (nodes_[n].children != 0)
        for (unsigned c = 0; c < 8; ++c) held[n] += held[nodes_[n].children + c];
    }
    std::vector<Visit> visits{{0, 0, root_}};
    for (std::size_t i = 0; i < visits.size(); ++i) {
      const Visit visit = visits[i];
      const Vec3<T> half{visit.cube.half, visit.cube.half, visit.cube.half};
      out.push_back({{visit.cube.center - half, visit.cube.center + half}, visit.depth});
      const std::uint32_t first = nodes_[visit.node].children;
      for (unsigned c = 0; first != 0 && c < 8; ++c)
        if (held[first + c] != 0) visits.push_back({first + c, visit.depth + 1, visit.cube.child(c)});
    }
  }
  std::size_t memory() const override {
    std::size_t items = 0;
    for (const Node& node : nodes_) items += node.items.capacity();
    return boxes_.memory() + spot_.capacity() * sizeof(Spot) + nodes_.capacity() * sizeof(Node) +
           (items + stack_.capacity()) * sizeof(std::uint32_t);
  }

 private:
  struct Node {
    Aabb<T> bounds = Aabb<T>::empty();  ///< of what is in and below it, or more
    std::uint32_t children = 0;         ///< the first of eight; 0 for none
    std::vector<std::uint32_t> items;
  };
  struct Spot {
    std::uint32_t node = 0, index = 0;
  };
  struct Cube {
    Vec3<T> center{};
    T half = 0;

    Cube child(unsigned octant) const {
      Cube c{center, half * T(0.5)};
      for (std::size_t i = 0; i < 3; ++i) c.center[i] += (octant >> i & 1) != 0 ? c.half : -c.half;
      return c;
    }
    unsigned octant(const Vec3<T>& p) const {
      return (p.x >= center.x ? 1u : 0u) | (p.y >= center.y ? 2u : 0u) | (p.z >= center.z ? 4u : 0u);
    }
  };

  static bool is_finite(const Aabb<T>& box) { return max_abs(box.extent()) <= std::numeric_limits<T>::max(); }

  void put(std::uint32_t place) {
    const Aabb<T>& box = boxes_[place].box;
    if (is_finite(box) && !(max_abs(box.center() - root_.center) <= root_.half)) ++astray_;
    put(place, 0, root_, 0);
  }
  /// Puts a box into the node or one below it. A full node hands the boxes that fit its new children on to them.
  void put(std::uint32_t place, std::uint32_t node, Cube cube, unsigned depth) {
    const Aabb<T>& box = boxes_[place].box;
    for (;; ++depth) {
      nodes_[node].bounds = merged(nodes_[node].bounds, box);
      if (!fits_child(box, cube, depth)) break;
      if (nodes_[node].children == 0) {
        if (nodes_[node].items.size() < max_crowd) break;
        split(node, cube, depth);
      }
      const unsigned octant = cube.octant(box.center());
      node = nodes_[node].children + octant;
      cube = cube.child(octant);
    }
    hang(place, node);
  }
  /// Whether a box fits a child of the cell. Infinite and NaN lengths are below no limit.
  static bool fits_child(const Aabb<T>& box, const Cube& cube, unsigned depth) {
    return depth < max_cell_depth && max_abs(box.extent()) <= cube.half && is_finite(box);
  }
  void split(std::uint32_t node, const Cube& cube, unsigned depth) {
    nodes_[node].children = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 8);
    std::vector<std::uint32_t> items;
    items.swap(nodes_[node].items);
    for (const std::uint32_t place : items) {
      if (!fits_child(boxes_[place].box, cube, depth)) {
        hang(place, node);
        continue;
      }
      const unsigned octant = cube.octant(boxes_[place].box.center());
      put(place, nodes_[node].children + octant, cube.child(octant), depth + 1);
    }
  }
  void hang(std::uint32_t place, std::uint32_t node) {
    spot_[place] = {node, static_cast<std::uint32_t>(nodes_[node].items.size())};
    nodes_[node].items.push_back(place);
  }
  void take(std::uint32_t place) {
    const Spot spot = spot_[place];
    auto& items = nodes_[spot.node].items;
    items[spot.index] = items.back();
    spot_[items[spot.index]].index = spot.index;
    items.pop_back();
  }

  /// Whether the root no longer suits the boxes, or too many nodes are left over from where boxes have been.
  bool is_worn() const {
    return astray_ * max_astray_share > boxes_.size() || nodes_.size() > 2 * nodes_built_ + boxes_.size() + 64;
  }
  void build() {
    choose_root();
    nodes_.assign(1, {});
    for (std::uint32_t place = 0; place < boxes_.size(); ++place) put(place);
    astray_ = 0;  // boxes that are still outside stay there, and do not call for another root
    nodes_built_ = nodes_.size();
  }
  /// Chooses a root around all but the outermost of the centres on each axis, and as much again: so a few boxes far
  /// away do not make all others share a cell. Those then count for the outermost cells.
  void choose_root() {
    root_ = {};
    std::vector<T> centers;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      centers.clear();
      for (const auto& e : boxes_)
        if (is_finite(e.box)) centers.push_back(e.box.center()[axis]);
      if (centers.empty()) return;
      const std::size_t n = centers.size(), few = n / (4 * max_astray_share);
      const auto low = centers.begin() + static_cast<std::ptrdiff_t>(few);
      const auto high = centers.begin() + static_cast<std::ptrdiff_t>(n - 1 - few);
      std::nth_element(centers.begin(), low, centers.end());
      if (low != high) std::nth_element(low + 1, high, centers.end());
      root_.center[axis] = (*low + *high) * T(0.5);
      root_.half = greatest(root_.half, *high - *low);
    }
  }

  void find(std::vector<IdPair>& out, bool moved_only) {
    tighten();
    tests_ = boxes_.collect_pairs(out, moved_only, [&](auto& test) { within(0, test); });
  }
  /// Shrinks the bounds of nodes that boxes have left. Children come after their parents.
  void tighten() {
    for (std::size_t n = nodes_.size(); n-- > 0;) {
      Node& node = nodes_[n];
      node.bounds = Aabb<T>::empty();
      for (const std::uint32_t place : node.items) node.bounds = merged(node.bounds, boxes_[place].box);
      if (node.children != 0)
        for (unsigned c = 0; c < 8; ++c) node.bounds = merged(node.bounds, nodes_[node.children + c].bounds);
    }
  }
  /// Tests all pairs of which both are in or below the node.
  template <class Test>
  void within(std::uint32_t n, Test& test) {
    const Node& node = nodes_[n];
    for (std::size_t i = 0; i < node.items.size(); ++i)
      for (std::size_t j = i + 1; j < node.items.size(); ++j) test(node.items[i], node.items[j]);
    if (node.children == 0) return;
    for (unsigned c = 0; c < 8; ++c) {
      against(node, node.children + c, test);
      within(node.children + c, test);
      for (unsigned d = c + 1; d < 8; ++d) between(node.children + c, node.children + d, test);
    }
  }
  /// Tests all pairs of one in or below the first node and one in or below the second.
  template <class Test>
  void between(std::uint32_t m, std::uint32_t n, Test& test) {
    const Node &a = nodes_[m], &b = nodes_[n];
    if (!test.overlapping(a.bounds, b.bounds)) return;
    against(a, n, test);
    if (a.children == 0) return;
    for (unsigned c = 0; c < 8; ++c) {
      against(b, a.children + c, test);
      if (b.children == 0) continue;
      for (unsigned d = 0; d < 8; ++d) between(a.children + c, b.children + d, test);
    }
  }
  /// Tests all pairs of an item of the node and one in or below the other.
  template <class Test>
  void against(const Node& node, std::uint32_t n, Test& test) {
    for (const std::uint32_t item : node.items) {
      const Aabb<T>& box = boxes_[item].box;
      visit(
          n, [&](const Aabb<T>& bounds) { return test.overlapping(bounds, box); },
          [&](std::uint32_t other) { test(item, other); }, stack_);
    }
  }

  /// Calls `see(place)` for all boxes in and below the node, except where `enter(bounds)` refuses.
  template <class Enter, class See>
  void visit(std::uint32_t root, const Enter& enter, const See& see, std::vector<std::uint32_t>& stack) const {
    stack.assign(1, root);
    while (!stack.empty()) {
      const Node& node = nodes_[stack.back()];
      stack.pop_back();
      if (!enter(node.bounds)) continue;
      for (const std::uint32_t place : node.items) see(place);
      if (node.children != 0)
        for (unsigned c = 0; c < 8; ++c) stack.push_back(node.children + c);
    }
  }

  BoxTable<T> boxes_;
  std::vector<Spot> spot_;  ///< of each place in the table
  std::vector<Node> nodes_ = std::vector<Node>(1);
  Cube root_;
  std::size_t astray_ = 0;  ///< boxes put outside the root since it was chosen
  std::size_t nodes_built_ = 1;
  std::uint64_t tests_ = 0;
  std::vector<std::uint32_t> stack_;  ///< kept for its storage
};

}  // namespace

template <class T>
std::unique_ptr<BroadPhase<T>> make_loose_octree() {
  return std::make_unique<LooseOctree<T>>();
}

template std::unique_ptr<BroadPhase<float>> make_loose_octree();
template std::unique_ptr<BroadPhase<double>> make_loose_octree();

}  // namespace graze
