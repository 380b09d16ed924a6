// Rays against a core plus a ball, given by its distance: van den Bergen 2004, "Ray casting against general convex
// objects with application to continuous collision detection", each step with the core's exact distance.
//
// Along a ray the distance to a convex set is a convex function. Each step goes to where the ray meets the supporting
// plane at the nearest point, which is Newton's method on that function from its left: it never passes the surface, and
// doubles its digits except where the ray grazes, where it gains one binary digit a step.
//
// Guarantee: a plane that the ray does not meet proves a miss; a hit lies within `slack` of the surface, and its normal
// is, among all normals seen, the one beyond whose plane the shape reaches least.
#pragma once

#include "rays/local_ray.hpp"
#include "rays/round.hpp"

namespace graze::rays {

/// A supporting plane of a core: the distance of the queried point outside of it (<= 0 when the point is in the core),
/// and its unit normal.
struct PointDistance {
  double distance;
  Vec3d normal;
};

/// A grazing ray gains one binary digit a step and there are 53; an inexact support function may cost some more.
inline constexpr int advance_steps = 128;

/// The best normal found at a point: among the planes through the point, the one that the core plus its ball crosses
/// least.
struct BestNormal {
  Vec3d normal;
  double beyond = infinity;  ///< extent of the shape beyond the plane

  void consider(const Vec3d& candidate, double crossed) {
    if (!(crossed < beyond)) return;
    beyond = crossed;
    normal = candidate;
  }
};

/// Searches a better normal at `p` from a point that stands off from it: near the core the direction to the nearest
/// point is mere rounding, from afar it is sharp. From p + n h, where n is off by an angle, the nearest point of a core
/// with radius of curvature R is off by only h / (R + h) of that angle: each turn gains.
template <class DistanceAt>
void sharpen(BestNormal& best, const LocalRay& ray, const Vec3d& p, const DistanceAt& distance_at, double radius,
             double size, double slack) {
  static constexpr int turns = 12;  // about as many digits as a normal can use where h = R
  const double off = size / 64;
  for (int i = 0; i < turns && best.beyond > slack; ++i) {
    const Vec3d step = best.normal * off;
    const PointDistance gap = distance_at(p + step);
    const double before = best.beyond;
    if (dot(gap.normal, ray.direction) < 0) best.consider(gap.normal, radius - (gap.distance - dot(gap.normal, step)));
    if (!(best.beyond < before)) return;
  }
}

/// The hit of a core plus a ball. `distance_at(p)` is the `PointDistance` of the core, which lies within `reach` of the
/// frame's origin without its ball of `radius`.
template <class DistanceAt>
MaybeHit hit_rounded(const LocalRay& far, const DistanceAt& distance_at, double radius, double reach, double slack) {
  const Recentered near = recentered(far, {});
  const LocalRay& ray = near.ray;
  const double size = reach + radius;
  // Begins well outside the bounding ball, where the first normal is good even for a shape that is the ball.
  const Span ball = ball_span(ray, {}, 2 * size + ray.blur);
  if (!(ball.enter <= ray.end && ball.leave >= ray.begin)) return {};
  double t = greatest(ball.enter, ray.begin);
  BestNormal best{-ray.direction};
  for (int step = 0; step < advance_steps; ++step) {
    const PointDistance gap = distance_at(ray.at(t));
    const double left = gap.distance - radius;
    if (left <= slack && t <= ray.begin) return near.restored(hit_inside(ray));
    const double toward = -dot(gap.normal, ray.direction);
    // At a core without a ball the last gap is zero and has no normal.
    if (left <= slack && !(gap.distance > slack)) break;
    const double advance = left <= slack ? 0 : left / toward;
    if (left > slack && !(toward > 0)) return {};
    // Beyond a plane that is met at the end of this step the shape does not reach there; further on it does.
    best.beyond += advance * dot(best.normal, -ray.direction);
    if (toward > 0) best.consider(gap.normal, left <= slack ? -left : 0);
    if (left <= slack) break;
    t += advance;
    if (!(t <= ray.end)) return {};
  }
  sharpen(best, ray, ray.at(t), distance_at, radius, size, slack);
  return near.restored(hit_at(ray, t, best.normal));
}

}  // namespace graze::rays
