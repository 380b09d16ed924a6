// Rays and moving bodies in the plane: the first hit of a ray, and the first contact of two bodies.
//
// Guarantee: rays have that of `graze/raycast.hpp`, casts that of `graze/cast.hpp`: no hit is missed and none is
// passed. With D = `cast_tolerance<T>` times the size of the pair plus the rounding of the path, shapes are no more
// than D apart at the time of a hit. Translations of shapes with straight sides, rounded or not, and of circles and
// capsules are exact: a ray against their Minkowski difference. All other motions go by conservative advancement
// (Mirtich 1996, section 2.3), those of ellipses, tapered capsules and shapes of the user's own that do not turn among
// them: no step leads past a contact, so that the time is never late, and early by no more than the closing of D takes.
// Nothing throws or prints; safe from any thread.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "graze/motion.hpp"
#include "graze/plane/query.hpp"

namespace graze::plane {

/// The points origin + t direction with t >= 0.
template <class T>
struct Ray {
  Vec2<T> origin{}, direction{};  ///< starting point, and direction of any length
};

/// The hit of a ray with a shape, in world space.
template <class T>
struct RayHit {
  T t{};                    ///< distance along the ray, in units of length (not in multiples of its direction)
  Vec2<T> point{};          ///< on the surface; the ray's origin when that lies inside a solid
  Vec2<T> normal{};         ///< unit, against the ray; minus the ray's direction when its origin lies inside a solid
  std::uint32_t piece = 0;  ///< the child of a compound (of the outermost one), else 0
  /// `bounded` when the iteration bound was reached first: the ray passes so close by that it may miss. Only for
  /// ellipses, tapered capsules and users' shapes.
  Status status = Status::converged;
};

/// The first hit with 0 <= t <= `length`; nothing on a miss, and for a direction that is zero. A ray that starts in a
/// solid (distance <= 0) hits at t = 0. A `trace` is filled, after the answer, with the spans of the ray in the
/// components of the nearest piece, or the steps towards it.
template <class T>
GRAZE_API std::optional<RayHit<T>> raycast(const Shape<T>& shape, const Pose2<T>& pose, const Ray<T>& ray,
                                           T length = std::numeric_limits<T>::infinity(), Trace* trace = nullptr);

/// Whether the ray hits anything with 0 <= t <= `length`, as for lines of sight: `raycast` would return a hit. Stops at
/// whichever piece is found first.
template <class T>
GRAZE_API bool raycast_any(const Shape<T>& shape, const Pose2<T>& pose, const Ray<T>& ray,
                           T length = std::numeric_limits<T>::infinity());

/// Appends where the ray enters each piece of the shape with 0 <= t <= `length`, sorted by t (equal ones by piece): at
/// most one hit for a convex shape, one for each convex piece of a polygon, segment of a chain and convex shape in a
/// compound. Returns the number of hits appended.
template <class T>
GRAZE_API std::size_t raycast_all(const Shape<T>& shape, const Pose2<T>& pose, const Ray<T>& ray,
                                  std::vector<RayHit<T>>& hits, T length = std::numeric_limits<T>::infinity());

/// The motion of a body: constant linear velocity, and rotation about its origin (its pose's translation) at a constant
/// rate.
template <class T>
struct Velocity {
  Vec2<T> linear{};  ///< the velocity of the pose's origin
  T angular{};       ///< radians per unit of time, counter-clockwise
};

/// The pose of a body at time `t`: translation + t linear, turned by t angular.
template <class T>
GRAZE_API Pose2<T> pose_at(const Pose2<T>& pose, const Velocity<T>& velocity, T t);

/// The first contact of two moving shapes.
template <class T>
struct CastHit {
  T t{};             ///< time of the contact, from 0 to the duration
  Vec2<T> point{};   ///< in the world at time t, in the middle of the remaining gap
  Vec2<T> normal{};  ///< unit, from A to B, in the world at time t
  T depth{};         ///< depth at the start, as `distance` gives it, of shapes that overlap there; else 0 (or up to D)
  /// `bounded` when the iteration bound was reached first: t is then the earliest time that is not excluded, and
  /// whether the shapes touch at all is not known.
  Status status = Status::converged;
  std::uint32_t piece_a = 0, piece_b = 0;  ///< the child of a compound that is hit, else 0
};

/// The first contact at a time in [0, duration] of two bodies that start at the given poses. Shapes that touch or
/// overlap at the start hit at t = 0 (but see `Separating`). `duration` is finite and >= 0. A half-plane that turns has
/// a bounded answer at best. A `trace` is filled, after the answer, with the Minkowski difference in which the motion
/// was followed, or with the steps of conservative advancement, for the pieces that meet first (on a miss, the first
/// pair).
template <class T>
GRAZE_API std::optional<CastHit<T>> cast(const Shape<T>& a, const Pose2<T>& pose_a, const Velocity<T>& velocity_a,
                                         const Shape<T>& b, const Pose2<T>& pose_b, const Velocity<T>& velocity_b,
                                         T duration, const CastOptions& options = {}, Trace* trace = nullptr);

/// Appends the first contact of every pair of convex pieces of two shapes, as if each were alone, ordered by time
/// (equal ones by pieces): at most one for convex shapes.
template <class T>
GRAZE_API void cast_all(const Shape<T>& a, const Pose2<T>& pose_a, const Velocity<T>& velocity_a, const Shape<T>& b,
                        const Pose2<T>& pose_b, const Velocity<T>& velocity_b, T duration,
                        std::vector<CastHit<T>>& hits, const CastOptions& options = {});

}  // namespace graze::plane
