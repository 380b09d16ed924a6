// A convex hull's support query step by step: the layers of its hierarchy, and which vertices were looked at in each.
//
// Guarantee: found after the answer by the descent that answers, with an observer; asking changes no bit of it, and
// the vertex is that of `ConvexHull::support_vertex`.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "graze/shape/convex_hull.hpp"

namespace graze {

/// One layer of a hull: the hull of some of its vertices, or all of it.
struct HullLayer {
  std::vector<std::uint32_t> vertices;              ///< numbers of the hull's vertices
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< each once, by numbers of the hull's vertices
};

/// One layer of a descent.
struct SupportLayer {
  std::size_t vertices;  ///< how many the layer has
  /// The hull's vertices whose product with the direction was taken, in that order: the vertex that the coarser layer
  /// found, then neighbours of the best so far. A vertex stands there as often as it was looked at.
  std::vector<std::uint32_t> looked_at;
  std::vector<double> along;  ///< of each of these the product with the direction
  std::uint32_t winner;       ///< the furthest of the layer, by the number of the hull's vertex
};

/// The steps of one support query.
struct SupportTrace {
  std::vector<SupportLayer> layers;  ///< the coarsest first, the hull itself last; of a hull that is scanned it alone
  bool scanned = false;              ///< every vertex was looked at: hulls of up to 64 vertices, and flat ones
  std::uint32_t vertex = 0;          ///< the answer
  std::size_t products = 0;          ///< how many scalar products of all layers together
};

/// The layers of Dobkin and Kirkpatrick's hierarchy, the coarsest first and the hull itself last (Dobkin, Kirkpatrick
/// 1990, "Determining the separation of preprocessed polyhedra"); each vertex of a layer is one of the next. Of several
/// layers that the construction makes one is kept, at most a quarter of the next but for the coarsest. A hull that is
/// scanned has one layer. Linear in the hull's size.
template <class T>
GRAZE_API std::vector<HullLayer> hull_layers(const ConvexHull<T>& hull);

/// The support query along `direction`, by its layers. Logarithmic, as the query, for a hull with layers; a scan's
/// second look at vertices that float does not tell apart is not counted.
template <class T>
GRAZE_API SupportTrace explain_support(const ConvexHull<T>& hull, const Vec3<T>& direction);

}  // namespace graze
