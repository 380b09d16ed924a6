// The area that a convex shape of the plane sweeps over while it moves along a straight line, as a shape of its own.
//
// Guarantee: exact up to the rounding of its points; the hull of the shape at both ends, which is its Minkowski sum
// with the line's segment and for a convex shape all it sweeps (Cameron 1985, "A study of the clash detection problem
// in robotics"). What has straight sides stays a convex polygon, rounded or not, and has the closed forms of one; a
// circle becomes a rounded segment. Other shapes are known by their support function.
#pragma once

#include "graze/plane/shape.hpp"

namespace graze::plane {

/// The region that `shape`, standing at `pose`, sweeps while it moves by `motion` (in the world) without turning. The
/// result stands at the same `pose`. Throws `InvalidValue` for a shape that is not convex or not bounded, and a motion
/// that is not finite.
template <class T>
GRAZE_API Shape<T> swept(const Shape<T>& shape, const Pose2<T>& pose, const Vec2<T>& motion);

}  // namespace graze::plane
