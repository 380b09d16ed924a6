// A tree of bounds with eight children a node: what every composite is searched by.
//
// Guarantee: built once and immutable, safe to query from any thread; every piece is in exactly one leaf, and the box of
// each node and leaf, though kept in eight bits a side, contains its pieces'. Not deeper than `deepest` binary splits,
// whatever the pieces: neither equal ones nor any number of them need recursion or memory beyond that.
//
// Sources: Wald 2007, "On fast construction of SAH-based bounding volume hierarchies" (binned splits); Wald, Benthin,
// Boulos 2008, "Getting rid of packets" (a binary tree made wide); Ylitie, Karras, Laine 2017, "Efficient incoherent ray
// traversal on GPUs through compressed wide BVHs" (boxes relative to the node's).
#pragma once

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "shape/hierarchy.hpp"
#include "shape/tree_ray.hpp"

namespace graze {

/// What a tree is built of: a finite box, and the number that its owner knows the piece by.
template <class T>
struct TreePiece {
  Aabb<T> box;
  std::uint32_t number;
};

template <class T>
class WideTree {
 public:
  static constexpr std::size_t width = 8, leaf_size = 4;
  static constexpr int deepest = 48;
  /// A node by its place; or, with the highest bit set, a leaf by eight times its node's place and its lane there.
  using Ref = std::uint32_t;
  using Children = ChildBoxes<T, Ref, width>;

  WideTree() = default;
  /// Cost n log n: a million triangles take a third of a second.
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
    if (leaf(ref)) return nodes_[(ref & ~leaf_bit) / width].lane(ref % width);
    return nodes_[ref].box();
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
    const std::uint8_t pieces = node.pieces[ref % width];
    const std::uint32_t* number = order_.data() + node.first_piece + (pieces >> 3);
    for (unsigned i = 0; i < (pieces & 7u); ++i)
      if (!go_on(f, number[i])) return false;
    return true;
  }

  /// The numbers of all pieces, those of a leaf side by side.
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// Calls `f(first, count)` for each leaf that the ray crosses by `limit()`, with the places of its pieces in `order()`,
  /// in the order in which it enters them; `limit()` is asked again on the way.
  /// `soon(first)` is called some time before for the same leaves and for others, so that what `f` needs may be fetched.
  template <class Limit, class Soon, class F>
  void each_leaf(const TreeRay<T>& ray, const Limit& limit, const Soon& soon, F&& f) const {
    struct Entry {
      Ref ref;
      T key;
    };
    TraversalStack<Entry> stack;
    if (nodes_.empty()) return;
    Entry next{root(), std::numeric_limits<T>::lowest()};
    for (;;) {
      const T most = ray.limit(limit());
      if (next.key <= most) {
        if (leaf(next.ref)) {
          const Node& node = nodes_[(next.ref & ~leaf_bit) / width];
          const std::uint8_t pieces = node.pieces[next.ref % width];
          f(std::size_t{node.first_piece} + (pieces >> 3), std::size_t{pieces & 7u});
        } else {
          const Node& node = nodes_[next.ref];
          T keys[width];
          std::uint32_t bits = ray.crossed(node, most, keys);
          const auto entry = [&](std::uint32_t bit) {
            const auto i = static_cast<std::uint32_t>(std::countr_zero(bit));
            if (i < node.inner) {
              // A node lies on two lines, of 64 bytes as on most machines.
              const auto* child = reinterpret_cast<const char*>(&nodes_[node.first_child + i]);
              __builtin_prefetch(child);
              __builtin_prefetch(child + 64);
              return Entry{node.first_child + i, keys[i]};
            }
            soon(std::size_t{node.first_piece} + (node.pieces[i] >> 3));
            return Entry{leaf_bit | static_cast<Ref>(next.ref * width + i), keys[i]};
          };
          if (bits != 0) {
            // The nearest is gone to at once; the others wait in the order of their keys, of equals the first on top.
            Entry waiting[width], nearest = entry(bits);
            std::size_t count = 0;
            while (bits &= bits - 1) {
              Entry further = entry(bits);
              if (further.key < nearest.key) std::swap(further, nearest);
              std::size_t at = count++;
              for (; at > 0 && waiting[at - 1].key <= further.key; --at) waiting[at] = waiting[at - 1];
              waiting[at] = further;
            }
            for (std::size_t i = 0; i < count; ++i) stack.push(waiting[i]);
            next = nearest;
            continue;
          }
        }
      }
      if (stack.empty()) return;
      next = stack.pop();
    }
  }

 private:
  static constexpr Ref leaf_bit = 0x80000000u;
  static constexpr unsigned steps = 255;

  /// Its inner children come first, and stand one behind the other in the array of nodes; then its leaves, whose pieces
  /// stand one behind the other in the order of pieces.
  struct Node {
    T origin[3], step[3];
    std::uint32_t first_child, first_piece;
    std::uint8_t inner, count;
    std::uint8_t pieces[width];  ///< of a leaf: eight times its first piece's place from `first_piece`, plus how many
    std::uint8_t lower[3][width], upper[3][width];

    /// One expression for the builder and for queries: what the builder found to contain, contains.
    T at(std::size_t axis, unsigned q) const { return origin[axis] + static_cast<T>(static_cast<int>(q)) * step[axis]; }
    Aabb<T> lane(std::size_t i) const {
      return {{at(0, lower[0][i]), at(1, lower[1][i]), at(2, lower[2][i])},
              {at(0, upper[0][i]), at(1, upper[1][i]), at(2, upper[2][i])}};
    }
    Aabb<T> box() const { return {{origin[0], origin[1], origin[2]}, {at(0, steps), at(1, steps), at(2, steps)}}; }
    void frame(const Aabb<T>& box);
    void set_lane(std::size_t i, const Aabb<T>& box);
  };
  class Builder;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  Aabb<T> bounds_ = Aabb<T>::empty();
};

extern template class WideTree<float>;
extern template class WideTree<double>;

}  // namespace graze
