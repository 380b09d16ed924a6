// Polygons cut into triangles.
//
// Guarantee: n corners give n - 2 triangles that turn as the polygon does, whatever the points; they cover a simple
// polygon exactly, convex or not. Where it crosses itself or has no area they are a guess.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graze/shape/mesh.hpp"

namespace graze {

/// Appends the triangles of the polygon over `loop`, indices into `points`. Time n^2.
void cut_polygon(std::span<const Vec3d> points, std::span<const std::uint32_t> loop,
                 std::vector<Mesh<double>::Index>& triangles);

}  // namespace graze
