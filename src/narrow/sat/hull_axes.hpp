// The separating-axis test of two small polyhedra, with lanes within the pair: bounds for all faces and edges together,
// then the vertices of one against each remaining face of the other.
//
// Guarantee: that of `separating_axes.hpp`, except that axes worse than the best face's may be missing; the same bits
// at every level of the instruction set. Lanes of float only rule out axes that cannot be the best, with all their
// rounding allowed for; the remaining ones are measured in double. For shapes in float, whose sizes a float holds.
#pragma once

#include "narrow/sat/separating_axis.hpp"
#include "shape/facet_rows.hpp"
#include "shape/furthest_vertex.hpp"

namespace graze {

/// A polyhedron with vertices, faces and edges in rows, as kernels take it.
struct FacetedHull {
  ScannedHull<float> corners;
  const FaceBlock* faces;
  const EdgeBlock* edge_blocks;
  const Plane<double>* planes;
  const HullEdge* edges;
  std::uint32_t face_count, edge_count;
  InnerBall ball;
};

/// The view of a hull with facets.
inline FacetedHull faceted(const HullData<float>& hull) {
  const FacetRows& rows = hull.facets;
  return {scanned(hull),
          rows.faces.data(),
          rows.edges.data(),
          rows.planes.data(),
          hull.edges.data(),
          static_cast<std::uint32_t>(rows.planes.size()),
          static_cast<std::uint32_t>(hull.edges.size()),
          {rows.middle, rows.inner_radius}};
}

/// A vertex of a polyhedron, in its own frame.
[[gnu::always_inline]] inline Vec3d corner(const FacetedHull& hull, std::uint32_t vertex) {
  return converted<double>(hull.corners.vertices[vertex]);
}

/// Two polyhedra, B rotated and moved into A's frame.
struct FacetedPair {
  const FacetedHull &a, &b;
  Mat3d rotation;
  Vec3d translation;
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Writes the best axes to `axes`, which must be new; or one that separates the polyhedra by more than `enough`.
    /// False where so many edges may have the best axis that EPA is faster, or sizes are beyond float.
    bool hull_axes(const FacetedPair& pair, double enough, SeparatingAxes& axes);)
// clang-format on

}  // namespace graze
