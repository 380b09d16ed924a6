// Point against box: sphere against box.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core/core.hpp"

namespace graze {

template <class S>
CorePoints<S> nearest_points(const BoxCore<S>& a, const PointCore<S>& b) {
  return {closest_point_in_box(a.half, b.point), b.point};
}

/// The distance of a point from a box, which is A. A point inside leaves by the nearest face, the first of equal ones.
template <class S>
CoreDistance<S> core_distance(const BoxCore<S>& a, const PointCore<S>&, const CorePoints<S>& nearest) {
  const Vec3<S> p = nearest.b, inside = nearest.a;
  const Vec3<S> v = p - inside;
  const auto outside = (v.x != S(0)) | (v.y != S(0)) | (v.z != S(0));
  const S distance = length(v);
  if (all(outside)) return {distance, direction_of(v, distance), inside, p};

  const Vec3<S> depth = a.half - abs(p);
  const Vec3<S> sign{select(p.x < S(0), S(-1), S(1)), select(p.y < S(0), S(-1), S(1)), select(p.z < S(0), S(-1), S(1))};
  const auto y_less = depth.y < depth.x;
  const S least_xy = select(y_less, depth.y, depth.x);
  const auto z_less = depth.z < least_xy;
  const S least_depth = select(z_less, depth.z, least_xy);
  const S zero(0);
  const Vec3<S> nx{sign.x, zero, zero}, ny{zero, sign.y, zero}, nz{zero, zero, sign.z};
  const Vec3<S> face = select(z_less, nz, select(y_less, ny, nx));
  return {select(outside, distance, -least_depth), select(outside, direction_of(v, distance), face),
          select(outside, inside, p + face * least_depth), p};
}

}  // namespace graze
