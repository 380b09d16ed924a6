// The separating axes of two polygons of few vertices: the normals of their edges, all of them beside each other.
//
// Guarantee: the edges nearest to the origin are found up to a slack that the caller gives, and no number that the
// kernel rounds enters an answer: the caller computes an edge's distance anew from its vertices. So a level of the
// instruction set changes no bit.
#pragma once

#include <cstdint>

#include "graze/plane/pose2.hpp"
#include "simd/dispatch.hpp"

namespace graze {

namespace plane {

/// Polygons with more vertices are answered by the walk around their Minkowski difference, whose cost grows with the
/// sum of the vertices and not with their product.
inline constexpr std::uint32_t most_edges = 16;

/// The number of vertices of a polygon that can be read, whether it has as many or not.
inline constexpr std::uint32_t readable_vertices = 8;

/// One polygon of the two: its vertices in its own frame, counter-clockwise.
template <class T>
struct AxesPolygon {
  const Vec2<T>* vertices;
  std::uint32_t count;
};

/// Edges of the Minkowski difference A - B that lie nearest to the origin, seen from inside; those that separate A and
/// B count as nearer than all that do not.
struct EdgeAxes {
  bool regular = false;                    ///< whether every edge has a length that floats can hold
  float height = 0;                        ///< of the origin below the nearest edge
  std::uint32_t edges_a = 0, edges_b = 0;  ///< nearest edges of A and of B, as bits
  /// The vertex of B that lies deepest below each edge of A, and the other way round; one of several that are
  /// equally deep up to rounding.
  float deepest_b[most_edges], deepest_a[most_edges];
};

/// The kernel for vertices in T. `slack`: the largest height by which an edge may lie further off than the nearest one.
template <class T>
using EdgeAxesKernel = void (*)(const AxesPolygon<T>& a, const AxesPolygon<T>& b, const Pose2d& b_in_a, double slack,
                                EdgeAxes& out);

/// The edges of the Minkowski difference A - B, moved outward by a radius, through whose lines a ray from the origin,
/// which lies outside, may enter the area that these lines bound (Cyrus and Beck 1978, "Generalized two- and
/// three-dimensional clipping"): of the edges that face the ray the one that is met last, if all that do not are met
/// later.
struct EdgeEntries {
  bool regular = false;  ///< whether every edge has a length that floats can hold, and none lies nearly along the ray
  bool missed = false;   ///< whether the ray surely misses the difference
  std::uint32_t edges_a = 0, edges_b = 0;              ///< edges that may be the one, as bits
  float deepest_b[most_edges], deepest_a[most_edges];  ///< deepest vertices, as in `EdgeAxes`
};

/// The kernel of these entries, for vertices in T and a ray along the unit vector `direction`.
template <class T>
using EdgeEntriesKernel = void (*)(const AxesPolygon<T>& a, const AxesPolygon<T>& b, const Pose2d& b_in_a,
                                   double radius, const Vec2d& direction, double slack, EdgeEntries& out);

/// The kernels for both scalars.
struct EdgeAxesKernels {
  EdgeAxesKernel<float> of_float;
  EdgeAxesKernel<double> of_double;
  EdgeEntriesKernel<float> entries_of_float;
  EdgeEntriesKernel<double> entries_of_double;
};

}  // namespace plane

GRAZE_DECLARE_KERNEL(const plane::EdgeAxesKernels& plane_edge_axes();)

}  // namespace graze
