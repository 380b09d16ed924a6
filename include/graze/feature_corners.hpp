// The features of contact points by their corners: which vertex, edge or face of a shape a point of contact names.
//
// Guarantee: a point on A lies on the feature that its number names, wherever that has corners, or as near to an edge
// as a hundredth of the faces' shortest edge. The corners are those of the core: of a rounded box those of the box
// within, about which the rounding lies. Where a number may name several parts (of over 16,384, or of the edges of a
// shape with over 127 vertices), what is not certain has no corners.
#pragma once

#include "graze/feature.hpp"
#include "graze/shape.hpp"
#include "graze/small_vector.hpp"

namespace graze {

/// The corners of a feature, in the shape's frame: one of a vertex, two of an edge, those of a face counter-clockwise
/// seen from outside. None of what has no corners (caps of cylinders and cones, half-spaces, shapes of the user's own),
/// or is not certain. `piece` is that of the manifold, where a mesh, a height field or a compound touches. Costs the
/// number of edges.
template <class T>
GRAZE_API SmallVector<Vec3<T>, 8> feature_corners(const Shape<T>& shape, std::uint32_t piece, Feature feature);

}  // namespace graze
