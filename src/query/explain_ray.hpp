// Explanation of a ray cast.
//
// Guarantee: made from the answer and after it; nothing here runs without a request for an explanation, nor has an
// influence on an answer.
#pragma once

#include "graze/raycast.hpp"

namespace graze {

/// Writes the steps of a ray cast: the spans of a closed form, the steps of an advancing ray, and for a composite the
/// visited part of its tree and the explanation of the piece that is hit.
template <class T>
void explain_ray(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray, T length, BackFaces back,
                 const std::optional<RayHit<T>>& hit, Trace& trace);

}  // namespace graze
