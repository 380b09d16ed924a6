// Sphere against triangle: the nearest point of the triangle to the centre, across lanes, in double.
//
// Guarantee: `distance`, `overlap` and `contacts` share this answer, so that they agree on touching, for one pair and
// for many. Unknown where the centre lies about on the triangle, and for slivers: the general path answers then.
#pragma once

#include <cmath>
#include <optional>

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/core/minkowski.hpp"
#include "narrow/core/relative_frame.hpp"
#include "narrow/pairs/closed_form.hpp"
#include "narrow/pairs/triangle_closest_feature.hpp"
#include "simd/flatten.hpp"

namespace graze {

/// A triangle and a sphere or capsule, in a frame at the latter's origin along the world's axes.
template <class S>
struct SphereCapsuleAndTriangle {
  TriangleRegions<S> triangle;
  Mat3<S> turn;             ///< rotation of the triangle
  Vec3<S> origin, between;  ///< origin of that frame in the world, and its offset from the triangle's origin
  S radius_round, radius_triangle;
  S noise;  ///< rounding of a distance: `noise_of`

  /// `extent`: that of the sphere's or capsule's core.
  SphereCapsuleAndTriangle(const S& radius, const S& extent, const Pose<S>& pose, const Rounded<TriangleCore<S>, S>& of,
                           const Pose<S>& pose_triangle)
      : triangle(of.core),
        turn(rotation_of(pose_triangle.rotation)),
        origin(pose.translation),
        between(origin - pose_triangle.translation),
        radius_round(radius),
        radius_triangle(of.radius),
        noise(S(rounding_error) *
              (greatest(extent + radius_round, triangle.extent() + radius_triangle) + max_abs(between))) {}

  Vec3<S> seen_by_triangle(const Vec3<S>& p) const { return transposed_times(turn, p + between); }
  NearTriangle<S> nearest_to(const Vec3<S>& p) const { return triangle.nearest_to(seen_by_triangle(p), noise); }
  /// The distance of the rounded shapes, whose cores are nearest at `p` and `near`.
  CoreDistance<S> in_world(const Vec3<S>& p, const NearTriangle<S>& near) const {
    using std::abs;
    const S radii = radius_round + radius_triangle;
    // A distance within rounding of zero is zero: the two touch.
    const S apart = select(abs(near.distance - radii) <= noise, radii, near.distance);
    const Vec3<S> normal = -(turn * near.outward);
    return {apart - radii, normal, origin + (p + normal * radius_round),
            origin + (p + normal * (apart - radius_triangle))};
  }
};

/// A ball and a triangle. Results are meaningful only where they are known.
template <class S>
class BallAndTriangle {
  using Mask = decltype(S() < S());

 public:
  BallAndTriangle(const Rounded<PointCore<S>, S>& ball, const Pose<S>& pose,
                  const Rounded<TriangleCore<S>, S>& triangle, const Pose<S>& pose_triangle)
      : pair_(ball.radius, length(ball.core.point), pose, triangle, pose_triangle) {
    const Mask regular = pair_.triangle.regular();
    if (!any(regular)) return;
    // The shortcut gives the same bits, since zeros lose their sign: most balls are about their origins.
    if (!is_origin(ball.core.point)) center_ = rotation_of(pose.rotation) * ball.core.point + center_;
    near_ = pair_.nearest_to(center_);
    near_.known = near_.known & regular;
  }

  Mask known() const { return near_.known; }
  CoreDistance<S> distance() const { return pair_.in_world(center_, near_); }
  /// Whether the two touch in one point at most.
  Mask one_point() const { return near_.known; }
  /// The parts of the ball and of the triangle that touch.
  S part() const { return S(0); }
  S triangle_part() const { return pair_.triangle.part(near_.place, near_.outward); }

 private:
  SphereCapsuleAndTriangle<S> pair_;
  Vec3<S> center_{S(0), S(0), S(0)};
  NearTriangle<S> near_{};
};

/// A triangle with its rounding radius, in double.
template <class T>
Rounded<TriangleCore<double>, double> rounded_in_double(const Triangle<T>& triangle, T margin) {
  return {{{converted<double>(triangle.point(0)), converted<double>(triangle.point(1)),
            converted<double>(triangle.point(2))}},
          static_cast<double>(margin)};
}

/// A sphere and a triangle with their rounding radii, in double.
template <class T>
BallAndTriangle<double> with_triangle(const Sphere<T>& ball, T margin, const Pose<T>& pose, const Triangle<T>& triangle,
                                      T margin_triangle, const Pose<T>& pose_triangle) {
  const auto of = rounded_core(ball, margin);
  return {{converted<double>(of.core), static_cast<double>(of.radius)},
          converted<double>(pose),
          rounded_in_double(triangle, margin_triangle),
          converted<double>(pose_triangle)};
}

/// The distance of a pair, rounded to T; nothing where it is not known.
template <class T, class Pair>
std::optional<Distance<T>> distance_of(const Pair& pair) {
  if (!pair.known()) return std::nullopt;
  const CoreDistance<double> d = pair.distance();
  return Distance<T>{static_cast<T>(d.distance), converted<T>(d.normal), converted<T>(d.a), converted<T>(d.b)};
}

}  // namespace graze
