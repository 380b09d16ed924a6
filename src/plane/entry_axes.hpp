// The first contact of a polygon that moves along a line with another one, by the axes of their edges.
//
// Guarantee: the answer of the walk around the Minkowski difference, bit for bit.
#pragma once

#include "plane/difference.hpp"
#include "plane/outline_hit.hpp"

namespace graze::plane {

/// The edge of the difference A - B that a ray from the origin meets first, and where; `never` where it meets none.
struct DifferenceEntry {
  OutlineHit hit{};
  DifferenceEdge edge{};
};

/// Writes the entry along the unit vector `direction` and returns whether it is known: not for polygons that the
/// kernels do not take, nor where rounding has to decide whether the ray meets the difference. The origin lies outside.
template <class T>
bool entry_by_axes(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Vec2d& direction, double size,
                   DifferenceEntry& out);

}  // namespace graze::plane
