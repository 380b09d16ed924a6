// Rays against half-spaces, one ray or one in each lane.
#pragma once

#include "rays/local_ray.hpp"

namespace graze::rays {

/// The hit of the half-space y <= height.
template <class S>
[[gnu::always_inline]] inline FoundHit<S> hit_half_space(const LocalRayOf<S>& ray, const S& height) {
  const S zero(0), above = ray.at(ray.begin).y - height, t = ray.begin - above / ray.direction.y;
  const MaskOf<S> inside = above <= zero, met = (ray.direction.y < zero) & (t <= ray.end) & (t != S(infinity)),
                  hit = inside | met;
  const S first = select(inside, ray.begin, t);
  const Vec3<S> p = ray.at(first);
  return {
      hit, first, {p.x, select(inside, p.y, height), p.z}, select(inside, -ray.direction, Vec3<S>{zero, S(1), zero})};
}

}  // namespace graze::rays
