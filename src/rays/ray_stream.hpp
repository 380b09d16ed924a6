// Some rays at a mesh of triangles, all under way at once: each step is done for all rays that are to take it before
// the next one is, so that the memory that one ray waits for comes while others are worked on, and a branch that none
// can foresee becomes a choice of list.
//
// Guarantee: every hit has the bits that `cast_at_surface` (`surface.hpp`) finds for that ray alone: the same triangles
// are crossed or not by the same operations, and the first is chosen in whichever order they are met. Where that would
// take what rays hardly ever need, `ray_again` is told.
#pragma once

#include "rays/bvh_traversal.hpp"
#include "rays/ray_block.hpp"

namespace graze::rays {

template <class T>
struct BlockMesh {
  const TreeNode<T>* nodes;
  const PackedLeaf* leaves;
  const T* points;  ///< three numbers each
  const std::uint32_t* order;
  double extent;             ///< no corner is further from the frame's origin
  double center[3], radius;  ///< of a ball that holds all corners
  bool both_sides;
  bool any;  ///< whichever hit comes first will do
};

}  // namespace graze::rays

namespace graze {

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Sets `state`, the hits and the `pieces` that are hit, of `count` rays and of what fills up their lanes.
    template <class T> void block_at_mesh(rays::RayBlock& block, std::size_t count, const rays::BlockMesh<T>& mesh,
                                          std::uint32_t* pieces);)
// clang-format on

}  // namespace graze
