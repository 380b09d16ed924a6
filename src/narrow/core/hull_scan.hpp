// The scans of two small hulls on the lanes of a level, for kernels that need support points of their difference.
//
// Guarantee: that of `hull_support.hpp`.
#pragma once

#include "narrow/core/hull_support.hpp"
#include "shape/vertex_scan.hpp"

namespace graze::GRAZE_ISA {

/// A vertex; a float's block, which the scan has just read, holds the vertex itself.
template <class T>
[[gnu::always_inline]] inline Vec3d vertex(const ScannedHull<T>& hull, std::uint32_t i) {
  if constexpr (sizeof(T) == sizeof(float)) {
    const VertexBlock& block = hull.blocks[i / VertexBlock::size];
    const std::size_t k = i % VertexBlock::size;
    return {static_cast<double>(block.x[k]), static_cast<double>(block.y[k]), static_cast<double>(block.z[k])};
  } else {
    return hull.vertices[i];
  }
}

/// The vertex of B least far along a direction, among several candidates; out of line, since this is rare.
template <class T>
[[gnu::noinline]] std::uint32_t least_among(const HullPair<T>& hulls, VertexBits among, const Vec3d& direction) {
  return furthest_among(hulls.b, among, transposed_times(hulls.rotation, -direction));
}

template <class T>
[[gnu::always_inline]] inline SupportPoint support_of(const HullPair<T>& hulls, const PlacedVertices& placed,
                                                      const Vec3d& direction) {
  const std::uint32_t i = scan(hulls.a, direction);
  const ScannedHull<T> turned{placed.turned, hulls.b.vertices, hulls.b.count, hulls.b.extent};
  const VertexBits candidates = highest(turned, -direction);
  const std::uint32_t j = several(candidates) ? least_among(hulls, candidates, direction) : first_of(candidates);
  const Vec3d a = vertex(hulls.a, i), b{placed.x[j], placed.y[j], placed.z[j]};
  return {a, b, b - a};
}

}  // namespace graze::GRAZE_ISA
