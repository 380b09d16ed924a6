// A simple polygon cut into convex pieces.
//
// Guarantee: exact decisions on the points as they are given. Pieces share the vertices of the outline and add none;
// there are at most four times as many as need be (Hertel and Mehlhorn 1983, "Fast triangulation of simple polygons").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graze/plane/vec2.hpp"

namespace graze::plane {

/// The first vertex of an edge that meets another edge of the closed outline elsewhere than at the vertex that two in a
/// row share, or -1. Vertices on the way of a straight line are allowed. Cost n log n plus the pairs whose extents
/// along X overlap.
std::int64_t first_crossing(std::span<const Vec2d> outline);

/// Convex pieces, each a list of vertices counter-clockwise. `outline` is simple and runs counter-clockwise, without
/// vertices on straight lines.
std::vector<std::vector<std::uint32_t>> convex_pieces(std::span<const Vec2d> outline);

}  // namespace graze::plane
