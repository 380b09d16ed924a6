// The properties of shapes of the plane that pictures use.
//
// Guarantee: any shape.
#pragma once

#include "graze/aabb.hpp"
#include "graze/plane/shape.hpp"

namespace graze::io {

/// The bounds at z = 0; infinite where a half-plane's are.
Aabbd plane_bounds(const plane::Shaped& shape, const plane::Pose2d& pose);

/// Whether all sides are straight and all corners sharp.
bool has_straight_sides(const plane::Shaped& shape);

}  // namespace graze::io
