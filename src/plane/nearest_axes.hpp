// Two polygons of few vertices by the axes of their edges.
//
// Guarantee: the answer of the walk around the Minkowski difference, bit for bit, but for edges so nearly in line with
// each other that rounding decides between them.
#pragma once

#include <optional>

#include "plane/nearest.hpp"

namespace graze::plane {

/// Writes the nearest points and returns whether they are known; they are not where there are more than `most_edges`
/// vertices, where no core has an inside or an edge has no length, and where rounding leaves no order of the edges.
template <class T>
bool nearest_by_axes(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size, Nearest& out);

/// Whether the signed distance is at most `limit` >= 0, where the heights of the edges decide it beyond their rounding.
template <class T>
std::optional<bool> within_by_axes(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size, double limit);

}  // namespace graze::plane
