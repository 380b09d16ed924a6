// Corners of features of the plane: the vertices of the vertex or edge of a shape that a contact point lies on.
//
// Guarantee: a point on A lies on its feature of A, except where two edges face each other: a point there names a
// vertex of each edge, the one at its end of the overlapping stretch, and lies on an edge from that vertex. So the two
// points of a manifold name both ends of both edges. The corners are those of the core: for a capsule the centres of
// its discs, for a rounded box the corners of the box within, around which the rounding lies.
#pragma once

#include "graze/feature.hpp"
#include "graze/plane/shape.hpp"
#include "graze/small_vector.hpp"

namespace graze::plane {

/// The corners of a feature, in the shape's frame: one for a vertex, two for an edge. Empty for features without
/// corners (circles, ellipses, half-planes, shapes of the user's own), and where a number may name several features (of
/// over 16,384 vertices, or of two segments of a chain in a compound). `piece` is the manifold's, for a polygon, a
/// chain or a compound. Costs the number of vertices of polygons and chains, else nothing.
template <class T>
GRAZE_API SmallVector<Vec2<T>, 2> feature_corners(const Shape<T>& shape, std::uint32_t piece, Feature feature);

}  // namespace graze::plane
