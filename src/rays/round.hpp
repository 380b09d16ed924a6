// Rays against what balls make: the ball, and the convex hull of two balls (capsules, even or tapered).
//
// Guarantee: closed forms. A radius of zero is replaced by the ray's blur: a point or a segment is met when the ray
// passes it as closely as its own numbers are known.
#pragma once

#include "graze/geometry.hpp"
#include "rays/local_ray.hpp"

namespace graze::rays {

/// What is left of the ray's own direction across a unit vector, turned back: the normal of a thin thing.
inline Vec3d facing_back(const LocalRay& ray, const Vec3d& along) {
  return normalized(along * dot(ray.direction, along) - ray.direction, -ray.direction);
}

/// A normal of a cone's tip that faces the ray: back along the ray where that supports the cone, else the side's normal
/// that comes nearest to it. `outward` points along the axis out of the cone, `sine` is the part along it of the side's
/// normals.
inline Vec3d tip_normal(const LocalRay& ray, const Vec3d& outward, double sine) {
  const double along = -dot(ray.direction, outward);
  if (along >= sine) return -ray.direction;
  const Vec3d across = normalized(-ray.direction - outward * along, any_perpendicular(outward));
  return outward * sine + across * std::sqrt((1 - sine) * (1 + sine));
}

/// Where the ray is within `radius` of a point; from the distance of the centre and not a difference of squares.
struct Span {
  double enter = infinity, leave = -infinity;
};
inline Span ball_span(const LocalRay& ray, const Vec3d& center, double radius) {
  const Vec3d to = center - ray.origin;
  const double along = dot(to, ray.direction);
  const double across = length(to - ray.direction * along);
  if (!(across <= radius)) return {};
  const double half = std::sqrt((radius - across) * (radius + across));
  return {along - half, along + half};
}

inline MaybeHit hit_ball(const LocalRay& far, const Vec3d& center, double radius) {
  const Recentered near = recentered(far, center);
  const Span span = ball_span(near.ray, center, radius > 0 ? radius : near.ray.blur);
  const Vec3d normal =
      radius > 0 ? normalized(near.ray.at(span.enter) - center, -near.ray.direction) : -near.ray.direction;
  return near.restored(entered(near.ray, span.enter, span.leave, normal));
}

/// A segment without thickness: the ray's point nearest to it, where that is near enough.
inline MaybeHit hit_thin_segment(const LocalRay& far, const Vec3d& a, const Vec3d& b) {
  const Recentered near = recentered(far, (a + b) * 0.5);
  const LocalRay& ray = near.ray;
  const double size = length(b - a), thick = ray.blur + 4 * epsilon * size;
  const Vec3d along = normalized(b - a);
  const double t0 = dot(a - ray.origin, ray.direction), t1 = dot(b - ray.origin, ray.direction);
  const double low = clamp(least(t0, t1), ray.begin, ray.end), high = clamp(greatest(t0, t1), low, ray.end);
  double t = low;  // of a ray along the segment, where it begins
  if (length(cross(ray.direction, along)) * size > thick)
    t = low + (high - low) * closest_parameters<double>({ray.at(low), ray.at(high)}, {a, b}).s;
  if (length(closest_point<double>({a, b}, ray.at(t)) - ray.at(t)) > thick) return {};
  return near.restored(hit_at(ray, t, facing_back(ray, along)));
}

/// The convex hull of a ball about `a` and one about `b`, neither inside the other: the side is the cone
/// cos * rho + sin * y = radius_a, y along the axis from `a` and rho across it, between the circles where it touches
/// the balls.
class BallCone {
 public:
  BallCone(const Vec3d& a, double radius_a, const Vec3d& b, double radius_b)
      : a_(a),
        b_(b),
        radius_a_(radius_a),
        radius_b_(radius_b),
        height_(length(b - a)),
        axis_((b - a) / height_),
        sin_((radius_a - radius_b) / height_),
        cos_(std::sqrt((1 - sin_) * (1 + sin_))) {}

  MaybeHit hit(const LocalRay& far) const {
    const Recentered near = recentered(far, (a_ + b_) * 0.5);
    const LocalRay& ray = near.ray;
    // The balls and the side between them make up a convex body, so that the ray is in it from the first place where it
    // enters one of them to the last where it leaves one. From the whole span and not from the entries after its
    // beginning: a ray that begins on the surface may find its entry behind it by rounding.
    Span span = ball_span(ray, a_, radius_a_);
    const auto include = [&](double enter, double leave) {
      span = {least(span.enter, enter), greatest(span.leave, leave)};
    };
    const Span other = ball_span(ray, b_, radius_b_);
    include(other.enter, other.leave);
    for_side(ray, [&](double t) { include(t, t); });
    if (!(span.enter <= span.leave)) return {};
    return near.restored(entered(ray, span.enter, span.leave, normal_at(ray, ray.at(span.enter))));
  }

 private:
  /// Along the axis from `a`, the centre of the sphere between the two that comes nearest to `p`.
  double sphere_place(const Vec3d& p) const {
    const double y = dot(p - a_, axis_);
    return clamp(y - sin_ * length(p - a_ - axis_ * y) / cos_, 0.0, height_);
  }

  Vec3d normal_at(const LocalRay& ray, const Vec3d& p) const {
    const double place = sphere_place(p);
    const Vec3d out = p - (a_ + axis_ * place);
    // Where the radius is no more than rounding, so is `out`.
    if (length(out) > 8 * epsilon * (height_ + radius_a_ + radius_b_)) return normalized(out);
    if (place <= 0) return tip_normal(ray, -axis_, -sin_);
    if (place >= height_) return tip_normal(ray, axis_, sin_);
    return facing_back(ray, axis_) * cos_ + axis_ * sin_;
  }

  template <class F>
  void for_side(const LocalRay& ray, const F& f) const {
    const double dy = dot(ray.direction, axis_);
    const Vec3d across = ray.direction - axis_ * dy;
    // From the point nearest to the axis, so that a thin long capsule's radius is not lost in its length.
    const Vec3d from = ray.origin - a_;
    const double size = height_ + radius_a_ + radius_b_;
    const double shift = clamp(-ratio(dot(from, across), dot(across, across)), -size, size);
    const Vec3d base = from + ray.direction * shift;
    const double y = dot(base, axis_);
    const Vec3d off = base - axis_ * y;
    const double rest = radius_a_ - sin_ * y, c2 = cos_ * cos_;
    const Roots r = roots(c2 * dot(across, across) - sin_ * sin_ * dy * dy, c2 * dot(off, across) + sin_ * dy * rest,
                          c2 * dot(off, off) - rest * rest);
    if (!r.real) return;
    for (const double t : {r.first, r.second}) {
      const double at = y + t * dy;
      if (at >= sin_ * radius_a_ && at <= height_ + sin_ * radius_b_) f(t + shift);
    }
  }

  Vec3d a_, b_;
  double radius_a_, radius_b_, height_;
  Vec3d axis_;
  double sin_, cos_;
};

/// The convex hull of two balls, one of which may hold the other.
inline MaybeHit hit_balls(const LocalRay& ray, const Vec3d& a, double radius_a, const Vec3d& b, double radius_b) {
  if (length(b - a) <= std::abs(radius_a - radius_b) || a == b)
    return radius_a >= radius_b ? hit_ball(ray, a, radius_a) : hit_ball(ray, b, radius_b);
  if (radius_a <= 0 && radius_b <= 0) return hit_thin_segment(ray, a, b);
  return BallCone(a, radius_a, b, radius_b).hit(ray);
}

}  // namespace graze::rays
