// Rays of a block as lanes. Only for `*.kernel.cpp`.
//
// Guarantee: numbers are copied only. Everything is inlined or lives in the namespace of the level.
#pragma once

#include "rays/lane_vec3.hpp"
#include "rays/local_ray.hpp"
#include "rays/ray_block.hpp"

namespace graze::GRAZE_ISA::ray_lanes {

using S = Lanes<double>;
using V = Vec3<S>;
using M = S::Mask;
inline constexpr auto step = static_cast<std::size_t>(S::lanes);

/// The rays from index `at` on.
[[gnu::always_inline]] inline rays::LocalRayOf<S> load_ray(const rays::RayBlock& block, std::size_t at) {
  return {load_vec3<S>(block.origin, at), load_vec3<S>(block.direction, at), S(0), S::load(block.end + at),
          S::load(block.blur + at)};
}

}  // namespace graze::GRAZE_ISA::ray_lanes
