// Many rays at a mesh of triangles, all in flight at once: each step is done for all rays that are due for it before
// the next step, so that one ray's memory latency is hidden by the work on others, and an unpredictable branch becomes
// a choice of list.
//
// Guarantee: every hit has the bits that `cast_at_surface` (`surface.hpp`) finds for that ray alone: the same triangles
// are crossed or not by the same operations, and the first is chosen in whichever order they are met. Rays that would
// need rarely used code get the state `ray_again`.
#pragma once

#include "rays/bvh_traversal.hpp"
#include "rays/ray_block.hpp"

namespace graze::rays {

template <class T>
struct BlockMesh {
  const TreeNode<T>* nodes;
  const PackedLeaf* leaves;
  const T* points;                 ///< three numbers each
  const std::uint32_t* triangles;  ///< three points each
  const std::uint32_t* order;
  double extent;             ///< bound of all corners' distances from the frame's origin
  double center[3], radius;  ///< a ball that contains all corners
  bool both_sides;
  bool any;  ///< any hit will do
};

}  // namespace graze::rays

namespace graze {

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Sets `state`, the hits and the `pieces` that are hit, of `count` rays and of those that fill up their lanes.
    template <class T> void block_at_mesh(rays::RayBlock& block, std::size_t count, const rays::BlockMesh<T>& mesh,
                                          std::uint32_t* pieces);)
// clang-format on

}  // namespace graze
