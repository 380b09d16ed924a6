// The trait of a world's space: its types and queries by number of dimensions.
//
// Guarantee: `World` and its stages are written once, over a trait of this form; `Space` is that of three dimensions,
// `plane::Space` (`graze/plane/space.hpp`) that of two. The boxes of broad phases have three dimensions in either:
// broad phases see no shapes, and boxes in the plane z = 0 overlap there as they do in the plane.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "graze/cast.hpp"
#include "graze/contact.hpp"
#include "graze/detail/validate.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"

namespace graze {

/// The trait of three-dimensional space.
template <class T>
struct GRAZE_API Space {
  using Vec = Vec3<T>;
  using Turning = Vec3<T>;  ///< an angular velocity
  using Pose = graze::Pose<T>;
  using Shape = graze::Shape<T>;
  using HalfSpace = graze::HalfSpace<T>;
  using PlacedRef = graze::PlacedRef<T>;
  using Distance = graze::Distance<T>;
  using ContactPoint = graze::ContactPoint<T>;
  using Manifold = graze::Manifold<T>;
  using Ray = graze::Ray<T>;
  using RayHit = graze::RayHit<T>;
  using BackFaces = graze::BackFaces;
  using Velocity = graze::Velocity<T>;
  using CastHit = graze::CastHit<T>;

  /// Whether bodies that move over fixed bodies side by side meet these as if they were one.
  static constexpr bool joins_fixed = true;

  /// Placeholder shape at an index whose body is gone.
  static Shape nothing() { return Sphere<T>(T(0)); }
  /// The bounds of a shape.
  static Aabb<T> bounds(const Shape& shape, const Pose& pose) { return graze::bounds(shape, pose); }
  /// The bounds of a shape at a pose, or, with an angular velocity, of all orientations that it may come to.
  static Aabb<T> bounds_turning(const Shape& shape, const Pose& pose, const Turning& angular);
  /// A vector of this space in the space of the boxes.
  static const Vec3<T>& among_boxes(const Vec& v) { return v; }
  /// An upper bound of the speed of any point of a shape due to its rotation.
  static T speed_of_turning(const Shape& shape, const Turning& angular);

  /// The pose, its rotation of unit length: a rotation that is one already stays bit for bit, whereas dividing it once
  /// more by its length could change it. The square of its length is then off by eight roundings at most: twice two and
  /// a half of each component, and three of the sum. Throws `InvalidValue` for a pose that is not finite or larger than
  /// `largest_magnitude`.
  static Pose checked(const Pose& pose) {
    const Quat<T> unit = validate::rotation(pose.rotation, "pose.rotation"), &q = pose.rotation;
    const T off = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w - T(1);
    const bool is_unit = std::abs(off) <= T(8) * std::numeric_limits<T>::epsilon();
    return {validate::point(pose.translation, "pose.translation"), is_unit ? q : unit};
  }
  /// Throws `InvalidValue` for velocities that are not finite or larger than `largest_magnitude`.
  static void check(const Vec& linear, const Turning& angular) {
    validate::point(linear, "linear");
    validate::point(angular, "angular");
  }

  /// The query `graze::raycast`.
  static std::optional<RayHit> raycast(const Shape& shape, const Pose& pose, const Ray& ray, T length, BackFaces back) {
    return graze::raycast(shape, pose, ray, length, back);
  }
  /// The query `graze::cast`.
  static std::optional<CastHit> cast(const Shape& a, const Pose& pose_a, const Velocity& velocity_a, const Shape& b,
                                     const Pose& pose_b, const Velocity& velocity_b, T duration,
                                     const CastOptions& options) {
    return graze::cast(a, pose_a, velocity_a, b, pose_b, velocity_b, duration, options);
  }
};

}  // namespace graze
