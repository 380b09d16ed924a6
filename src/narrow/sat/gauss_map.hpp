// Two edges on the Gauss map: where their arcs cross, the product of the edges is a facet of the Minkowski difference
// (Gregorius 2013, "The separating axis test between convex polyhedra", Game Developers Conference).
#pragma once

#include <cmath>
#include <limits>

#include "graze/vec3.hpp"

namespace graze {

/// Length of the product of two edges, relative to their lengths, below which they are parallel, since its direction is
/// mere rounding. The facet that is then missing from the difference is as thin.
inline constexpr double parallel_edges = 64 * std::numeric_limits<double>::epsilon();

/// An edge in the frame of the pair.
struct PlacedEdge {
  Vec3d left, right;  ///< normals of the two faces
  Vec3d along;        ///< from its first vertex to its second: left x right, but for its length
  Vec3d point;        ///< the first vertex
};

/// The axis of two edges if A's arc, from its left to its right face, crosses the arc of -B's: unit, out of A; else,
/// and for parallel edges, zero. Since an edge points along left x right, each of the four determinants of the crossing
/// test is a dot product of an edge and a face normal.
[[gnu::always_inline]] inline Vec3d crossing_normal(const PlacedEdge& a, const PlacedEdge& b) {
  const double left = dot(b.left, a.along), right = dot(b.right, a.along);
  if (!(left * right < 0)) return {};
  const double of_left = dot(a.left, b.along), of_right = dot(a.right, b.along);
  if (!(of_left * of_right < 0 && left * of_right < 0)) return {};
  const Vec3d n = cross(a.along, b.along);
  const double squared = length_squared(n), thinnest = parallel_edges * parallel_edges;
  if (!(squared > thinnest * length_squared(a.along) * length_squared(b.along))) return {};
  return n * ((dot(n, a.left + a.right) < 0 ? -1 : 1) / std::sqrt(squared));
}

}  // namespace graze
