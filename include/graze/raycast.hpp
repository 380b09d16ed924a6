// Ray casts: the first hit of a ray, whether there is any, and all entries into pieces.
//
// Guarantee: every shape answers. The point of a hit lies on the surface within `tolerance<T>` (see `result.hpp`) times
// the shape's size, plus the rounding of the ray itself: `T`'s epsilon times the distance of its origin. Everything is
// computed in double and in the shape's own frame, so a scene far from the origin of the world loses nothing. A closed
// mesh is watertight: no ray slips between triangles that share an edge or a vertex (Woop, Benthin, Wald 2013,
// "Watertight ray/triangle intersection"). Nothing throws or prints; only `raycast_all` allocates. Safe from any
// thread.
//
// Solids, solid meshes (`Mesh::solid`) among them, are hit where the ray enters them, and at t = 0 by a ray that begins
// inside; other closed meshes where it meets a triangle. Shapes without thickness (segments, points) are met within the
// ray's rounding. A ray hits nothing if its direction is zero, one of its numbers is not finite, or its origin has a
// coordinate that cannot be squared (beyond 1e37 in float, 1e150 in double); nor does any ray further along than that.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "graze/lines.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "graze/trace.hpp"

namespace graze {

/// The first hit with 0 <= t <= `length`; nothing on a miss. `ray.direction` need not be unit; `length` is in the
/// caller's unit of length. A ray that starts in a solid (distance <= 0) hits at t = 0.
/// Cost: constant for spheres, capsules, boxes, cylinders, cones, ellipsoids and triangles; the number of faces for
/// convex hulls; a few GJK runs for rounded hulls, rounded ellipsoids and shapes of the user's own; logarithmic in the
/// triangles for meshes; the sum of the children for compounds.
/// Sources: Kay, Kajiya 1986 (slabs); Cyrus, Beck 1978 (clipping by planes); Woop, Benthin, Wald 2013 (triangles); van
/// den Bergen 2004, "Ray casting against general convex objects with application to continuous collision detection"
/// (shapes given by their distance or their support function).
/// A `trace` is filled, after the answer, with the spans or steps of the ray, and for composites with the number of
/// nodes and pieces visited.
template <class T>
GRAZE_API std::optional<RayHit<T>> raycast(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray,
                                           T length = std::numeric_limits<T>::infinity(),
                                           BackFaces back = BackFaces::hit, Trace* trace = nullptr);

/// Whether the ray hits anything with 0 <= t <= `length`, as for shadows and lines of sight: `raycast` would return a
/// hit. Parameters and cost as there, but a composite stops at whichever piece is found first.
template <class T>
GRAZE_API bool raycast_any(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray,
                           T length = std::numeric_limits<T>::infinity(), BackFaces back = BackFaces::hit);

/// Appends where the ray enters each piece of the shape with 0 <= t <= `length`, sorted by t (equal ones by piece): at
/// most one hit for a convex shape, one for each triangle of a mesh that is met and for each convex shape in a
/// compound. A ray through an edge of a mesh meets both its triangles. Parameters as for `raycast`; cost: as there, for
/// all pieces that are hit, and the sort. Returns the number of hits appended.
template <class T>
GRAZE_API std::size_t raycast_all(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray,
                                  std::vector<RayHit<T>>& hits, T length = std::numeric_limits<T>::infinity(),
                                  BackFaces back = BackFaces::hit);

}  // namespace graze
