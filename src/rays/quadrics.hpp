// Rays against cylinders, cones and ellipsoids without rounding.
//
// Guarantee: closed forms; sizes of zero give discs, ellipses, segments and points.
#pragma once

#include "rays/round.hpp"

namespace graze::rays {

/// The solid |y| <= half_height, rho <= radius(y), the radius linear in y from `bottom` to `top`.
class Frustum {
 public:
  Frustum(double half_height, double bottom, double top)
      : half_(half_height),
        bottom_(bottom),
        top_(top),
        slope_(half_height > 0 ? (top - bottom) / (2 * half_height) : 0),
        middle_(half_height > 0 ? (top + bottom) / 2 : greatest(top, bottom)) {}

  MaybeHit hit(const LocalRay& far) const {
    if (bottom_ <= 0 && top_ <= 0) return hit_balls(far, {0, -half_, 0}, 0, {0, half_, 0}, 0);
    const Recentered near = recentered(far, {});
    const Span caps = caps_span(near.ray);
    if (!(caps.enter <= caps.leave)) return {};
    const Span in = side_span(near.ray, caps);
    return near.restored(entered(near.ray, in.enter, in.leave, normal_at(near.ray, in.enter, caps.enter)));
  }

 private:
  Span caps_span(const LocalRay& ray) const {
    const double y = ray.origin.y, dy = ray.direction.y;
    if (dy == 0) return std::abs(y) <= half_ ? Span{-infinity, infinity} : Span{};
    const double t0 = (-half_ - y) / dy, t1 = (half_ - y) / dy;
    return {least(t0, t1), greatest(t0, t1)};
  }

  /// The part of `caps` in which rho <= radius(y): |p|^2 - radius^2 is quadratic in t. Seen steeply it is so outside
  /// its roots, on one of the cone's two halves, and only one of them lies between the caps.
  Span side_span(const LocalRay& ray, const Span& caps) const {
    const double dy = ray.direction.y;
    const Vec3d across{ray.direction.x, 0, ray.direction.z};
    const double reach = 2 * (half_ + greatest(bottom_, top_));
    const double shift = clamp(-ratio(dot(ray.origin, across), dot(across, across)), -reach, reach);
    const Vec3d base = ray.at(shift), off{base.x, 0, base.z};
    const double radius = middle_ + slope_ * base.y;
    const double a = dot(across, across) - slope_ * slope_ * dy * dy, b = dot(off, across) - slope_ * dy * radius,
                 c = (length(off) - radius) * (length(off) + radius);
    const Roots r = roots(a, b, c);
    const double first = r.first + shift, second = r.second + shift;
    const auto clipped = [&](double from, double to) {
      return Span{greatest(caps.enter, from), least(caps.leave, to)};
    };
    if (!r.real) return a < 0 || (a == 0 && c <= 0) ? caps : Span{};
    if (a > 0) return clipped(first, second);
    if (a == 0) return b > 0 ? clipped(-infinity, first) : b < 0 ? clipped(first, infinity) : caps;
    const Span before = clipped(-infinity, first);
    return before.enter <= before.leave ? before : clipped(second, infinity);
  }

  Vec3d normal_at(const LocalRay& ray, double enter, double cap) const {
    if (enter == cap) return {0, ray.direction.y > 0 ? -1.0 : 1.0, 0};
    const Vec3d p = ray.at(enter);
    const double rho = length(Vec3d{p.x, 0, p.z});
    if (!(rho > 8 * epsilon * (half_ + bottom_ + top_))) {  // the tip, or a needle
      const double y = top_ < bottom_ ? 1 : -1, steep = std::abs(slope_);
      if (top_ == bottom_) return facing_back(ray, {0, 1, 0});
      return tip_normal(ray, {0, y, 0}, steep / std::sqrt(1 + steep * steep));
    }
    return normalized(Vec3d{p.x / rho, -slope_, p.z / rho});
  }

  double half_, bottom_, top_, slope_, middle_;
};

/// An ellipsoid with one radius of zero, `flat`.
inline MaybeHit hit_ellipse(const LocalRay& ray, const Vec3d& radii, std::size_t flat) {
  const std::size_t u = (flat + 1) % 3, v = (flat + 2) % 3;
  if (ray.direction[flat] == 0 && ray.origin[flat] != 0) return {};
  const auto scaled_down = [&](const Vec3d& p) { return Vec3d{p[u] / radii[u], p[v] / radii[v], 0}; };
  Vec3d normal;
  if (ray.direction[flat] != 0) {
    const double t = -ray.origin[flat] / ray.direction[flat];
    normal[flat] = ray.direction[flat] > 0 ? -1 : 1;
    if (!(length(scaled_down(ray.at(t))) <= 1) || t < ray.begin || t > ray.end) return {};
    return hit_at(ray, t, normal);
  }
  // As for the ball: the quadratic's coefficients would cancel where the ellipse is thin and the ray begins far from
  // it.
  const Vec3d d = scaled_down(ray.direction);
  const double speed = length(d);
  const Span span = ball_span({scaled_down(ray.origin), d / speed, 0, 0, 0}, {}, 1);
  if (!(span.enter <= span.leave)) return {};
  const Vec3d p = ray.at(span.enter / speed);
  normal[u] = p[u] / (radii[u] * radii[u]);
  normal[v] = p[v] / (radii[v] * radii[v]);
  return entered(ray, span.enter / speed, span.leave / speed, normalized(normal, -ray.direction));
}

/// In the space where it is the unit ball; t is the same there.
inline MaybeHit hit_ellipsoid(const LocalRay& far, const Vec3d& radii) {
  std::size_t zeros = 0, flat = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (radii[i] <= 0) {
      ++zeros;
      flat = i;
    }
  if (zeros >= 2) return hit_balls(far, -radii, 0, radii, 0);
  const Recentered near = recentered(far, {});
  const LocalRay& ray = near.ray;
  if (zeros == 1) return near.restored(hit_ellipse(ray, radii, flat));
  const auto scaled_down = [&](const Vec3d& p) { return Vec3d{p.x / radii.x, p.y / radii.y, p.z / radii.z}; };
  const Vec3d o = scaled_down(ray.origin), d = scaled_down(ray.direction);
  const double speed = length(d);
  const Vec3d unit = d / speed;
  const Span span = ball_span({o, unit, 0, 0, 0}, {}, 1);
  const double enter = span.enter / speed;
  const Vec3d normal = normalized(scaled_down(scaled_down(ray.at(enter))), -ray.direction);
  return near.restored(entered(ray, enter, span.leave / speed, normal));
}

}  // namespace graze::rays
