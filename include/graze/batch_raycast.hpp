// Batched ray casts: many rays at one shape, several at a time.
//
// Guarantee: every hit has the bits that `raycast` gives for that ray alone, however the rays are ordered or divided
// into batches and at every level of the instruction set (environment variable GRAZE_ISA); and so every guarantee of
// `raycast.hpp`. Spheres, capsules, boxes, cylinders, cones, ellipsoids, half-spaces and triangles are intersected with
// 2, 4 or 8 rays at a time, as the machine can; at a mesh or height field 64 rays are in flight at once, so that memory
// latency is hidden; at other shapes only the transforms into and out of the shape's frame run several rays at a time.
// Nothing is allocated, thrown or printed. Safe from any thread.
#pragma once

#include <span>

#include "graze/raycast.hpp"

namespace graze {

/// Writes the first hit of each ray with 0 <= t <= `length`, as `raycast` defines it, to the entry of `hits` at the
/// ray's index. Rays beyond the end of `hits` are left out. Coherent rays (similar origins and directions) are best
/// kept together. Cost on one core with AVX-512, in float: 10 to 25 ns a ray at shapes that have lanes, and at a mesh
/// or height field half of what single rays take.
template <class T>
GRAZE_API void raycast(const Shape<T>& shape, const Pose<T>& pose, std::span<const Ray<T>> rays,
                       std::span<std::optional<RayHit<T>>> hits, T length = std::numeric_limits<T>::infinity(),
                       BackFaces back = BackFaces::hit);

/// Writes to `hits`, for each ray, whether anything is hit with 0 <= t <= `length`, as `raycast_any` defines it.
template <class T>
GRAZE_API void raycast_any(const Shape<T>& shape, const Pose<T>& pose, std::span<const Ray<T>> rays,
                           std::span<bool> hits, T length = std::numeric_limits<T>::infinity(),
                           BackFaces back = BackFaces::hit);

}  // namespace graze
