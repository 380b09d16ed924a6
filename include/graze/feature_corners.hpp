// Corners of features: the vertices of the vertex, edge or face of a shape that a contact point lies on.
//
// Guarantee: a point on A lies on the feature of its number, wherever that has corners, or as near to an edge as a
// hundredth of the faces' shortest edge. The corners are those of the core: for a rounded box those of the box within,
// around which the rounding lies. Where a number may name several features (of over 16,384, or of the edges of a shape
// with over 127 vertices), an ambiguous one has no corners.
#pragma once

#include "graze/feature.hpp"
#include "graze/shape.hpp"
#include "graze/small_vector.hpp"

namespace graze {

/// The corners of a feature, in the shape's frame: one for a vertex, two for an edge, those of a face counter-clockwise
/// seen from outside. Empty for features without corners (caps of cylinders and cones, half-spaces, shapes of the
/// user's own), for ambiguous ones, and for a feature of no kind, as a point has whose number another piece's point has
/// too. `piece` is the manifold's, for a mesh, a height field or a compound. Costs the number of edges.
template <class T>
GRAZE_API SmallVector<Vec3<T>, 8> feature_corners(const Shape<T>& shape, std::uint32_t piece, Feature feature);

}  // namespace graze
