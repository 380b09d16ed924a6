// The plane as a world knows it: the trait `graze::Space` of two dimensions.
#pragma once

#include "graze/aabb.hpp"
#include "graze/plane/cast.hpp"
#include "graze/world/space.hpp"

namespace graze::plane {

/// A shape in place, both of them somebody else's.
template <class T>
struct PlacedRef {
  const Shape<T>* shape;  ///< the shape, which outlives the reference
  const Pose2<T>* pose;   ///< where it stands
};

/// What a world asks of the number of dimensions: here two.
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
  struct BackFaces {};  ///< a ray of the plane meets both sides of what has no inside
  using Velocity = plane::Velocity<T>;
  using CastHit = plane::CastHit<T>;

  /// The seams between fixed bodies are felt; those within a polygon or a chain are not.
  static constexpr bool joins_fixed = false;

  /// A shape for places that no body has.
  static Shape nothing() { return Circle<T>(T(0)); }

  /// What bounds the shape under a pose.
  static Aabb<T> bounds(const Shape& shape, const Pose& pose) { return flat(plane::bounds(shape, pose)); }
  /// What bounds the shape while it turns so fast.
  static Aabb<T> bounds_turning(const Shape& shape, const Pose& pose, const Turning& angular);
  /// A vector of the plane among the boxes of the broad phase, which are flat.
  static Vec3<T> among_boxes(const Vec& v) { return {v.x, v.y, T(0)}; }
  /// How fast a point of the shape moves by this turning, at most.
  static T speed_of_turning(const Shape& shape, const Turning& angular);

  /// As `graze::Space`, with "pose.rotation" for a rotation that is not finite or zero.
  static Pose checked(const Pose& pose);
  /// Throws `InvalidValue` for velocities that are not finite or too large.
  static void check(const Vec& linear, const Turning& angular);

  /// As `graze::plane::raycast`.
  static std::optional<RayHit> raycast(const Shape& shape, const Pose& pose, const Ray& ray, T length, BackFaces) {
    return plane::raycast(shape, pose, ray, length);
  }
  /// As `graze::plane::cast`.
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
