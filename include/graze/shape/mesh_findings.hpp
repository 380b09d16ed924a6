// What a mesh is like, before anything is asked of it: holes, seams that do not meet, triangles that are none.
//
// Guarantee: counts only, the same whatever the order of the triangles and of the points. Corners are told from each
// other by where they lie, so that a file that repeats them for each triangle is judged as the surface that it draws.
// What is found is no error: every mesh is answered by where its triangles lie (see `Mesh`).
#pragma once

#include "graze/shape/mesh.hpp"

namespace graze {

/// Counts of a mesh's triangles and edges. Each edge is in one of the five classes, a triangle may be in several.
struct MeshFindings {
  std::size_t triangles = 0;           ///< how many there are
  std::size_t repeated_triangles = 0;  ///< the corners of an earlier one in the same turn: they count once in answers
  std::size_t without_area = 0;        ///< triangles that are a line or a point
  std::size_t slivers = 0;             ///< triangles lower than 1/1000 of their longest side, those without area apart
  std::size_t repeated_points = 0;     ///< points that lie where an earlier one does

  std::size_t flat_edges = 0;       ///< between two triangles that lie level, up to 2.5e-5 rad
  std::size_t convex_edges = 0;     ///< ridges seen from outside, a fold by half a turn among them
  std::size_t concave_edges = 0;    ///< valleys
  std::size_t open_edges = 0;       ///< of one triangle only: rims, and seams that do not meet
  std::size_t irregular_edges = 0;  ///< of more than two triangles, or of two that run through it in one direction

  std::size_t t_junctions = 0;  ///< open edges on whose inside the corner of another triangle lies

  /// How many there are of all sorts.
  std::size_t edges() const { return flat_edges + convex_edges + concave_edges + open_edges + irregular_edges; }
};

/// What is found in a mesh. Triangles that repeat another, or have no area, are left out of the edges. Cost n log n in
/// the number of triangles, and the memory of some 60 bytes for each while it works.
template <class T>
GRAZE_API MeshFindings findings(const Mesh<T>& mesh);

}  // namespace graze
