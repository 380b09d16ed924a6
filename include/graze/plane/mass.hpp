// How the area of a shape of the plane is spread: what a body's mass and inertia come from.
//
// Guarantee: exact but for rounding of polygons, boxes, circles, ellipses and capsules, tapered or not, rounded by any
// radius where the formula has one (rounded ellipses and users' shapes are sampled, right within 1e-5). Solid polygons
// count once wherever their pieces meet; children of a compound that overlap count twice, as in space, and so do the
// roundings of chains and of reflex corners where they overlap. What has no
// area (segments, chains, points, without a rounding) has none here either, and neither does a half-plane.
#pragma once

#include "graze/plane/shape.hpp"

namespace graze::plane {

/// Of a body of density one.
template <class T>
struct MassProperties {
  T area{};          ///< the area
  Vec2<T> center{};  ///< of area, in the shape's own frame
  T inertia{};       ///< the integral of the squared distance from the centre over the area
};

/// Of a body of `mass`, the inertia about its centre is mass * inertia / area. Cost: linear in the vertices.
template <class T>
GRAZE_API MassProperties<T> mass_properties(const Shape<T>& shape);

}  // namespace graze::plane
