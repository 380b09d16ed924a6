// The faces of two convex shapes from which contacts were clipped, and the cuts, in the world.
#pragma once

#include "graze/contact.hpp"
#include "graze/shape.hpp"
#include "graze/trace.hpp"

namespace graze {

/// Writes to `trace` the faces from which the contact points of `answer` were clipped, in the world, and the cuts of
/// the clipping; nothing where the points do not come from faces: closest points, or a body on a half-space.
template <class T>
void explain_faces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                   const Manifold<T>& answer, Trace& trace);

}  // namespace graze
