// Rays and moving bodies in the plane: what a ray hits first, and when two bodies first touch.
//
// Guarantee: rays as `graze/raycast.hpp`, casts as `graze/cast.hpp`: no hit is missed and none is passed. With D =
// `cast_tolerance<T>` times the size of the pair plus the rounding of the path, shapes are no more than D apart at the
// time of a hit. Translations of shapes with straight sides, rounded or not, and of circles and capsules are exact: a
// ray against their Minkowski difference. All else goes by conservative advancement (Mirtich 1996, section 2.3).
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
  Vec2<T> origin{}, direction{};  ///< where it begins, and where to
};

/// Where a ray meets a shape, in world space.
template <class T>
struct RayHit {
  T t{};                    ///< how far along the ray, in units of length (not in multiples of its direction)
  Vec2<T> point{};          ///< on the surface; the ray's origin when that lies inside a solid
  Vec2<T> normal{};         ///< unit, against the ray; minus the ray's direction when its origin lies inside a solid
  std::uint32_t piece = 0;  ///< the child of a compound (of the outermost one), else 0
  /// `bounded` when the iteration bound was reached first: the ray passes so close by that it may miss. Only of
  /// ellipses, tapered capsules and users' shapes.
  Status status = Status::converged;
};

/// The first hit with 0 <= t <= `length`; nothing on a miss, and for a direction that is zero. A ray that starts in a
/// solid (distance <= 0) hits at t = 0. A `trace` gets, after the answer, the spans of the ray in what the nearest
/// piece is made of, or the steps towards it.
template <class T>
GRAZE_API std::optional<RayHit<T>> raycast(const Shape<T>& shape, const Pose2<T>& pose, const Ray<T>& ray,
                                           T length = std::numeric_limits<T>::infinity(), Trace* trace = nullptr);

/// Whether the ray hits anything with 0 <= t <= `length`, as for lines of sight: `raycast` would return a hit. Stops at
/// whichever piece is found first.
template <class T>
GRAZE_API bool raycast_any(const Shape<T>& shape, const Pose2<T>& pose, const Ray<T>& ray,
                           T length = std::numeric_limits<T>::infinity());

/// Appends where the ray enters each piece of the shape with 0 <= t <= `length`, sorted by t (of equals, by piece): at
/// most one hit for a convex shape, one for each convex piece of a polygon, segment of a chain and convex shape in a
/// compound. Returns how many were appended.
template <class T>
GRAZE_API std::size_t raycast_all(const Shape<T>& shape, const Pose2<T>& pose, const Ray<T>& ray,
                                  std::vector<RayHit<T>>& hits, T length = std::numeric_limits<T>::infinity());

/// How a body moves: at constant speed along a line, turning about its origin (its pose's translation) at constant
/// rate.
template <class T>
struct Velocity {
  Vec2<T> linear{};  ///< the velocity of the pose's origin
  T angular{};       ///< radians per unit of time, counter-clockwise
};

/// Where a body stands at time t: translation + t linear, turned by t angular.
template <class T>
GRAZE_API Pose2<T> pose_at(const Pose2<T>& pose, const Velocity<T>& velocity, T t);

/// When two shapes that move first touch, and where.
template <class T>
struct CastHit {
  T t{};             ///< when, from 0 to the duration
  Vec2<T> point{};   ///< in the world at time t, in the middle of what is left of the gap
  Vec2<T> normal{};  ///< unit, from A to B, in the world at time t
  T depth{};         ///< of shapes that overlap at the start: how deep, as `distance` says; else 0 (or up to D)
  /// `bounded` when the iteration bound was reached first: t is then the earliest time that is not excluded, and
  /// whether the shapes touch at all is not known.
  Status status = Status::converged;
  std::uint32_t piece_a = 0, piece_b = 0;  ///< which child of a compound it is, else 0
};

/// The first contact at a time in [0, duration] of two bodies that start at the poses given. Shapes that touch or
/// overlap at the start hit at t = 0 (but see `Separating`). `duration` is finite and >= 0. A half-plane that turns has
/// a bounded answer at best. A `trace` gets, after the answer, the Minkowski difference that the motion was followed
/// in, or the steps of conservative advancement, of the pieces that meet first (of a miss, of the first pair).
template <class T>
GRAZE_API std::optional<CastHit<T>> cast(const Shape<T>& a, const Pose2<T>& pose_a, const Velocity<T>& velocity_a,
                                         const Shape<T>& b, const Pose2<T>& pose_b, const Velocity<T>& velocity_b,
                                         T duration, const CastOptions& options = {}, Trace* trace = nullptr);

/// Appends the first contact of every pair of convex pieces of two shapes, as if each were alone, in the order of time
/// (of equals, by pieces); of convex shapes that is at most one.
template <class T>
GRAZE_API void cast_all(const Shape<T>& a, const Pose2<T>& pose_a, const Velocity<T>& velocity_a, const Shape<T>& b,
                        const Pose2<T>& pose_b, const Velocity<T>& velocity_b, T duration,
                        std::vector<CastHit<T>>& hits, const CastOptions& options = {});

}  // namespace graze::plane
