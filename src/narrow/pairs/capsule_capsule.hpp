// Segment against segment: capsule against capsule.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core.hpp"

namespace graze {

/// Crossing segments get the normal of the plane they span; overlapping parallel ones a normal across them.
template <class S>
CoreDistance<S> core_distance(const SegmentCore<S>& a, const SegmentCore<S>& b) {
  const auto [s, t] = closest_parameters(a.segment, b.segment);
  const Vec3<S> u = a.segment.b - a.segment.a, v = b.segment.b - b.segment.a, n = cross(u, v);
  // A product of two numbers and a difference round by this much.
  const auto crossing = max_abs(n) > S(2) * epsilon<S> * max_abs(u) * max_abs(v);
  Vec3<S> across = direction_of(n, length(n));
  if (!all(crossing)) {
    const Vec3<S> longer = select(length_squared(u) < length_squared(v), v, u);
    across = select(crossing, across, any_perpendicular(normalized(longer)));
  }
  const S noise =
      S(8) * epsilon<S> * (max_abs(a.segment.a) + max_abs(a.segment.b) + max_abs(b.segment.a) + max_abs(b.segment.b));
  return between(point_at(a.segment, s), point_at(b.segment, t), across, noise);
}

}  // namespace graze
