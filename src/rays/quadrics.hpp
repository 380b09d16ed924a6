// Rays against cylinders, cones and ellipsoids without rounding radius, one ray or one in each lane.
//
// Guarantee: closed forms; sizes of zero give discs, ellipses, segments and points.
#pragma once

#include "rays/round.hpp"

namespace graze::rays {

/// The solid |y| <= half, rho <= radius(y), the radius linear in y from `bottom` to `top`.
struct Frustum {
  double half, bottom, top, slope, middle;

  Frustum(double half_height, double radius_bottom, double radius_top)
      : half(half_height),
        bottom(radius_bottom),
        top(radius_top),
        slope(half > 0 ? (top - bottom) / (2 * half) : 0),
        middle(half > 0 ? (top + bottom) / 2 : greatest(top, bottom)) {}

  /// The normal of the side where the radius is mere rounding: at the tip, or of a needle.
  Vec3d thin_normal(const LocalRay& ray) const {
    if (top == bottom) return facing_back(ray, {0, 1, 0});
    const double y = top < bottom ? 1 : -1, steep = std::abs(slope);
    return tip_normal(ray, {0, y, 0}, steep / std::sqrt(1 + steep * steep));
  }
};

/// The part of the ray between the planes of the caps.
template <class S>
[[gnu::always_inline]] inline SpanOf<S> caps_span(const LocalRayOf<S>& ray, const S& half) {
  using std::abs;
  const S y = ray.origin.y, dy = ray.direction.y, t0 = (-half - y) / dy, t1 = (half - y) / dy;
  const MaskOf<S> level = dy == S(0);
  if (!any(level)) return {least(t0, t1), greatest(t0, t1)};
  return select(level, select(abs(y) <= half, SpanOf<S>{S(-infinity), S(infinity)}, SpanOf<S>{}),
                SpanOf<S>{least(t0, t1), greatest(t0, t1)});
}

/// The part of `caps` in which rho <= radius(y): |p|^2 - radius^2 is quadratic in t. For a steep ray that part is
/// outside the roots, on one of the cone's two nappes, and only one of these lies between the caps.
template <class S>
[[gnu::always_inline]] inline SpanOf<S> side_span(const LocalRayOf<S>& ray, const Frustum& f, const SpanOf<S>& caps) {
  const S zero(0), slope(f.slope), dy = ray.direction.y, reach(2 * (f.half + greatest(f.bottom, f.top)));
  const Vec3<S> across{ray.direction.x, zero, ray.direction.z};
  const S shift = clamp(-ratio(dot(ray.origin, across), dot(across, across)), -reach, reach);
  const Vec3<S> base = ray.at(shift), off{base.x, zero, base.z};
  const S radius = S(f.middle) + slope * base.y, rho = length(off);
  const S a = dot(across, across) - slope * slope * dy * dy, b = dot(off, across) - slope * dy * radius,
          c = (rho - radius) * (rho + radius);
  const RootsOf<S> r = roots(a, b, c);
  const S first = r.first + shift, second = r.second + shift;
  const auto clipped = [&](const S& from, const S& to) __attribute__((always_inline)) {
    return SpanOf<S>{greatest(caps.enter, from), least(caps.leave, to)};
  };
  const MaskOf<S> level = a == zero;
  const SpanOf<S> outside = select((a < zero) | (level & (c <= zero)), caps, SpanOf<S>{}),
                  between = clipped(first, second);
  if (alone(!r.real)) return outside;
  if (alone(a > zero)) return between;
  const SpanOf<S> before = clipped(S(-infinity), first), behind = clipped(second, S(infinity)),
                  steep = select(before.enter <= before.leave, before, behind),
                  linear = select(b > zero, before, select(b < zero, clipped(first, S(infinity)), caps));
  return select(r.real, select(a > zero, between, select(level, linear, steep)), outside);
}

/// The hit of a frustum that has some thickness. The normal is undecided where the radius is mere rounding:
/// `Frustum::thin_normal`.
template <class S>
[[gnu::always_inline]] inline FoundHit<S> hit_frustum(const LocalRayOf<S>& far, const Frustum& f) {
  const RecenteredOf<S> near = recentered(far, {});
  const LocalRayOf<S>& ray = near.ray;
  const SpanOf<S> caps = caps_span(ray, S(f.half));
  if (alone(!(caps.enter <= caps.leave))) return {};
  const SpanOf<S> in = side_span(ray, f, caps);
  if (alone(!(in.enter <= in.leave))) return {};
  const S zero(0), one(1);
  const Vec3<S> p = ray.at(in.enter);
  const S rho = length(Vec3<S>{p.x, zero, p.z});
  const S clear(8 * epsilon * (f.half + f.bottom + f.top));
  const MaskOf<S> by_cap = in.enter == caps.enter, thin = (!by_cap) & !(rho > clear);
  Vec3<S> normal{zero, select(ray.direction.y > zero, -one, one), zero};
  if (!alone(by_cap)) normal = select(by_cap, normal, normalized(Vec3<S>{p.x / rho, S(-f.slope), p.z / rho}));
  FoundHit<S> found = entered(ray, in.enter, in.leave, normal);
  found.hit = found.hit & (caps.enter <= caps.leave);
  found.undecided = found.hit & (in.enter > ray.begin) & thin;
  return near.restored(found);
}

/// The hit of a frustum, or of a segment where it has no thickness.
inline MaybeHit hit_cylinder(const LocalRay& ray, const Frustum& f) {
  if (f.bottom <= 0 && f.top <= 0) return hit_balls(ray, {0, -f.half, 0}, 0, {0, f.half, 0}, 0);
  FoundHit<double> found = hit_frustum(ray, f);
  if (found.undecided) [[unlikely]]
    found.normal = f.thin_normal(ray);
  return found;
}

/// The hit of an ellipsoid with one zero radius, that of axis `flat`.
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
  // By distances as for the ball: the quadratic's coefficients would cancel where the ellipse is thin and the ray
  // begins far from it.
  const Vec3d d = scaled_down(ray.direction);
  const double speed = length(d);
  const Span span = ball_span(LocalRay{scaled_down(ray.origin), d / speed, 0, 0, 0}, {}, 1);
  if (!(span.enter <= span.leave)) return {};
  const Vec3d p = ray.at(span.enter / speed);
  normal[u] = p[u] / (radii[u] * radii[u]);
  normal[v] = p[v] / (radii[v] * radii[v]);
  return entered(ray, span.enter / speed, span.leave / speed, normalized(normal, -ray.direction));
}

/// The hit of an ellipsoid with all radii above zero, in the space where it is the unit ball; t is the same there.
template <class S>
[[gnu::always_inline]] inline FoundHit<S> hit_solid_ellipsoid(const LocalRayOf<S>& far, const Vec3<S>& radii) {
  const RecenteredOf<S> near = recentered(far, {});
  const LocalRayOf<S>& ray = near.ray;
  const auto scaled_down = [&](const Vec3<S>& p) __attribute__((always_inline)) {
    return Vec3<S>{p.x / radii.x, p.y / radii.y, p.z / radii.z};
  };
  const Vec3<S> origin = scaled_down(ray.origin), direction = scaled_down(ray.direction);
  const S speed = length(direction);
  const SpanOf<S> span = ball_span(LocalRayOf<S>{origin, direction / speed, {}, {}, {}}, {}, S(1));
  if (alone(!(span.enter <= span.leave))) return {};
  const S enter = span.enter / speed;
  const Vec3<S> normal = normalized(scaled_down(scaled_down(ray.at(enter))), -ray.direction);
  FoundHit<S> found = entered(ray, enter, span.leave / speed, normal);
  found.hit = found.hit & (span.enter <= span.leave);
  return near.restored(found);
}

/// The hit of an ellipsoid; with zero radii an ellipse, a segment or a point.
inline MaybeHit hit_ellipsoid(const LocalRay& far, const Vec3d& radii) {
  std::size_t zeros = 0, flat = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (radii[i] <= 0) {
      ++zeros;
      flat = i;
    }
  if (zeros >= 2) return hit_balls(far, -radii, 0, radii, 0);
  if (zeros == 0) return hit_solid_ellipsoid(far, radii);
  const Recentered near = recentered(far, {});
  return near.restored(hit_ellipse(near.ray, radii, flat));
}

}  // namespace graze::rays
