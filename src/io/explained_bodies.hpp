// The bodies of an explanation as a picture needs them: in space or in the plane, at a time, and the view on them.
#pragma once

#include <algorithm>
#include <optional>

#include "graze/io/explain.hpp"
#include "graze/plane/cast.hpp"
#include "io/drawing.hpp"
#include "io/plane_shapes.hpp"

namespace graze::io {

/// A view of an axis in true length: the viewer looks across it, from about the direction `toward`.
inline Vec3d across(const Vec3d& toward, const Vec3d& axis) {
  const Vec3d seen = toward - axis * dot(toward, axis);
  return length(seen) > 0.05 * length(toward) ? seen : any_perpendicular(axis);
}

/// Bounds of the shapes that have any, and of the points that have to be seen besides; a box of 2 when nothing has.
class Stage {
 public:
  void add(const Aabbd& of) {
    if (max_abs(of.extent()) < 1e300) box_ = merged(box_, of);
  }
  void add(const Vec3d& p) { box_ = merged(box_, p); }
  Aabbd box() const { return box_.lower.x <= box_.upper.x ? box_ : Aabbd{{-1, -1, -1}, {1, 1, 1}}; }
  double size() const { return std::max(max_abs(box().extent()), least_size); }

 private:
  Aabbd box_ = Aabbd::empty();
};

/// The two bodies of an explanation, in space or in the plane, in the form that a picture needs. `b` is the second one.
class Drawn {
 public:
  explicit Drawn(const Explanation& e) : e_(e) {}

  bool has(bool b) const { return e_.dimension == 2 ? of_plane(b).has_value() : of_space(b).has_value(); }
  Vec3d origin(bool b) const {
    if (e_.dimension == 3) return of_space(b)->pose.translation;
    const plane::Vec2d& at = of_plane(b)->pose.translation;
    return {at.x, at.y, 0};
  }
  Aabbd box(bool b, double t) const {
    return e_.dimension == 2 ? plane_bounds(of_plane(b)->shape, in_plane(b, t))
                             : bounds(of_space(b)->shape, in_space(b, t));
  }
  Polygons polygons(bool b, double t, const Vec3d& center, double size) const {
    return e_.dimension == 2 ? tessellate(of_plane(b)->shape, in_plane(b, t), center, size)
                             : tessellate(of_space(b)->shape, in_space(b, t), center, size);
  }
  bool straight(bool b) const { return e_.dimension == 2 && has_straight_sides(of_plane(b)->shape); }

 private:
  const std::optional<Placed<double>>& of_space(bool b) const { return b ? e_.b : e_.a; }
  const std::optional<plane::Placed<double>>& of_plane(bool b) const { return b ? e_.plane_b : e_.plane_a; }
  const Velocity<double>& velocity(bool b) const { return b ? e_.cast->b : e_.cast->a; }
  Posed in_space(bool b, double t) const {
    return e_.cast ? pose_at(of_space(b)->pose, velocity(b), t) : of_space(b)->pose;
  }
  plane::Pose2d in_plane(bool b, double t) const {
    if (!e_.cast) return of_plane(b)->pose;
    const Velocity<double>& v = velocity(b);
    return plane::pose_at(of_plane(b)->pose, plane::Velocity<double>{{v.linear.x, v.linear.y}, v.angular.z}, t);
  }

  const Explanation& e_;
};

}  // namespace graze::io
