// Diagnosis of a mesh: holes, seams that do not meet, degenerate triangles.
//
// Guarantee: counts only, the same whatever the order of the triangles and of the points. Corners are identified by
// their positions, so that a file that repeats them for each triangle is judged as the surface that it draws. Findings
// are no errors: every mesh is answered by the positions of its triangles (see `Mesh`).
#pragma once

#include "graze/shape/mesh.hpp"

namespace graze {

/// Counts of a mesh's triangles and edges. Each edge is in one of the five classes, a triangle may be in several.
struct MeshFindings {
  std::size_t triangles = 0;           ///< number of triangles
  std::size_t repeated_triangles = 0;  ///< triangles with the corners of an earlier one in the same turn, which count
                                       ///< once in answers
  std::size_t without_area = 0;        ///< triangles that are a line or a point
  std::size_t slivers = 0;             ///< triangles lower than 1/1000 of their longest side, without those of zero
                                       ///< area
  std::size_t repeated_points = 0;     ///< points at the position of an earlier one

  std::size_t flat_edges = 0;       ///< edges between two triangles that lie level, up to 2.5e-5 rad
  std::size_t convex_edges = 0;     ///< ridges seen from outside, folds by half a turn included
  std::size_t concave_edges = 0;    ///< valleys
  std::size_t open_edges = 0;       ///< edges of one triangle only: rims, and seams that do not meet
  std::size_t irregular_edges = 0;  ///< edges of more than two triangles, or of two that run through it in one
                                    ///< direction

  std::size_t t_junctions = 0;  ///< open edges with the corner of another triangle in their interior

  /// The number of edges of all classes.
  std::size_t edges() const { return flat_edges + convex_edges + concave_edges + open_edges + irregular_edges; }
};

/// The findings for a mesh. Triangles that repeat another, or have no area, are left out of the edges. Cost n log n in
/// the number of triangles, and the memory of some 60 bytes for each meanwhile.
template <class T>
GRAZE_API MeshFindings findings(const Mesh<T>& mesh);

}  // namespace graze
