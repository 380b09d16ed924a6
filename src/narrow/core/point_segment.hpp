// Point against segment: sphere against capsule.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core/core.hpp"

namespace graze {

template <class S>
CorePoints<S> nearest_points(const PointCore<S>& a, const SegmentCore<S>& b) {
  return {a.point, closest_point(b.segment, a.point)};
}
template <class S>
CorePoints<S> nearest_points(const PointCore<S>& a, const TurnedAxis<S>& b) {
  return {a.point, b.at(b.within(dot(a.point - b.middle, b.axis)))};
}

namespace detail {

/// The distance with its normal perpendicular to the segment, or outward from its end, where the point is near.
template <class S>
CoreDistance<S> settled(CoreDistance<S> d, const Segment<S>& segment, const S& size) {
  const auto close = d.distance < size * S(near_part);
  if (!any(close)) return d;
  d.normal = select(close, renormalized(-leaving(-d.normal, segment, d.b), d.normal), d.normal);
  return d;
}

/// The distance; a point on the segment, whose axis `axis()` returns, gets a normal perpendicular to it.
template <class S, class Axis>
CoreDistance<S> between_point_and_segment(const CorePoints<S>& nearest, const S& noise, const Axis& axis) {
  const auto on_segment = length_squared(nearest.b - nearest.a) <= noise * noise;
  Vec3<S> across{S(0), S(0), S(0)};
  if (any(on_segment)) across = select(on_segment, any_perpendicular(axis()), across);
  return between(nearest.a, nearest.b, across, noise);
}

}  // namespace detail

template <class S>
CoreDistance<S> core_distance(const PointCore<S>& a, const SegmentCore<S>& b, const CorePoints<S>& nearest) {
  const S size = max_abs(a.point) + max_abs(b.segment.a) + max_abs(b.segment.b);
  const S noise = S(4) * epsilon<S> * size + b.error;
  const auto axis = [&] { return normalized(b.segment.b - b.segment.a); };
  return detail::settled(detail::between_point_and_segment(nearest, noise, axis), b.segment, size);
}
template <class S>
CoreDistance<S> core_distance(const PointCore<S>& a, const TurnedAxis<S>& b, const CorePoints<S>& nearest) {
  const S noise = S(4) * epsilon<S> * (max_abs(a.point) + S(2) * (max_abs(b.middle) + b.half));
  return detail::between_point_and_segment(nearest, noise, [&] { return b.axis; });
}

}  // namespace graze
