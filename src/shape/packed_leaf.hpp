// A leaf's triangles as a ray reads them first: their corners side by side in sixteen bits a coordinate, enough to rule
// out most triangles that the ray misses. It lies on two lines of memory.
//
// Guarantee: no coordinate is further from the corner's than `off` parts, of which a step of the leaf's node has
// `parts` (a node's frame has 255 steps, hence 65535 parts), plus the rounding of whatever computes it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace graze {

struct alignas(8) PackedLeaf {
  static constexpr std::size_t lanes = 4;
  static constexpr int parts = 257;
  static constexpr double off = 0.51;
  std::uint16_t at[3][3][lanes];  ///< axis, corner, triangle; lanes without a triangle repeat one
};

}  // namespace graze
