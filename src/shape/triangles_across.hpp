// The neighbours of a triangle of a mesh or height field.
#pragma once

#include <array>
#include <cstdint>

namespace graze {

/// The number in place of the triangle beyond an edge that has no other.
inline constexpr std::uint32_t no_triangle = 0xffffffff;

/// The triangles that share the edges of one, by number: first that of the edge from its first corner to the second.
using TrianglesAcross = std::array<std::uint32_t, 3>;

}  // namespace graze
