// Rays against capsules, cylinders, cones and ellipsoids, several at a time: `BallCone` (`round.hpp`), `Frustum` and
// `hit_ellipsoid` (`quadrics.hpp`), with choices in place of branches. Only for `*.kernel.cpp`.
//
// Guarantee: as `ray_block.hpp`. Rays at a tip or at an axis without thickness are left to the code for one.
#pragma once

#include "rays/ray_lanes.hpp"

namespace graze::GRAZE_ISA::ray_lanes {

inline constexpr double epsilon = 0x1p-52;

struct Spans {
  S enter, leave;

  [[gnu::always_inline]] friend Spans select(const M& condition, const Spans& yes, const Spans& no) {
    return {select(condition, yes.enter, no.enter), select(condition, yes.leave, no.leave)};
  }
};
[[gnu::always_inline]] inline Spans no_span() { return {S(infinity), S(-infinity)}; }

[[gnu::always_inline]] inline Spans ball_span(const V& origin, const V& direction, const V& center, const S& radius) {
  const V to = center - origin;
  const S along = dot(to, direction), across = length(to - direction * along);
  const S half = sqrt((radius - across) * (radius + across));
  return select(across <= radius, Spans{along - half, along + half}, no_span());
}

[[gnu::always_inline]] inline S clamp(const S& value, const S& low, const S& high) {
  return greatest(low, least(value, high));
}
[[gnu::always_inline]] inline S ratio(const S& numerator, const S& denominator) {
  const M positive = denominator > S(0);
  return select(positive, numerator / select(positive, denominator, S(1)), S(0));
}

/// With the sign of the other, of zero too.
[[gnu::always_inline]] inline S with_sign(const S& size, const S& sign) {
  using Bits = S::BitVector;
  const Bits one = Bits{} + S::Bits(0x8000000000000000u);
  return S::of(
      reinterpret_cast<S::Vector>(reinterpret_cast<Bits>(abs(size).v) | (reinterpret_cast<Bits>(sign.v) & one)));
}

struct RootPairs {
  M real;
  S first, second;
};
[[gnu::always_inline]] inline RootPairs roots(const S& a, const S& b, const S& c) {
  const S zero(0), under = b * b - a * c, q = -(b + with_sign(sqrt(under), b));
  const M none = q == zero, linear = a == zero;
  const S one = c / q, other = select(linear, one, q / a);
  return {(under >= zero) & (!(none & linear)), select(none, zero, least(one, other)),
          select(none, zero, greatest(one, other))};
}

/// Between two balls, neither inside the other; `radius` is that of the one about the first point.
[[gnu::always_inline]] inline Hits hit_ball_cone(Rays ray, const rays::BlockShape& shape) {
  const V a = V::all(shape.points[0]), b = V::all(shape.points[1]);
  const S radius_a(shape.radius), radius_b(shape.other_radius), zero(0);
  const S height = length(b - a);
  const V axis = (b - a) / height;
  const S sine = (radius_a - radius_b) / height, cosine = sqrt((S(1) - sine) * (S(1) + sine));
  const S size = height + radius_a + radius_b;
  const S shift = ray.recenter((a + b) * S(0.5));

  Spans span = ball_span(ray.origin, ray.direction, a, radius_a);
  const auto include = [&](const S& enter, const S& leave) __attribute__((always_inline)) {
    span = {least(span.enter, enter), greatest(span.leave, leave)};
  };
  const Spans other = ball_span(ray.origin, ray.direction, b, radius_b);
  include(other.enter, other.leave);

  const S dy = dot(ray.direction, axis);
  const V across = ray.direction - axis * dy, from = ray.origin - a;
  const S nearer = clamp(-ratio(dot(from, across), dot(across, across)), -size, size);
  const V base = from + ray.direction * nearer;
  const S y = dot(base, axis);
  const V off = base - axis * y;
  const S rest = radius_a - sine * y, c2 = cosine * cosine;
  const RootPairs r = roots(c2 * dot(across, across) - sine * sine * dy * dy, c2 * dot(off, across) + sine * dy * rest,
                            c2 * dot(off, off) - rest * rest);
  const auto include_side = [&](const S& t) __attribute__((always_inline)) {
    const S at = y + t * dy;
    const M side = r.real & (at >= sine * radius_a) & (at <= height + sine * radius_b);
    include(select(side, t + nearer, S(infinity)), select(side, t + nearer, S(-infinity)));
  };
  include_side(r.first);
  include_side(r.second);

  const V p = ray.at(span.enter);
  const S up = dot(p - a, axis);
  const S place = clamp(up - sine * length(p - a - axis * up) / cosine, zero, height);
  const V out = p - (a + axis * place);
  const M clear = length(out) > S(8 * epsilon) * size;
  Hits hits =
      entered(ray, shift, span.enter <= span.leave, span.enter, span.leave, normalized(out, V{zero, S(1), zero}));
  hits.again = hits.hit & (span.enter > ray.begin) & (!clear);
  return hits;
}

/// `radius` is that of the lower end, and half the height the second number of the first point.
[[gnu::always_inline]] inline Hits hit_frustum(Rays ray, const rays::BlockShape& shape) {
  const double half_height = shape.points[0][1], bottom = shape.radius, top = shape.other_radius;
  const S zero(0), one(1), half(half_height), slope(half_height > 0 ? (top - bottom) / (2 * half_height) : 0),
      middle(half_height > 0 ? (top + bottom) / 2
             : bottom < top  ? top
                             : bottom);
  const S shift = ray.recenter({zero, zero, zero});

  const S y = ray.origin.y, dy = ray.direction.y, t0 = (-half - y) / dy, t1 = (half - y) / dy;
  const M level = dy == zero;
  const Spans caps = select(level, select(abs(y) <= half, Spans{S(-infinity), S(infinity)}, no_span()),
                            Spans{least(t0, t1), greatest(t0, t1)});

  const V across{ray.direction.x, zero, ray.direction.z};
  const S reach(2 * (half_height + (bottom < top ? top : bottom)));
  const S nearer = clamp(-ratio(dot(ray.origin, across), dot(across, across)), -reach, reach);
  const V base = ray.at(nearer), off{base.x, zero, base.z};
  const S radius = middle + slope * base.y;
  const S a = dot(across, across) - slope * slope * dy * dy, b = dot(off, across) - slope * dy * radius,
          c = (length(off) - radius) * (length(off) + radius);
  const RootPairs r = roots(a, b, c);
  const S first = r.first + nearer, second = r.second + nearer;
  const auto clipped = [&](const S& from, const S& to) __attribute__((always_inline)) {
    return Spans{greatest(caps.enter, from), least(caps.leave, to)};
  };
  const M flat = a == zero;
  const Spans before = clipped(S(-infinity), first), behind = clipped(second, S(infinity)),
              steep = select(before.enter <= before.leave, before, behind),
              linear = select(b > zero, before, select(b < zero, clipped(first, S(infinity)), caps)),
              outside = select((a < zero) | (flat & (c <= zero)), caps, no_span());
  const Spans in = select(r.real, select(a > zero, clipped(first, second), select(flat, linear, steep)), outside);

  const V p = ray.at(in.enter);
  const S rho = length(V{p.x, zero, p.z});
  const M cap = in.enter == caps.enter, clear = cap | (rho > S(8 * epsilon * (half_height + bottom + top)));
  const V side = normalized(V{p.x / rho, -slope, p.z / rho}, V{zero, one, zero});
  const V normal = select(cap, V{zero, select(dy > zero, -one, one), zero}, side);
  const M met = (caps.enter <= caps.leave) & (in.enter <= in.leave);
  Hits hits = entered(ray, shift, met, in.enter, in.leave, normal);
  hits.again = hits.hit & (in.enter > ray.begin) & (!clear);
  return hits;
}

/// Of the radii in the first point, all above zero.
[[gnu::always_inline]] inline Hits hit_ellipsoid(Rays ray, const rays::BlockShape& shape) {
  const V zero{S(0), S(0), S(0)}, radii = V::all(shape.points[0]);
  const S shift = ray.recenter(zero);
  const auto scaled_down = [&](const V& p) __attribute__((always_inline)) {
    return V{p.x / radii.x, p.y / radii.y, p.z / radii.z};
  };
  const V o = scaled_down(ray.origin), d = scaled_down(ray.direction);
  const S speed = length(d);
  const Spans span = ball_span(o, d / speed, zero, S(1));
  const S enter = span.enter / speed;
  const V normal = normalized(scaled_down(scaled_down(ray.at(enter))), -ray.direction);
  return entered(ray, shift, span.enter <= span.leave, enter, span.leave / speed, normal);
}

}  // namespace graze::GRAZE_ISA::ray_lanes
