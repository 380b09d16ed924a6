// The vertex of a small hull that lies furthest in a direction: a scan on lanes.
//
// Guarantee: the vertex that a scan one after the other in the direction's own scalar finds, of equals the first. Lanes
// of float leave the vertices that it may be within rounding, most often one; only those are looked at again.
#pragma once

#include "graze/shape/convex_hull.hpp"
#include "shape/hull_hierarchy.hpp"
#include "simd/dispatch.hpp"

namespace graze {

/// Bit i of vertex i.
using VertexBits = std::uint64_t;
static_assert(scan_limit <= 64, "a bit a vertex");

/// The number of blocks in which a hull of so many vertices is scanned: one, two or four, for each of which there is
/// code.
constexpr std::size_t scan_blocks(std::size_t vertices) {
  return vertices <= VertexBlock::size ? 1 : vertices <= 2 * VertexBlock::size ? 2 : 4;
}
inline constexpr std::size_t most_scan_blocks = scan_blocks(scan_limit);
static_assert(most_scan_blocks * VertexBlock::size >= scan_limit);

/// Fills a block with so many vertices, those of a hull from number `first` on.
template <class T>
void fill_block(const Vec3<T>* vertices, std::size_t count, VertexBlock& block, std::size_t first = 0) {
  for (std::size_t k = 0; k < VertexBlock::size; ++k) {
    const Vec3<float> v = converted<float>(vertices[first + k < count ? first + k : 0]);
    block.x[k] = v.x, block.y[k] = v.y, block.z[k] = v.z;
  }
}
/// Fills the blocks of a hull that is to be scanned.
template <class T>
void fill_blocks(HullData<T>& hull) {
  const std::size_t count = hull.vertices.size();
  if (count > scan_limit) return;
  for (std::size_t first = 0; first < scan_blocks(count) * VertexBlock::size; first += VertexBlock::size)
    fill_block(hull.vertices.data(), count, hull.blocks.emplace_back(), first);
}

/// A hull with blocks, as kernels read it.
template <class T>
struct ScannedHull {
  const VertexBlock* blocks;
  const Vec3<T>* vertices;
  std::uint32_t count;
  float extent;
};

template <class T>
ScannedHull<T> scanned(const HullData<T>& hull) {
  return {hull.blocks.data(), hull.vertices.data(), static_cast<std::uint32_t>(hull.vertices.size()),
          static_cast<float>(hull.extent)};
}

struct HighestVertices {
  std::uint32_t top;  ///< a number
  VertexBits bits;
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// The number of the vertex furthest along a direction.
    template <class T, class S> std::uint32_t furthest_vertex(const ScannedHull<T>& hull, const Vec3<S>& direction);
    /// The vertex furthest along a direction, and those that lie lower by no more than `below`.
    HighestVertices highest_vertices(const ScannedHull<float>& hull, const Vec3<float>& direction, float below);)
// clang-format on

}  // namespace graze
