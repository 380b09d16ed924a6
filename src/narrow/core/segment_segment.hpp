// Segment against segment: capsule against capsule.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core/core.hpp"

namespace graze {

template <class S>
CorePoints<S> nearest_points(const SegmentCore<S>& a, const SegmentCore<S>& b) {
  const auto [s, t] = closest_parameters(a.segment, b.segment);
  return {point_at(a.segment, s), point_at(b.segment, t)};
}

/// The nearest points of two segments, by the method of `closest_parameters`: from the nearest points of the two lines,
/// one clamped and the other's nearest to it, each in turn. Unit axes leave a single division: the numbers are lengths
/// along them.
template <class S>
CorePoints<S> nearest_points(const TurnedAxis<S>& a, const TurnedAxis<S>& b) {
  const Vec3<S> n = cross(a.axis, b.axis), apart = b.middle - a.middle;
  const S cosine = dot(a.axis, b.axis), along_a = dot(apart, a.axis), along_b = dot(apart, b.axis);
  const S of_lines = a.within(ratio(dot(cross(apart, b.axis), n), dot(n, n)));
  const S t = b.within(cosine * of_lines - along_b), s = a.within(cosine * t + along_a);
  return {a.at(s), b.at(b.within(cosine * s - along_b))};
}

namespace detail {

/// The distance of two segments; crossing ones get the normal of their plane, `n` of any length, overlapping parallel
/// ones a normal perpendicular to their axis, which `axis()` returns.
template <class S, class M, class Axis>
CoreDistance<S> between_segments(const CorePoints<S>& nearest, const Vec3<S>& n, const M& crossing, const S& noise,
                                 const Axis& axis) {
  Vec3<S> across = direction_of(n, length(n));
  if (!all(crossing)) across = select(crossing, across, any_perpendicular(axis()));
  return between(nearest.a, nearest.b, across, noise);
}

/// Makes the normal perpendicular to the features that it leaves, where the segments are near: not for capsules' axes,
/// whose nearness is a depth of both radii, and which would take two fifths longer. Twice, since each correction turns
/// the normal out of the other's plane by less. Out of line, since few segments are so near.
template <class S, class M>
[[gnu::noinline, gnu::cold]] void settle(CoreDistance<S>& d, const Segment<S>& a, const Segment<S>& b, const M& close) {
  Vec3<S> n = d.normal;
  for (int i = 0; i < 2; ++i) n = -leaving(-leaving(n, a, d.a), b, d.b);
  d.normal = select(close, renormalized(n, d.normal), d.normal);
}

}  // namespace detail

// A product of two numbers and a difference round by two roundings of the largest of either: less is no crossing.

template <class S>
CoreDistance<S> core_distance(const SegmentCore<S>& a, const SegmentCore<S>& b, const CorePoints<S>& nearest) {
  const Vec3<S> u = a.segment.b - a.segment.a, v = b.segment.b - b.segment.a, n = cross(u, v);
  const S ends = max_abs(a.segment.a) + max_abs(a.segment.b) + max_abs(b.segment.a) + max_abs(b.segment.b);
  const S noise = S(8) * epsilon<S> * ends + a.error + b.error;
  CoreDistance<S> d =
      detail::between_segments(nearest, n, max_abs(n) > S(2) * epsilon<S> * max_abs(u) * max_abs(v), noise,
                               [&] { return normalized(select(length_squared(u) < length_squared(v), v, u)); });
  if (const auto close = d.distance < ends * S(near_part); any(close)) detail::settle(d, a.segment, b.segment, close);
  return d;
}
template <class S>
CoreDistance<S> core_distance(const TurnedAxis<S>& a, const TurnedAxis<S>& b, const CorePoints<S>& nearest) {
  const Vec3<S> n = cross(a.axis, b.axis);
  const S noise = S(16) * epsilon<S> * (max_abs(a.middle) + a.half + max_abs(b.middle) + b.half);
  return detail::between_segments(nearest, n, max_abs(n) > S(2 * epsilon<S>), noise, [&] { return a.axis; });
}

}  // namespace graze
