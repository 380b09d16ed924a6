// Point against segment: sphere against capsule.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core.hpp"

namespace graze {

/// A point on the segment gets a normal across it.
template <class S>
CoreDistance<S> core_distance(const PointCore<S>& a, const SegmentCore<S>& b) {
  const Vec3<S> across = any_perpendicular(normalized(b.segment.b - b.segment.a));
  const S noise = S(4) * epsilon<S> * (max_abs(a.point) + max_abs(b.segment.a) + max_abs(b.segment.b));
  return between(a.point, closest_point(b.segment, a.point), across, noise);
}

}  // namespace graze
