// A binary tree of bounds over the pieces of a composite.
//
// Guarantee: built once and immutable; a depth of at most 2 log2(n) + 1, since every split halves its pieces by the
// median; queries visit exactly the leaves whose bounds the predicate accepts.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "graze/aabb.hpp"

namespace graze {

template <class T>
class BoundsTree {
 public:
  struct Node {
    Aabb<T> box;
    std::uint32_t first;  ///< leaf: the first place in `order`; else the right child (the left one follows its parent)
    std::uint32_t count;  ///< leaf: how many pieces; else 0
  };

  BoundsTree() = default;
  explicit BoundsTree(std::span<const Aabb<T>> pieces) : order_(pieces.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!pieces.empty()) build(pieces, 0, pieces.size());
  }

  bool empty() const { return nodes_.empty(); }
  const Aabb<T>& bounds() const { return nodes_.front().box; }
  std::span<const Node> nodes() const { return nodes_; }
  /// The pieces of a leaf.
  std::span<const std::uint32_t> pieces(const Node& leaf) const {
    return std::span(order_).subspan(leaf.first, leaf.count);
  }

  /// Calls `f(piece)` for every piece of the leaves whose bounds overlap `box`.
  template <class F>
  void overlapping(const Aabb<T>& box, F&& f) const {
    if (!empty()) descend(0, box, f);
  }

 private:
  static constexpr std::size_t leaf_size = 4;

  std::uint32_t build(std::span<const Aabb<T>> pieces, std::size_t begin, std::size_t end) {
    Aabb<T> box = Aabb<T>::empty(), centers = Aabb<T>::empty();
    for (std::size_t i = begin; i < end; ++i) {
      box = merged(box, pieces[order_[i]]);
      centers = merged(centers, pieces[order_[i]].center());
    }
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({box, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)});
    if (end - begin <= leaf_size) return index;

    const Vec3<T> spread = centers.extent();
    const std::size_t axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
      const T ca = pieces[a].center()[axis], cb = pieces[b].center()[axis];
      return ca != cb ? ca < cb : a < b;
    });
    build(pieces, begin, middle);
    const std::uint32_t right = build(pieces, middle, end);
    nodes_[index].first = right;
    nodes_[index].count = 0;
    return index;
  }

  template <class F>
  void descend(std::uint32_t index, const Aabb<T>& box, F& f) const {
    const Node& node = nodes_[index];
    if (!overlap(node.box, box)) return;
    if (node.count == 0) {
      descend(index + 1, box, f);
      descend(node.first, box, f);
      return;
    }
    for (const std::uint32_t piece : pieces(node)) f(piece);
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace graze
