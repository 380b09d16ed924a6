// Rays against the ball and the convex hull of two balls (capsules, untapered or tapered), one ray or one in each lane.
//
// Guarantee: closed forms. A radius of zero is replaced by the ray's blur: a point or a segment is met when the ray
// passes it as closely as its own numbers are known.
#pragma once

#include "graze/geometry.hpp"
#include "rays/local_ray.hpp"

namespace graze::rays {

/// The opposite of the ray's direction, made perpendicular to a unit vector: the normal of a thin segment or needle.
inline Vec3d facing_back(const LocalRay& ray, const Vec3d& along) {
  return normalized(along * dot(ray.direction, along) - ray.direction, -ray.direction);
}

/// A normal of a cone's tip that faces the ray: back along the ray where that supports the cone, else the side's normal
/// nearest to it. `outward` points along the axis out of the cone, `sine` is the component along it of the side's
/// normals.
inline Vec3d tip_normal(const LocalRay& ray, const Vec3d& outward, double sine) {
  const double along = -dot(ray.direction, outward);
  if (along >= sine) return -ray.direction;
  const Vec3d across = normalized(-ray.direction - outward * along, any_perpendicular(outward));
  return outward * sine + across * std::sqrt((1 - sine) * (1 + sine));
}

/// The part of a ray in a solid; empty where `enter` is not the lesser.
template <class S>
struct SpanOf {
  S enter = infinity, leave = -infinity;

  [[gnu::always_inline]] friend SpanOf select(const MaskOf<S>& condition, const SpanOf& yes, const SpanOf& no) {
    return {select(condition, yes.enter, no.enter), select(condition, yes.leave, no.leave)};
  }
};
using Span = SpanOf<double>;

/// The part of a ray within `radius` of a point; from the distance of the centre and not a difference of squares, which
/// cancels.
template <class S>
[[gnu::always_inline]] inline SpanOf<S> ball_span(const LocalRayOf<S>& ray, const std::type_identity_t<Vec3<S>>& center,
                                                  const std::type_identity_t<S>& radius) {
  using std::sqrt;
  const Vec3<S> to = center - ray.origin;
  const S along = dot(to, ray.direction), across = length(to - ray.direction * along);
  const MaskOf<S> met = across <= radius;
  if (alone(!met)) return {};
  const S half = sqrt((radius - across) * (radius + across));
  return select(met, SpanOf<S>{along - half, along + half}, SpanOf<S>{});
}

/// The hit of a ball with a radius above zero.
template <class S>
[[gnu::always_inline]] inline FoundHit<S> hit_ball(const LocalRayOf<S>& far, const Vec3<S>& center, const S& radius) {
  const RecenteredOf<S> near = recentered(far, center);
  const LocalRayOf<S>& ray = near.ray;
  const SpanOf<S> span = ball_span(ray, center, radius);
  if (alone(!(span.enter <= span.leave))) return {};
  const Vec3<S> normal = normalized(ray.at(span.enter) - center, -ray.direction);
  FoundHit<S> found = entered(ray, span.enter, span.leave, normal);
  // `entered` implies it. Without this line g++ 12 clears a `FoundHit` in memory, which costs lanes 40 % of their time.
  found.hit = found.hit & (span.enter <= span.leave);
  return near.restored(found);
}

/// The hit of a ball, or of a point where the radius is zero.
inline MaybeHit hit_sphere(const LocalRay& ray, const Vec3d& center, double radius) {
  FoundHit<double> found = hit_ball(ray, center, radius > 0 ? radius : ray.blur);
  if (!(radius > 0)) found.normal = -ray.direction;
  return found;
}

/// The hit of a segment without thickness: the ray's point nearest to it, where that is near enough.
inline MaybeHit hit_thin_segment(const LocalRay& far, const Vec3d& a, const Vec3d& b) {
  const Recentered near = recentered(far, (a + b) * 0.5);
  const LocalRay& ray = near.ray;
  const double size = length(b - a), thick = ray.blur + 4 * epsilon * size;
  const Vec3d along = normalized(b - a);
  const double t0 = dot(a - ray.origin, ray.direction), t1 = dot(b - ray.origin, ray.direction);
  const double low = clamp(least(t0, t1), ray.begin, ray.end), high = clamp(greatest(t0, t1), low, ray.end);
  double t = low;  // for a ray along the segment, its beginning
  if (length(cross(ray.direction, along)) * size > thick)
    t = low + (high - low) * closest_parameters<double>({ray.at(low), ray.at(high)}, {a, b}).s;
  if (length(closest_point<double>({a, b}, ray.at(t)) - ray.at(t)) > thick) return {};
  return near.restored(hit_at(ray, t, facing_back(ray, along)));
}

/// The convex hull of a ball about `a` and one about `b`, neither inside the other: the side is the cone cosine * rho +
/// sine * y = radius_a, y along the axis from `a` and rho across it, between the circles where it touches the balls.
struct BallCone {
  Vec3d a, b;
  double radius_a, radius_b, height, size;
  Vec3d axis;
  double sine, cosine;

  BallCone(const Vec3d& center_a, double first_radius, const Vec3d& center_b, double second_radius)
      : a(center_a),
        b(center_b),
        radius_a(first_radius),
        radius_b(second_radius),
        height(length(b - a)),
        size(height + radius_a + radius_b),
        axis((b - a) / height),
        sine((radius_a - radius_b) / height),
        cosine(std::sqrt((1 - sine) * (1 + sine))) {}

  /// The position, along the axis from `a`, of the inscribed sphere nearest to `p`.
  template <class S>
  [[gnu::always_inline]] S sphere_place(const Vec3<S>& p) const {
    const Vec3<S> from = p - converted<S>(a), along = converted<S>(axis);
    const S y = dot(from, along);
    return clamp(y - S(sine) * length(from - along * y) / S(cosine), S(0), S(height));
  }

  /// The normal at a point `p` where the radius is mere rounding.
  Vec3d thin_normal(const LocalRay& ray, const Vec3d& p) const {
    const double place = sphere_place(p);
    if (place <= 0) return tip_normal(ray, -axis, -sine);
    if (place >= height) return tip_normal(ray, axis, sine);
    return facing_back(ray, axis) * cosine + axis * sine;
  }
};

/// Calls `crossed(mask, t)` twice, for the intersections of the ray's line with the side of a `BallCone`.
template <class S, class F>
[[gnu::always_inline]] inline void cross_side(const LocalRayOf<S>& ray, const BallCone& cone, const F& crossed) {
  const Vec3<S> axis = converted<S>(cone.axis), from = ray.origin - converted<S>(cone.a);
  const S sine(cone.sine), radius(cone.radius_a), size(cone.size), c2(cone.cosine * cone.cosine);
  const S dy = dot(ray.direction, axis);
  const Vec3<S> across = ray.direction - axis * dy;
  // From the point nearest to the axis, so that a thin long capsule's radius is not lost in its length.
  const S shift = clamp(-ratio(dot(from, across), dot(across, across)), -size, size);
  const Vec3<S> base = from + ray.direction * shift;
  const S y = dot(base, axis);
  const Vec3<S> off = base - axis * y;
  const S rest = radius - sine * y;
  const RootsOf<S> r = roots(c2 * dot(across, across) - sine * sine * dy * dy, c2 * dot(off, across) + sine * dy * rest,
                             c2 * dot(off, off) - rest * rest);
  if (alone(!r.real)) return;
  const S low(cone.sine * cone.radius_a), high(cone.height + cone.sine * cone.radius_b);
  for (const S& t : {r.first, r.second}) {
    const S at = y + t * dy;
    crossed(r.real & (at >= low) & (at <= high), t + shift);
  }
}

/// The hit of a `BallCone`. The normal is undecided where the radius is mere rounding: see `thin_normal`.
template <class S>
[[gnu::always_inline]] inline FoundHit<S> hit_ball_cone(const LocalRayOf<S>& far, const BallCone& cone) {
  const Vec3<S> a = converted<S>(cone.a), b = converted<S>(cone.b);
  const RecenteredOf<S> near = recentered(far, converted<S>((cone.a + cone.b) * 0.5));
  const LocalRayOf<S>& ray = near.ray;
  // The balls and the side between them make up a convex body, so that the ray is in it from the first entry into one
  // of them to the last exit. From the whole span and not from the entries after its beginning: a ray that begins on
  // the surface may find its entry behind it by rounding.
  SpanOf<S> span = ball_span(ray, a, cone.radius_a);
  const auto include = [&](const SpanOf<S>& part) __attribute__((always_inline)) {
    span = {least(span.enter, part.enter), greatest(span.leave, part.leave)};
  };
  include(ball_span(ray, b, cone.radius_b));
  cross_side(
      ray, cone, [&](const MaskOf<S>& crossed, const S& t) __attribute__((always_inline)) {
        include(select(crossed, SpanOf<S>{t, t}, SpanOf<S>{}));
      });
  if (alone(!(span.enter <= span.leave))) return {};
  const Vec3<S> p = ray.at(span.enter), out = p - (a + converted<S>(cone.axis) * cone.sphere_place(p));
  FoundHit<S> found = entered(ray, span.enter, span.leave, normalized(out));
  found.undecided = found.hit & (span.enter > ray.begin) & !(length(out) > S(8 * epsilon * cone.size));
  return near.restored(found);
}

/// The hit of the convex hull of two balls, one of which may contain the other.
inline MaybeHit hit_balls(const LocalRay& ray, const Vec3d& a, double radius_a, const Vec3d& b, double radius_b) {
  if (length(b - a) <= std::abs(radius_a - radius_b) || a == b)
    return radius_a >= radius_b ? hit_sphere(ray, a, radius_a) : hit_sphere(ray, b, radius_b);
  if (radius_a <= 0 && radius_b <= 0) return hit_thin_segment(ray, a, b);
  const BallCone cone(a, radius_a, b, radius_b);
  FoundHit<double> found = hit_ball_cone(ray, cone);
  if (found.undecided) [[unlikely]]
    found.normal = cone.thin_normal(ray, found.point);
  return found;
}

}  // namespace graze::rays
