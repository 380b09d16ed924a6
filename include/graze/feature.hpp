// The features of contact points by their corners: which vertex, edge or face of a shape a point of contact names.
//
// Guarantee: a point on A lies on the feature that its number names, wherever that has corners, or as near to an edge
// as a hundredth of the faces' shortest edge. The corners are those of the core: of a rounded box those of the box
// within, about which the rounding lies.
//
// A number has 14 bits for a part and so names one part alone in shapes of up to 16,384 of them, and an edge in shapes
// of up to 127 vertices; in larger ones what is not certain has no corners.
#pragma once

#include <cstdint>

#include "graze/shape.hpp"
#include "graze/small_vector.hpp"

namespace graze {

/// The kind of part that a shape touches with.
enum class FeatureKind : std::uint8_t { none, vertex, edge, face };

/// The part of one shape, half of the `feature` of a contact point.
struct Feature {
  FeatureKind kind = FeatureKind::none;  ///< none of what is smooth and has no parts
  std::uint32_t number = 0;              ///< of the vertex or the face; of an edge in a form of its own
};

/// The part of A that a point of contact lies on.
constexpr Feature feature_of_a(std::uint32_t feature) {
  return {static_cast<FeatureKind>(feature >> 30), feature >> 16 & 0x3fff};
}
/// The part of B that a point of contact lies on.
constexpr Feature feature_of_b(std::uint32_t feature) { return feature_of_a(feature << 16); }

/// The corners of a feature, in the shape's frame: one of a vertex, two of an edge, those of a face counter-clockwise
/// seen from outside. None of what has no corners (caps of cylinders and cones, half-spaces, shapes of the user's own),
/// or is not certain. `piece` is that of the manifold, where a mesh, a height field or a compound touches. Costs the
/// number of edges.
template <class T>
GRAZE_API SmallVector<Vec3<T>, 8> feature_corners(const Shape<T>& shape, std::uint32_t piece, Feature feature);

}  // namespace graze
