// Traversal of a tree of triangles by a ray: the triangles that it may cross, in the order in which it enters the
// leaves. Takes plain numbers, so that it can be compiled for each instruction set.
//
// Guarantee: no triangle is left out that the exact ray crosses, or that `crossing` finds crossed or seen edge-on:
// boxes are widened, and triangles rejected, by more than rounding moves anything here. The few further triangles are
// left to the caller's exact test; so answers are equal at every level of the instruction set.
//
// Sources: Kay, Kajiya 1986, "Ray tracing complex scenes" (slabs); Ylitie, Karras, Laine 2017, "Efficient incoherent
// ray traversal on GPUs through compressed wide BVHs" (boxes kept in eight bits: along an axis the ray passes step q of
// the node's frame at a q + b, with a and b the same for all children; the stack holds nodes with their remaining
// children).
#pragma once

#include "shape/packed_leaf.hpp"
#include "shape/tree_node.hpp"
#include "simd/dispatch.hpp"

namespace graze {

/// A ray and a tree, in units of length, in the tree's frame. The ray passes the ball of that `radius` about the tree's
/// bounds, up to a rounding, and its origin is the point of it, or of its part, nearest to the ball's centre: so all
/// hits are within `radius` of its origin.
template <class T>
struct BvhQuestion {
  const TreeNode<T>* nodes;
  const PackedLeaf* leaves;
  double extent;  ///< bound of all corners' distances from the frame's origin
  double radius;
  double origin[3], direction[3];
  double begin, end;

  /// Called with a triangle by its place in the tree's order; returns the length up to which the ray is still to be
  /// followed.
  double (*found)(void* owner, std::uint32_t place);
  void* owner;
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    template <class T> void traverse_bvh(const BvhQuestion<T>& question);)
// clang-format on

namespace rays {

/// The length up to which to follow a ray that hit something at `along`, relative to an origin `shift` further on: so
/// far that any hit equally near within rounding is found too, and the first of equal ones does not depend on the
/// order.
[[gnu::always_inline]] inline double end_after(double along, double shift) {
  const double size = (along < 0 ? -along : along) + (shift < 0 ? -shift : shift);
  return along - shift + 4 * 0x1p-52 * size;
}

}  // namespace rays

}  // namespace graze
