// Shapes of the plane as polygons, for pictures.
//
// Guarantee: any shape; points lie on its outline, at z = 0. What is straight is exact; what is curved is sampled
// finely enough for the eye.
#pragma once

#include "graze/io/tessellate.hpp"
#include "graze/plane/shape.hpp"

namespace graze::io {

/// A half-plane is drawn as far as `half_plane_size` about the foot of `center`, and half as deep.
Polygons plane_polygons(const plane::Shaped& shape, const plane::Pose2d& pose, const Vec3d& center,
                        double half_plane_size);

/// The bounds at z = 0; infinite where a half-plane's are.
Aabbd plane_bounds(const plane::Shaped& shape, const plane::Pose2d& pose);

/// Whether all sides are straight and all corners sharp.
bool has_straight_sides(const plane::Shaped& shape);

}  // namespace graze::io
