// Traversal of a height field's pyramid by rays: one alone, and several at a time.
//
// Guarantee: for one ray that of `bvh_traversal.hpp`, with cells in place of triangles: none is left out in which the
// exact ray crosses a triangle, or in which `crossing` finds one crossed or seen edge-on. For several that of
// `ray_stream.hpp`.
//
// Source: Tevs, Ihrke, Seidel 2008, "Maximum mipmaps for fast, accurate, and scalable dynamic height field rendering".
#pragma once

#include "rays/ray_block.hpp"
#include "shape/field_pyramid.hpp"

namespace graze {

/// A ray and a height field, as `BvhQuestion`.
template <class T>
struct FieldQuestion {
  const FieldPyramid<T>* field;
  double extent;
  double radius;
  double origin[3], direction[3];
  double begin, end;

  /// Called with a cell, by column and row; returns the length up to which the ray is still to be followed.
  double (*found)(void* owner, std::uint32_t column, std::uint32_t row);
  void* owner;
};

namespace rays {

/// A height field for many rays, as `BlockMesh`.
template <class T>
struct BlockField {
  const FieldPyramid<T>* field;
  double extent;
  double center[3], radius;
  bool both_sides;
  bool any;
};

}  // namespace rays

// clang-format off
GRAZE_DECLARE_KERNEL(
    template <class T> void traverse_field(const FieldQuestion<T>& question);
    /// Sets `state`, the hits and the `pieces` that are hit, of `count` rays and of those that fill up their lanes.
    template <class T> void block_at_field(rays::RayBlock& block, std::size_t count, const rays::BlockField<T>& field,
                                           std::uint32_t* pieces);)
// clang-format on

}  // namespace graze
