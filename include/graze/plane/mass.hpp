// Area, centre and inertia of shapes of the plane, from which a body's mass follows.
//
// Guarantee: exact but for rounding for polygons, boxes, circles, ellipses and capsules, tapered or not, rounded by any
// radius where the formula has one (rounded ellipses and users' shapes are sampled, right within 1e-5). Solid polygons
// count once wherever their pieces meet; children of a compound that overlap count twice, as in space, and so do the
// roundings of chains and of reflex corners where they overlap. Shapes without area (segments, chains, points, without
// a rounding) have none here either, and neither does a half-plane.
#pragma once

#include "graze/plane/shape.hpp"

namespace graze::plane {

/// The mass properties of a body of density one.
template <class T>
struct MassProperties {
  T area{};          ///< the area
  Vec2<T> center{};  ///< centre of the area, in the shape's own frame
  T inertia{};       ///< the integral of the squared distance from the centre over the area
};

/// The mass properties of a shape. The inertia of a body of `mass` about its centre is mass * inertia / area. Cost:
/// linear in the vertices.
template <class T>
GRAZE_API MassProperties<T> mass_properties(const Shape<T>& shape);

}  // namespace graze::plane
