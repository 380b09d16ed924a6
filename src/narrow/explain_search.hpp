// The steps of GJK and EPA on two convex shapes that are in the order of the list of shapes, in the world.
#pragma once

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "graze/trace.hpp"

namespace graze {

/// The steps of the distance: GJK, and EPA where the cores overlap.
template <class T>
void explain_distance_search(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                             Trace& trace);

/// The steps of the overlap test: GJK until the answer is known.
template <class T>
void explain_overlap_search(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                            Trace& trace);

}  // namespace graze
