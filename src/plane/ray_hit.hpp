// A ray against a convex core.
//
// Guarantee: the first point of the rounded core on the ray, 0 where the origin lies in it. Polygons, and with them
// circles, segments, boxes and capsules, in closed form; watertight: a ray through the vertex of two edges meets one.
#pragma once

#include <optional>

#include "plane/core.hpp"
#include "plane/nearest.hpp"

namespace graze::plane {

struct CoreRayHit {
  double t = 0;
  Vec2d normal{};  ///< in the core's frame; minus the direction where the origin lies inside
  Status status = Status::converged;
};

/// The first hit up to `until`. `direction` of unit length, both in the core's frame. Curved cores count as hit from
/// `near` on.
template <class T>
std::optional<CoreRayHit> ray_hit(const Core<T>& core, const Vec2d& origin, const Vec2d& direction, double until,
                                  double size, double near);

}  // namespace graze::plane
