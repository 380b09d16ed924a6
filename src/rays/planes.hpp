// Rays against shapes bounded by planes: half-spaces, boxes and convex hulls, by clipping the ray (Cyrus, Beck 1978,
// "Generalized two- and three-dimensional clipping"; for boxes Kay, Kajiya 1986, "Ray tracing complex scenes").
#pragma once

#include "rays/box_crossing.hpp"
#include "rays/half_space.hpp"
#include "rays/plane_clip.hpp"
#include "rays/ray_triangle.hpp"
#include "rays/round.hpp"

namespace graze::rays {

/// The hit of the box |q_i| <= half_i. With one zero extent a rectangle, with two a segment.
inline MaybeHit hit_box(const LocalRay& far, const Vec3d& half) {
  if ((half.x <= 0) + (half.y <= 0) + (half.z <= 0) >= 2) return hit_balls(far, -half, 0, half, 0);
  Recentered near = recentered(far, {});
  const LocalRay& ray = near.ray;
  const BoxCrossing<double> crossing(ray.origin, ray.direction, half);
  if (!crossing.met()) return {};
  return near.restored(entered(ray, crossing.enter(), crossing.leave(), crossing.normal()));
}

template <class T>
MaybeHit hit_polyhedron(const LocalRay& far, const HullData<T>& hull) {
  const Recentered near = recentered(far, {});
  const LocalRay& ray = near.ray;
  static_assert(sizeof(Plane<T>) == 4 * sizeof(T) && std::is_standard_layout_v<Plane<T>>);
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), clip_by_planes<T>);
  PlaneClip clip;
  kernel(&hull.planes[0].normal.x, hull.planes.size(), {ray.origin.x, ray.origin.y, ray.origin.z},
         {ray.direction.x, ray.direction.y, ray.direction.z}, clip);
  if (clip.outside || clip.enter > clip.leave) return {};
  const Vec3d normal = clip.enter > -infinity ? converted<double>(hull.planes[clip.plane].normal) : -ray.direction;
  return near.restored(entered(ray, clip.enter, clip.leave, normalized(normal)));
}

template <class T>
MaybeHit hit_hull(const LocalRay& ray, const HullData<T>& hull) {
  const auto vertex = [&](std::size_t i) { return converted<double>(hull.vertices[i]); };
  switch (hull.dimension) {
  case 0: return hit_sphere(ray, vertex(0), 0);
  case 1: return hit_balls(ray, vertex(0), 0, vertex(1), 0);
  case 2: {
    const auto loop = hull.loop(0);
    return hit_polygon(ray, loop.size(), [&](std::size_t i) { return vertex(loop[i]); });
  }
  default: return hit_polyhedron(ray, hull);
  }
}

}  // namespace graze::rays
