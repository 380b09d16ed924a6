// Segment against segment: capsule against capsule.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core.hpp"

namespace graze {

/// Crossing segments get the normal of the plane they span; overlapping parallel ones a normal across them.
template <class S>
CoreDistance<S> core_distance(const SegmentCore<S>& a, const SegmentCore<S>& b) {
  const auto [s, t] = closest_parameters(a.segment, b.segment);
  const Vec3<S> u = normalized(a.segment.b - a.segment.a), v = normalized(b.segment.b - b.segment.a);
  const Vec3<S> longer =
      select(length_squared(a.segment.b - a.segment.a) < length_squared(b.segment.b - b.segment.a), v, u);
  const Vec3<S> n = cross(u, v);
  const Vec3<S> across = select(length_squared(n) > epsilon<S> * epsilon<S>, normalized(n), any_perpendicular(longer));
  const S noise =
      S(8) * epsilon<S> * (max_abs(a.segment.a) + max_abs(a.segment.b) + max_abs(b.segment.a) + max_abs(b.segment.b));
  return between(point_at(a.segment, s), point_at(b.segment, t), across, noise);
}

}  // namespace graze
