// The trace of a ray or a cast in the plane, made after the answer.
//
// Guarantee: no query computes differently for it; the spans are those of the ray in the parts of one convex piece, the
// steps come from a second run, which repeats the first.
#pragma once

#include "graze/plane/cast.hpp"
#include "plane/leaves.hpp"

namespace graze::plane {

/// A ray in the world with a unit direction, and how far along it the piece was hit.
struct TracedRay {
  Vec2d origin, direction;
  double length;
  std::optional<double> hit;
};

/// Adds the trace of a ray at one convex piece: spans where its parts are straight or round, else the steps of the
/// search.
template <class T>
void explain_ray(const Core<T>& core, const Pose2d& pose, double extent, double near, const TracedRay& ray,
                 Trace& trace);

/// The axes and the difference of a pair of pieces in place, as `explained` has them, without a search.
template <class T>
Trace explained_place(const LeafPair<T>& pair);

}  // namespace graze::plane
