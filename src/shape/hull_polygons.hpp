// A hull's triangles merged to polygons, so that a box has six faces and not twelve.
#pragma once

#include "graze/shape/convex_hull.hpp"
#include "shape/hull_builder.hpp"

namespace graze {

/// Polygons as loops of point indices, counter-clockwise seen from outside.
using Loops = std::vector<std::vector<std::uint32_t>>;

/// Joins neighbouring triangles whose vertices lie within `tolerance` of the plane of the largest of them, and drops
/// the vertices that then lie within a face or an edge. Where that would leave no closed surface of polygons, returns
/// the triangles as they are.
Loops merged_loops(const std::vector<std::array<std::uint32_t, 3>>& triangles, std::span<const Vec3d> points,
                   double tolerance);

/// Writes vertices, planes, loops, edges and neighbours of a closed surface into a hull. Planes take their normals from
/// the grid, on which the surface is convex: those of faces much smaller than the hull would else cut off its far end.
template <class T>
void fill_faces(HullData<T>& hull, const Loops& loops, std::span<const Vec3<T>> points,
                std::span<const GridPoint> grid);

}  // namespace graze
