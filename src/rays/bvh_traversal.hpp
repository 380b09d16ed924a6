// A ray down a tree of triangles: which of them it may cross, in the order in which it enters the leaves. Plain numbers
// in, so that it can be compiled for each instruction set.
//
// Guarantee: no triangle is left out that the exact ray crosses, or that `crossing` finds crossed or seen edge-on:
// boxes are widened, and triangles told to be passed, by more than rounding moves anything here. What is not left out
// is little more, and for the one who asks to judge; so his answer is the same at every level of the instruction set.
//
// Sources: Kay, Kajiya 1986, "Ray tracing complex scenes" (slabs); Ylitie, Karras, Laine 2017, "Efficient incoherent
// ray traversal on GPUs through compressed wide BVHs" (boxes kept in eight bits: along an axis the ray passes step q of
// the node's frame at a q + b, with a and b the same for all children; on the stack lie nodes with what is left of
// them).
#pragma once

#include "shape/packed_leaf.hpp"
#include "shape/tree_node.hpp"
#include "simd/dispatch.hpp"

namespace graze {

/// In units of length, in the tree's frame. The ray passes the ball of that `radius` about the tree's bounds, up to a
/// rounding, and its origin is that point of it, or of its part, that is nearest to the ball's centre: so whatever it
/// meets is within `radius` of its origin.
template <class T>
struct BvhQuestion {
  const TreeNode<T>* nodes;
  const PackedLeaf* leaves;
  double extent;  ///< no corner is further from the frame's origin
  double radius;
  double origin[3], direction[3];
  double begin, end;

  /// Is told a leaf and which of its triangles; returns how far the ray has still to be followed.
  double (*found)(void* owner, const PackedLeaf& leaf, std::size_t i);
  void* owner;
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    template <class T> void traverse_bvh(const BvhQuestion<T>& question);)
// clang-format on

namespace rays {

/// How far a ray is to be followed that hit something at `along`, as told from an origin `shift` further on: so far
/// that whatever rounding tells to lie as near is found too, and the first of equals does not depend on the order.
[[gnu::always_inline]] inline double end_after(double along, double shift) {
  const double size = (along < 0 ? -along : along) + (shift < 0 ? -shift : shift);
  return along - shift + 4 * 0x1p-52 * size;
}

}  // namespace rays

}  // namespace graze
