// The sides of a ray's line on which the vertices of a polygon lie, all of them beside each other.
//
// Guarantee: a side is given only where the distance from the line is beyond the rounding of floats; a level of the
// instruction set changes no answer.
#pragma once

#include <cstdint>

#include "graze/plane/vec2.hpp"
#include "simd/dispatch.hpp"

namespace graze {

namespace plane {

/// The most vertices that the kernel takes; as many can be read, whether the polygon has them or not.
inline constexpr std::uint32_t most_sided = 8;

/// Vertices on either side, as bits; one that is in neither lies too near to the line.
struct RaySides {
  std::uint32_t left, right;
};

/// The kernel. The ray's line are the points p with cross(along, p) = offset; vertices within
/// `slack` of it have no side.
using RaySidesKernel = RaySides (*)(const Vec2f* vertices, std::uint32_t count, float along_x, float along_y,
                                    float offset, float slack);

}  // namespace plane

GRAZE_DECLARE_KERNEL(plane::RaySidesKernel plane_ray_sides();)

}  // namespace graze
