// Sphere against triangle: the nearest point of the triangle to the centre, in double.
//
// Guarantee: `distance`, `overlap` and `contacts` take their answer from here, so that they agree on what touches.
// Nothing is answered where the centre lies about on the triangle, and of slivers: the general path does that.
#pragma once

#include <cmath>
#include <optional>

#include "graze/query.hpp"
#include "narrow/features.hpp"
#include "narrow/minkowski.hpp"
#include "narrow/pairs/sided_triangle.hpp"
#include "narrow/relative_frame.hpp"
#include "shape/rounding.hpp"

namespace graze {

/// A triangle and a shape of a round core, in a frame at the round one's origin along the world's axes.
template <class T>
struct RoundAndTriangle {
  SidedTriangle triangle;
  Mat3d turn;             ///< of the triangle
  Vec3d origin, between;  ///< of that frame in the world, and from the triangle's origin to there
  double radius_round, radius_triangle;
  double noise;  ///< what rounding may do to a distance: `noise_of`

  RoundAndTriangle(T radius, double extent, const Pose<T>& pose, const Triangle<T>& of, T margin_triangle,
                   const Pose<T>& pose_triangle)
      : triangle(of),
        turn(rotation_of(cast<double>(pose_triangle.rotation))),
        origin(cast<double>(pose.translation)),
        between(origin - cast<double>(pose_triangle.translation)),
        radius_round(static_cast<double>(radius)),
        radius_triangle(static_cast<double>(margin_triangle)),
        noise(rounding * (greatest(extent + radius_round, triangle.extent() + radius_triangle) + max_abs(between))) {}

  Vec3d seen_by_triangle(const Vec3d& p) const { return transposed_times(turn, p + between); }
  std::optional<NearTriangle> nearest_to(const Vec3d& p) const {
    return triangle.nearest_to(seen_by_triangle(p), noise);
  }
  /// Of the rounded shapes, of which the cores are nearest at `p`, and where the triangle has it.
  Distance<T> in_world(const Vec3d& p, const NearTriangle& near) const {
    const double radii = radius_round + radius_triangle;
    // A distance that rounding cannot tell from none is none: they touch.
    const double apart = std::abs(near.distance - radii) <= noise ? radii : near.distance;
    const Vec3d normal = -(turn * near.outward);
    Distance<T> d;
    d.distance = static_cast<T>(apart - radii);
    d.normal = cast<T>(normal);
    d.a = cast<T>(origin + (p + normal * radius_round));
    d.b = cast<T>(origin + (p + normal * (apart - radius_triangle)));
    return d;
  }
};

/// The answers of a pair of such a shape and a triangle, where they are `known`.
template <class T, class Pair>
std::optional<Distance<T>> distance_of(const Pair& pair) {
  if (!pair.known()) return std::nullopt;
  return pair.distance();
}
template <class T, class Pair>
std::optional<T> contact_of(const Pair& pair, T margin, Manifold<T>& manifold) {
  if (!pair.known()) return std::nullopt;
  const Distance<T> d = pair.distance();
  if (d.distance <= margin && !pair.one_point()) return std::nullopt;
  manifold.normal = d.normal;
  if (d.distance <= margin) manifold.points.push_back({d.a, d.b, d.distance, pair.feature(), T(0.5)});
  return d.distance;
}

/// A ball and a triangle.
template <class T>
class BallAndTriangle {
 public:
  BallAndTriangle(const Sphere<T>& ball, T margin, const Pose<T>& pose, const Triangle<T>& triangle, T margin_triangle,
                  const Pose<T>& pose_triangle)
      : pair_(rounding_radius(ball, margin), static_cast<double>(ball.core_extent()), pose, triangle, margin_triangle,
              pose_triangle) {
    if (pair_.triangle.thin()) return;
    const Vec3d own = cast<double>(ball.center());
    if (own != Vec3d{}) center_ = rotation_of(cast<double>(pose.rotation)) * own;
    near_ = pair_.nearest_to(center_);
  }

  bool known() const { return near_.has_value(); }
  /// Only where it is known, as what follows.
  Distance<T> distance() const { return pair_.in_world(center_, *near_); }
  bool one_point() const { return true; }
  std::uint32_t feature() const {
    return feature_id(vertex_feature(0), pair_.triangle.feature(near_->place, near_->outward));
  }

 private:
  RoundAndTriangle<T> pair_;
  Vec3d center_{};
  std::optional<NearTriangle> near_{};
};

template <class T>
std::optional<Distance<T>> own_distance(const Sphere<T>& ball, T margin_ball, const Pose<T>& pose_ball,
                                        const Triangle<T>& triangle, T margin_triangle, const Pose<T>& pose_triangle) {
  return distance_of<T>(BallAndTriangle<T>(ball, margin_ball, pose_ball, triangle, margin_triangle, pose_triangle));
}

template <class T>
std::optional<T> own_contacts(const Sphere<T>& ball, T margin_ball, const Pose<T>& pose_ball,
                              const Triangle<T>& triangle, T margin_triangle, const Pose<T>& pose_triangle, T margin,
                              Manifold<T>& manifold) {
  return contact_of<T>(BallAndTriangle<T>(ball, margin_ball, pose_ball, triangle, margin_triangle, pose_triangle),
                       margin, manifold);
}

}  // namespace graze
