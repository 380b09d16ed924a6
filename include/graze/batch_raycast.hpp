// Many rays at one shape: what `raycast` answers for each, several rays at a time.
//
// Guarantee: every hit has the bits that `raycast` gives for that ray alone, however the rays are ordered or divided
// into batches and at every level of the instruction set (environment variable GRAZE_ISA); and so every guarantee of
// `raycast.hpp`. Spheres, capsules, boxes, cylinders, cones, ellipsoids, half-spaces and triangles are met 2, 4 or 8
// rays at a time, as the machine can; at a mesh or height field 64 rays are under way at once, so that none waits for
// memory; of other shapes the ray's way into the shape's frame and the hit's way out of it are taken together. Nothing
// is allocated, thrown or printed. Safe from any thread.
#pragma once

#include <span>

#include "graze/raycast.hpp"

namespace graze {

/// The first hit of each ray with 0 <= t <= `length`, as `raycast` tells it. `hits` has at least as many places as
/// there are rays; rays beyond its end are left out. Rays that begin and go alike are best kept together. Cost on one
/// core with AVX-512, in float: 10 to 25 ns a ray at what is met several at a time, and at a mesh or height field half
/// of what one at a time takes.
template <class T>
GRAZE_API void raycast(const Shape<T>& shape, const Pose<T>& pose, std::span<const Ray<T>> rays,
                       std::span<std::optional<RayHit<T>>> hits, T length = std::numeric_limits<T>::infinity(),
                       BackFaces back = BackFaces::hit);

/// Whether each ray hits anything with 0 <= t <= `length`, as `raycast_any` tells it.
template <class T>
GRAZE_API void raycast_any(const Shape<T>& shape, const Pose<T>& pose, std::span<const Ray<T>> rays,
                           std::span<bool> hits, T length = std::numeric_limits<T>::infinity(),
                           BackFaces back = BackFaces::hit);

}  // namespace graze
