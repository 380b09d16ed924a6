// Point against point: sphere against sphere.
#pragma once

#include "narrow/core/core.hpp"

namespace graze {

template <class S>
CorePoints<S> nearest_points(const PointCore<S>& a, const PointCore<S>& b) {
  return {a.point, b.point};
}

/// The distance of two points, with the normal (c2 - c1) / |c2 - c1|; coincident centres get +Y, since all are equal.
template <class S>
CoreDistance<S> core_distance(const PointCore<S>&, const PointCore<S>&, const CorePoints<S>& nearest) {
  return between(nearest.a, nearest.b, {S(0), S(1), S(0)}, S(0));
}

/// Whether two balls touch, without a square root: |c2 - c1|^2 <= (r1 + r2)^2.
template <class S>
auto spheres_overlap(const Vec3<S>& c1, const S& r1, const Vec3<S>& c2, const S& r2) {
  const S r = r1 + r2;
  return length_squared(c2 - c1) <= r * r;
}

}  // namespace graze
