// The features of contact points of the plane by their corners: which vertex or edge of a shape a point names.
//
// Guarantee: a point on A lies on what it names of A; where two edges face each other it names a vertex of each, that
// at its end of the stretch which they share, and lies on an edge from there. So the two points of a manifold name both
// ends of both edges. The corners are those of the core: of a capsule the centres of its discs, of a rounded box the
// corners of the box within, about which the rounding lies.
#pragma once

#include "graze/feature.hpp"
#include "graze/plane/shape.hpp"
#include "graze/small_vector.hpp"

namespace graze::plane {

/// The corners of a feature, in the shape's frame: one of a vertex, two of an edge. None of what has no corners
/// (circles, ellipses, half-planes, shapes of the user's own), and none where a number may name several (of over 16,384
/// vertices, or of two segments of a chain in a compound). `piece` is that of the manifold, where a polygon, a chain or
/// a compound touches. Costs the number of vertices of polygons and chains, else nothing.
template <class T>
GRAZE_API SmallVector<Vec2<T>, 2> feature_corners(const Shape<T>& shape, std::uint32_t piece, Feature feature);

}  // namespace graze::plane
