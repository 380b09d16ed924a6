// What the triangles of a mesh have to do with each other.
#pragma once

#include <span>

#include "graze/shape/mesh.hpp"

namespace graze {

/// Whether the triangles bound a solid: every edge is run through once in each direction, by place in the list of points.
/// Triangles that have a corner twice are passed over. Cost n log n.
bool bounds_solid(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t points);

/// The triangles, by number, that do not repeat an earlier one: the same corners in the same turn, or, without area for
/// two corners at one place, the same points. What repeats changes no answer, and piled up in thousands costs the square
/// of their number. Cost n.
template <class T>
std::vector<std::uint32_t> different_triangles(std::span<const Vec3<T>> points,
                                               std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace graze
