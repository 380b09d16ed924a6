// Point against segment: sphere against capsule.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core.hpp"

namespace graze {

/// A point on the segment gets a normal across it.
template <class S>
CoreDistance<S> core_distance(const PointCore<S>& a, const SegmentCore<S>& b) {
  const Vec3<S> nearest = closest_point(b.segment, a.point);
  const S noise = S(4) * epsilon<S> * (max_abs(a.point) + max_abs(b.segment.a) + max_abs(b.segment.b));
  const auto on_segment = length_squared(nearest - a.point) <= noise * noise;
  Vec3<S> across{S(0), S(0), S(0)};
  if (any(on_segment)) across = select(on_segment, any_perpendicular(normalized(b.segment.b - b.segment.a)), across);
  return between(a.point, nearest, across, noise);
}

}  // namespace graze
