// Rays beside each other against one polygon without rounding.
//
// Guarantee: a hit or a miss is reported only where it is sure, and then by the operations of `hit_edge`, ray by ray:
// the bits are those of a ray alone, at every level of the instruction set. Rays that begin inside or behind, or pass a
// vertex so closely that rounding decides, are left unknown, to be traced one by one.
#pragma once

#include <cstddef>
#include <cstdint>

#include "simd/dispatch.hpp"

namespace graze {

namespace plane {

/// Rays that a kernel takes at a time, as many as lanes of any level divide.
inline constexpr std::size_t most_rays = 64;
/// The most lanes of any level.
inline constexpr std::size_t most_lanes = 8;
/// The most vertices of a polygon that the kernel takes.
inline constexpr std::size_t most_ray_vertices = 32;

/// A polygon where it stands, counter-clockwise.
struct RayPolygon {
  double x = 0, y = 0, cosine = 1, sine = 0;  ///< its pose, of unit length
  std::size_t count = 0;
  double vertex_x[most_ray_vertices], vertex_y[most_ray_vertices];  ///< in its own frame
  double normal_x[most_ray_vertices], normal_y[most_ray_vertices];  ///< of the edge from each vertex on, outward
  double world_x[most_ray_vertices], world_y[most_ray_vertices];    ///< these normals in the world
};

/// Rays in the world, and their outcomes. A ray is unknown also where its direction is zero, or too long or
/// too short for its square.
struct RayBlock {
  enum State : std::uint8_t { unknown, missed, hit };

  double origin_x[most_rays], origin_y[most_rays], direction_x[most_rays], direction_y[most_rays];
  double t[most_rays], point_x[most_rays], point_y[most_rays], normal_x[most_rays], normal_y[most_rays];
  State state[most_rays];
};

/// Traces the first `count` rays; those up to a multiple of the lanes are read and written, too.
using RayBlockKernel = void (*)(const RayPolygon& polygon, RayBlock& rays, std::size_t count);

}  // namespace plane

GRAZE_DECLARE_KERNEL(plane::RayBlockKernel plane_ray_block();)

}  // namespace graze
