// The nearest points of an ellipse and a point.
//
// Guarantee: right within some roundings of the size, for any ratio of the radii, inside and outside, at the centre and
// on an axis too, where several points of the ellipse may be nearest and one of them is given.
#pragma once

#include "plane/nearest.hpp"

namespace graze::plane {

/// The nearest points of an ellipse (A) and a core that is a point (B).
template <class T>
Nearest nearest_ellipse_point(const Core<T>& ellipse, const Core<T>& point, const Pose2d& b_in_a);

}  // namespace graze::plane
