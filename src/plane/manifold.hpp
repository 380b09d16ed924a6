// The points of contact of two cores along a normal.
//
// Guarantee: at most two points, each with b - a = distance * normal. Both shapes are treated alike: there is no
// reference edge, so that swapping them mirrors the points and their features and changes nothing else.
#pragma once

#include "graze/plane/query.hpp"
#include "plane/nearest.hpp"

namespace graze::plane {

/// The points of two cores that are up to `margin` apart, rounding radii taken into account, in A's frame. `found`: the
/// nearest points of the cores.
template <class T>
Manifold<double> manifold(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Nearest& found,
                          double margin);

/// The points of two polygons whose edges face each other along the normal of `found`; none where no edges do, or only
/// beside each other.
template <class T>
Manifold<double> facing_manifold(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Nearest& found,
                                 double margin);

}  // namespace graze::plane
