// A tree of bounds with eight children a node, by which every composite is searched.
//
// Guarantee: built once and immutable, safe to query from any thread; every piece is in exactly one leaf, and the box
// of each node and leaf, though kept in eight bits a side, contains its pieces'. Not deeper than `deepest` binary
// splits, whatever the pieces: neither equal ones nor any number of them need recursion or memory beyond that.
//
// Sources: Wald 2007, "On fast construction of SAH-based bounding volume hierarchies" (binned splits); Wald, Benthin,
// Boulos 2008, "Getting rid of packets" (a binary tree made wide); Ylitie, Karras, Laine 2017, "Efficient incoherent
// ray traversal on GPUs through compressed wide BVHs" (boxes relative to the node's).
#pragma once

#include <cstdint>
#include <vector>

#include "shape/hierarchy.hpp"
#include "shape/tree_node.hpp"

namespace graze {

/// A piece of which a tree is built: a finite box, and the number that its owner gave the piece.
template <class T>
struct TreePiece {
  Aabb<T> box;
  std::uint32_t number;
};

template <class T>
class WideTree {
 public:
  using Node = TreeNode<T>;
  static constexpr std::size_t width = Node::width, leaf_size = Node::leaf_size;
  static constexpr int deepest = Node::deepest;
  /// A node by its place; or, with the highest bit set, a leaf by eight times its node's place and its lane there.
  using Ref = std::uint32_t;
  using Children = ChildBoxes<T, Ref, width>;

  WideTree() = default;
  /// Builds the tree. Cost n log n: a million triangles take a third of a second.
  explicit WideTree(std::vector<TreePiece<T>> pieces);

  bool empty() const { return nodes_.empty(); }
  /// The exact bounds of all pieces.
  const Aabb<T>& bounds() const { return bounds_; }
  std::size_t size() const { return order_.size(); }
  /// Bytes that the tree keeps.
  std::size_t memory() const { return nodes_.size() * sizeof(Node) + order_.size() * sizeof order_[0]; }

  Ref root() const { return 0; }
  bool leaf(Ref ref) const { return (ref & leaf_bit) != 0; }

  Aabb<T> box(Ref ref) const {
    if (leaf(ref)) return lane(nodes_[(ref & ~leaf_bit) / width], ref % width);
    return box(nodes_[ref]);
  }

  void children(Ref ref, Children& out) const {
    const Node& node = nodes_[ref];
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < width; ++i) {
        out.lower[axis][i] = node.at(axis, node.lower[axis][i]);
        out.upper[axis][i] = node.at(axis, node.upper[axis][i]);
      }
    for (std::uint32_t i = 0; i < width; ++i)
      out.ref[i] = i < node.inner ? node.first_child + i : (leaf_bit | static_cast<Ref>(ref * width + i));
    out.count = node.count;
  }

  /// Calls `f(number)` for each piece of a leaf, until it returns false.
  template <class F>
  bool each_piece(Ref ref, F& f) const {
    const Node& node = nodes_[(ref & ~leaf_bit) / width];
    const std::uint32_t* number = order_.data() + node.first_of(ref % width);
    const std::uint32_t count = node.pieces_of(ref % width);
    for (std::uint32_t i = 0; i < count; ++i)
      if (!go_on(f, number[i])) return false;
    return true;
  }

  /// The numbers of all pieces, those of a leaf side by side.
  const std::vector<std::uint32_t>& order() const { return order_; }

  const std::vector<Node>& nodes() const { return nodes_; }
  std::size_t leaves() const { return leaves_; }

 private:
  static constexpr Ref leaf_bit = 0x80000000u;

  static Aabb<T> lane(const Node& node, std::size_t i) {
    const auto corner = [&](const std::uint8_t(&q)[3][width]) {
      return Vec3<T>{node.at(0, q[0][i]), node.at(1, q[1][i]), node.at(2, q[2][i])};
    };
    return {corner(node.lower), corner(node.upper)};
  }
  static Aabb<T> box(const Node& node) {
    return {{node.origin[0], node.origin[1], node.origin[2]},
            {node.at(0, Node::steps), node.at(1, Node::steps), node.at(2, Node::steps)}};
  }
  class Builder;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::size_t leaves_ = 0;
  Aabb<T> bounds_ = Aabb<T>::empty();
};

extern template class WideTree<float>;
extern template class WideTree<double>;

}  // namespace graze
