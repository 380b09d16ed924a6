// Trace of a convex hull's support query: the layers of its hierarchy, and the vertices visited in each.
//
// Guarantee: found after the answer by the same descent, with an observer; no bit of the answer changes by it, and the
// vertex is that of `ConvexHull::support_vertex`.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "graze/shape/convex_hull.hpp"

namespace graze {

/// One layer of a hull: the hull of some of its vertices, or all of it.
struct HullLayer {
  std::vector<std::uint32_t> vertices;              ///< indices of the hull's vertices
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< each edge once, by indices of the hull's vertices
};

/// One layer of a descent.
struct SupportLayer {
  std::size_t vertices;  ///< number of the layer's vertices
  /// The hull's vertices whose product with the direction was taken, in that order: the result of the coarser layer,
  /// then neighbours of the best so far. A vertex appears as often as it was visited.
  std::vector<std::uint32_t> looked_at;
  std::vector<double> along;  ///< product of each of these with the direction
  std::uint32_t winner;       ///< furthest vertex of the layer, by its index in the hull
};

/// The steps of one support query.
struct SupportTrace {
  std::vector<SupportLayer> layers;  ///< the coarsest first, the hull itself last; the hull alone if it is scanned
  bool scanned = false;              ///< whether every vertex was visited: hulls of up to 64 vertices, and flat ones
  std::uint32_t vertex = 0;          ///< the answer
  std::size_t products = 0;          ///< number of scalar products in all layers
};

/// The layers of Dobkin and Kirkpatrick's hierarchy, the coarsest first and the hull itself last (Dobkin, Kirkpatrick
/// 1990, "Determining the separation of preprocessed polyhedra"); each vertex of a layer is one of the next. Only some
/// of the construction's layers are kept: each has at most a quarter of the next one's vertices, except for the
/// coarsest. A hull that is scanned has one layer. Linear in the hull's size.
template <class T>
GRAZE_API std::vector<HullLayer> hull_layers(const ConvexHull<T>& hull);

/// The support query along `direction`, by its layers. Logarithmic, as the query, for a hull with layers; the second
/// pass of a scan over vertices that float does not distinguish is not counted.
template <class T>
GRAZE_API SupportTrace explain_support(const ConvexHull<T>& hull, const Vec3<T>& direction);

}  // namespace graze
