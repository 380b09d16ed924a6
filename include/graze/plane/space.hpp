// The trait `graze::Space` of two dimensions.
#pragma once

#include "graze/aabb.hpp"
#include "graze/plane/cast.hpp"
#include "graze/world/space.hpp"

namespace graze::plane {

/// The trait of the plane.
template <class T>
struct GRAZE_API Space {
  using Vec = Vec2<T>;
  using Turning = T;  ///< an angular velocity: radians per unit of time, counter-clockwise
  using Pose = Pose2<T>;
  using Shape = plane::Shape<T>;
  using HalfSpace = HalfPlane<T>;
  using PlacedRef = plane::PlacedRef<T>;
  using Distance = plane::Distance<T>;
  using ContactPoint = plane::ContactPoint<T>;
  using Manifold = plane::Manifold<T>;
  using Ray = plane::Ray<T>;
  using RayHit = plane::RayHit<T>;
  struct BackFaces {};  ///< none: a ray of the plane meets both sides of shapes without an inside
  using Velocity = plane::Velocity<T>;
  using CastHit = plane::CastHit<T>;

  /// Whether bodies that move over fixed bodies side by side meet these as if they were one.
  static constexpr bool joins_fixed = true;

  /// Placeholder shape at an index whose body is gone.
  static Shape nothing() { return Circle<T>(T(0)); }

  /// The bounds of a shape under a pose.
  static Aabb<T> bounds(const Shape& shape, const Pose& pose) { return flat(plane::bounds(shape, pose)); }
  /// The bounds of a shape at a pose, or, with an angular velocity, of all orientations that it may come to.
  static Aabb<T> bounds_turning(const Shape& shape, const Pose& pose, const Turning& angular);
  /// A vector of the plane in the space of the broad phase's boxes, which are flat.
  static Vec3<T> among_boxes(const Vec& v) { return {v.x, v.y, T(0)}; }
  /// An upper bound of the speed of any point of a shape due to its rotation.
  static T speed_of_turning(const Shape& shape, const Turning& angular);

  /// The pose, checked as by `graze::Space`. An error for a rotation that is not finite or zero names "pose.rotation".
  static Pose checked(const Pose& pose);
  /// Throws `InvalidValue` for velocities that are not finite or too large.
  static void check(const Vec& linear, const Turning& angular);

  /// The query `graze::plane::raycast`.
  static std::optional<RayHit> raycast(const Shape& shape, const Pose& pose, const Ray& ray, T length, BackFaces) {
    return plane::raycast(shape, pose, ray, length);
  }
  /// The query `graze::plane::cast`.
  static std::optional<CastHit> cast(const Shape& a, const Pose& pose_a, const Velocity& velocity_a, const Shape& b,
                                     const Pose& pose_b, const Velocity& velocity_b, T duration,
                                     const CastOptions& options) {
    return plane::cast(a, pose_a, velocity_a, b, pose_b, velocity_b, duration, options);
  }

 private:
  static Aabb<T> flat(const Aabb2<T>& box) {
    return {{box.lower.x, box.lower.y, T(0)}, {box.upper.x, box.upper.y, T(0)}};
  }
};

}  // namespace graze::plane
