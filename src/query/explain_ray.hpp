// What an explanation says of a ray.
//
// Guarantee: made after the answer and from it; nothing here is run, and nothing of it decides, when no explanation is
// asked for.
#pragma once

#include "graze/raycast.hpp"

namespace graze {

/// Writes what the ray meets of the shape: the spans of a closed form, the steps of an advancing ray, and of a
/// composite how much of its tree is visited and what the piece that is hit is like.
template <class T>
void explain_ray(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray, T length, BackFaces back,
                 const std::optional<RayHit<T>>& hit, Trace& trace);

}  // namespace graze
