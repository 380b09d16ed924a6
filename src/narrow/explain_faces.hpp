// The faces that contacts of two convex shapes stand on, and how they were laid over each other, in the world.
#pragma once

#include "graze/contact.hpp"
#include "graze/shape.hpp"
#include "graze/trace.hpp"

namespace graze {

/// Nothing where the points are those of no faces: closest
/// points, or a body on a half-space.
template <class T>
void explain_faces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                   const Manifold<T>& answer, Trace& trace);

}  // namespace graze
