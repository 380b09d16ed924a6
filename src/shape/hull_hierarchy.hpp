// Dobkin and Kirkpatrick's hierarchy: ever coarser hulls inside a hull, so that its furthest vertex in a direction is
// found in logarithmic time (Dobkin, Kirkpatrick 1990, "Determining the separation of preprocessed polyhedra").
#pragma once

#include "graze/shape/convex_hull.hpp"
#include "shape/hull_builder.hpp"

namespace graze {

/// Hulls of more vertices than this are climbed, smaller ones scanned.
inline constexpr std::size_t scan_limit = 64;

/// Builds the levels of a hull of dimension three whose vertices are `grid`; expected time n log n.
template <class T>
void build_hierarchy(HullData<T>& hull, std::span<const GridPoint> grid);

}  // namespace graze
