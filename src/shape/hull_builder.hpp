// The convex hull of points, as a triangulated surface: quickhull with exact predicates.
//
// Guarantee: terminates for any finite points, with a closed, convex, consistently oriented surface. The points are
// rounded to an integer grid of 2^40 steps across the set, on which every orientation test is exact in 128-bit
// integers: rounding cannot fold the surface, whatever the input. A point lies outside by less than the grid's step.
// (Barber, Dobkin, Huhdanpaa 1996, "The quickhull algorithm for convex hulls".)
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "graze/vec3.hpp"

namespace graze {

/// A point of the grid.
using GridPoint = std::array<std::int64_t, 3>;

/// A hull as index triangles, counter-clockwise seen from outside; for flat sets instead the vertices in order around
/// the polygon (two: a segment, one: a point).
struct HullSurface {
  int dimension = 0;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< dimension 3
  std::vector<std::uint32_t> polygon;                   ///< dimension 2 and less
};

/// The points rounded to the grid, and its step in the units of the points.
struct Grid {
  std::vector<GridPoint> points;
  double step = 0;
};
Grid to_grid(std::span<const Vec3d> points);

/// The normal of a polygon of the grid, exact before it is rounded; of any length.
Vec3d grid_normal(std::span<const GridPoint> points, std::span<const std::uint32_t> loop);

HullSurface hull_surface(std::span<const GridPoint> points);

}  // namespace graze
