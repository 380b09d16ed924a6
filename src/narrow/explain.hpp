// What an explanation says of separating axes, whichever routine gave the answer.
//
// Guarantee: nothing here is run, and nothing of it decides, when no explanation is asked for.
#pragma once

#include "graze/query.hpp"

namespace graze {

/// Writes the intervals of both shapes on every separating axis that the pair has: boxes' fifteen, other polyhedra's
/// faces and crossing edges, the six of a box and a segment. Nothing for other pairs.
template <class T>
void explain_axes(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace& trace);

/// Exchanges A and B in the steps of GJK and EPA.
void mirror(Trace& trace);

/// Writes the axis of the answer, "normal", for any pair.
template <class T>
void explain_normal(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                    const Vec3<T>& normal, Trace& trace);

}  // namespace graze
