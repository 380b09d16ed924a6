// Batches in the plane: the queries of plane/query.hpp on many pairs of shapes at once.
//
// Guarantee: each pair gets the bits that the query gives for it alone, whatever the order of the pairs, the other
// pairs of the batch, the level of the instruction set and the number of threads; a batch is a matter of speed only.
// Circles, untapered capsules, segments, boxes, half-planes and convex polygons of up to eight vertices are answered
// many at a time where that is faster, all other pairs one by one. Kernels allocate nothing; the arrays of the answer
// grow as needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "graze/batch_contacts.hpp"
#include "graze/batch_pairs.hpp"
#include "graze/executor.hpp"
#include "graze/plane/cast.hpp"
#include "graze/plane/query.hpp"

namespace graze::plane {

/// Shapes and their poses, in the caller's arrays: `graze::Bodies` (`graze/batch_pairs.hpp`) of the plane.
template <class T>
using Bodies = graze::Bodies<T, Placed<T>>;
/// The pairs of a batched query.
template <class T>
using Batch = graze::Batch<T, Placed<T>>;
/// Contacts of a batch: the manifolds and points of all its pairs in three arrays.
template <class T>
using BatchContacts = graze::BatchContacts<T, ContactPoint<T>>;

/// Sets `touch[i]` to 1 where the i-th pair overlaps, else to 0. With an executor, on its threads.
template <class T>
GRAZE_API void overlap(const Batch<T>& batch, std::vector<std::uint8_t>& touch, Executor* executor = nullptr);

/// Sets `distances[i]` to the `distance` of the i-th pair. With an executor, on its threads.
template <class T>
GRAZE_API void distance(const Batch<T>& batch, std::vector<Distance<T>>& distances, Executor* executor = nullptr);

/// Contacts of the pairs that are at most `margin` >= 0 apart, as `contacts` gives them. With an executor, on its
/// threads; the arrays are the same.
template <class T>
GRAZE_API void contacts(const Batch<T>& batch, T margin, BatchContacts<T>& found, Executor* executor = nullptr);

/// Sets `hits[i]` to the first contact of the i-th pair at a time in [0, duration], as `cast` gives it, or to none.
/// `velocities_a` and `velocities_b` are those of the bodies of `batch.a()` and `batch.b()`: as many as
/// bodies, or one for all of them. Throws `InvalidValue` for numbers that do not match. With an executor, on its
/// threads. Cost: of pairs that do not turn, with `Separating::hit`, of the kinds that are answered many at a time, a
/// quarter to four fifths of that of the casts one by one (docs/plane.md); else the same.
template <class T>
GRAZE_API void cast(const Batch<T>& batch, std::type_identity_t<std::span<const Velocity<T>>> velocities_a,
                    std::type_identity_t<std::span<const Velocity<T>>> velocities_b, std::type_identity_t<T> duration,
                    std::vector<std::optional<CastHit<T>>>& hits, const CastOptions& options = {},
                    Executor* executor = nullptr);

/// Writes the nearest point of the shape's surface for each of `points`, as `closest` gives it, to the entry of `found`
/// at the point's index. Points beyond the end of `found` are left out. With an executor, on its threads.
/// Cost: that of the points one by one.
template <class T>
GRAZE_API void closest(const Shape<T>& shape, const Pose2<T>& pose,
                       std::type_identity_t<std::span<const Vec2<T>>> points,
                       std::type_identity_t<std::span<Closest<T>>> found, Executor* executor = nullptr);

/// Writes the first hit of each ray with 0 <= t <= `length`, as `raycast` defines it, to the entry of `hits` at the
/// ray's index. Rays beyond the end of `hits` are left out. At boxes and convex polygons without rounding many rays at
/// a time.
template <class T>
GRAZE_API void raycast(const Shape<T>& shape, const Pose2<T>& pose, std::span<const Ray<T>> rays,
                       std::span<std::optional<RayHit<T>>> hits, T length = std::numeric_limits<T>::infinity());

/// Writes to `hits`, for each ray, whether anything is hit with 0 <= t <= `length`, as `raycast_any` defines it.
template <class T>
GRAZE_API void raycast_any(const Shape<T>& shape, const Pose2<T>& pose, std::span<const Ray<T>> rays,
                           std::span<bool> hits, T length = std::numeric_limits<T>::infinity());

}  // namespace graze::plane
