// The first contact of a polygon that moves along a line with another one, rounded or not, by the axes of their edges.
//
// Guarantee: the answer of the walk around the Minkowski difference, bit for bit.
#pragma once

#include "plane/difference.hpp"
#include "plane/outline_hit.hpp"

namespace graze::plane {

/// The first hits of a ray from the origin on the difference A - B, rounded by the radii of both: on the moved edges,
/// and on the discs about the vertices.
struct DifferenceHit {
  OutlineHit on_edge{}, on_disc{};
  DifferenceEdge edge{};       ///< of `on_edge`
  std::uint32_t vertex_a = 0;  ///< of `on_disc`
};

/// Writes the first hit along the unit vector `direction`, one of the two, and returns whether it is known: not for
/// polygons that the kernels do not take, nor where rounding has to decide which part of the outline is met, or whether
/// one is. The origin lies outside.
template <class T>
bool entry_by_axes(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Vec2d& direction, double size,
                   DifferenceHit& out);

}  // namespace graze::plane
