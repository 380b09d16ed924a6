// The separating-axis test of two small polyhedra, on lanes within the pair: bounds for all faces and edges together,
// then the vertices of one against each face of the other that is left.
//
// Guarantee: as `separating_axes.hpp`, but that axes worse than the best face's may be missing; the same bits at
// every level of the instruction set. Lanes of float only tell, with all their rounding allowed for, which axes cannot
// be the best; what is left is measured in double. For shapes in float, of which a float holds all sizes.
#pragma once

#include "narrow/sat/separating_axis.hpp"
#include "shape/facet_rows.hpp"
#include "shape/furthest_vertex.hpp"

namespace graze {

/// A polyhedron with vertices, faces and edges by rows, as kernels read it.
struct FacetedHull {
  ScannedHull<float> corners;
  const FaceBlock* faces;
  const EdgeBlock* edge_blocks;
  const Plane<double>* planes;
  const HullEdge* edges;
  std::uint32_t face_count, edge_count;
  InnerBall ball;
};

/// Of a hull that has facets.
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

/// A vertex of one, in its own frame.
[[gnu::always_inline]] inline Vec3d corner(const FacetedHull& hull, std::uint32_t vertex) {
  return converted<double>(hull.corners.vertices[vertex]);
}

/// Two of them, B turned and moved into A's frame.
struct FacetedPair {
  const FacetedHull &a, &b;
  Mat3d rotation;
  Vec3d translation;
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Writes to `axes`, which are new, the best ones; or one that separates them by more than `enough`. False where so
    /// many edges may have the best that whoever finds the depth otherwise is sooner done, or sizes are beyond float.
    bool hull_axes(const FacetedPair& pair, double enough, SeparatingAxes& axes);)
// clang-format on

}  // namespace graze
