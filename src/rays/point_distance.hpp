// Distances of a point from cores with their directions, the steps of conservative advancement.
//
// Guarantee: each is a functor over points of the shape's frame; inside the core the distance is zero.
#pragma once

#include "narrow/core/point_frustum.hpp"
#include "narrow/gjk/gjk.hpp"
#include "rays/conservative_advancement.hpp"

namespace graze::rays {

inline PointDistance distance_between(const Vec3d& core, const Vec3d& p) {
  const Vec3d v = p - core;
  return {length(v), unit(v)};
}

struct DistanceToBox {
  Vec3d half;
  PointDistance operator()(const Vec3d& p) const { return distance_between(closest_point_in_box(half, p), p); }
};

struct DistanceToTriangle {
  Vec3d a, b, c;
  PointDistance operator()(const Vec3d& p) const {
    return distance_between(closest_point_on_triangle(a, b, c, p).point, p);
  }
};

/// The distance from a cylinder, cone or truncated cone.
struct DistanceToFrustum {
  FrustumCore core;
  PointDistance operator()(const Vec3d& p) const {
    const OutwardDistance d = distance_from(core, p);
    return {greatest(d.distance, 0.0), d.normal};
  }
};

/// A point, as the other shape of a Minkowski difference.
struct PointShape {
  Vec3d core_support(const Vec3d&) const { return {}; }
  double core_extent() const { return 0; }
};

/// The distance from any core, by its support function: the supporting plane with which GJK ends.
template <class Core>
struct DistanceBySupport {
  const Core& core;

  PointDistance operator()(const Vec3d& p) const {
    const PointShape point;
    const MinkowskiDifference<Core, PointShape> difference(core, point, {p, {}});
    const GjkResult found = gjk(difference, {rounding_error * difference.reach()});
    if (found.end == GjkEnd::touching || !(found.upper > 0)) return {0, {0, 1, 0}};
    // The plane of the last normal supports the core, whatever rounding did to the normal.
    return {dot(found.normal, p - core.core_support(found.normal)), found.normal};
  }
};

}  // namespace graze::rays
