// The volume that a convex shape sweeps over while it moves along a straight line, as a shape of its own.
//
// Guarantee: exact; the hull of the shape at both ends, which is its Minkowski sum with the line's segment and for a
// convex shape the whole swept volume. Takes part in every query like any other shape; its support function is the
// shape's own and a sign (Cameron 1985, "A study of the clash detection problem in robotics", on sweeping as a test of
// collision).
#pragma once

#include "graze/shape.hpp"

namespace graze {

/// The volume that `shape`, standing at `pose`, sweeps while it moves by `motion` (in the world) without turning. The
/// result stands at the same `pose`. Throws `InvalidValue` for a shape that is not convex or not bounded, and a motion
/// that is not finite.
template <class T>
GRAZE_API Shape<T> swept(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& motion);

}  // namespace graze
