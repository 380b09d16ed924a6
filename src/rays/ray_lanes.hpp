// Rays of a block as lanes, and their hits. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level; a lane has the bits of `local_ray.hpp` for
// that ray alone.
#pragma once

#include "rays/lane_vec3.hpp"
#include "rays/ray_block.hpp"

namespace graze::GRAZE_ISA::ray_lanes {

using S = Lanes<double>;
using V = Lane3<S>;
using M = S::Mask;
inline constexpr auto step = static_cast<std::size_t>(S::lanes);
inline constexpr double infinity = __builtin_inf();

/// `LocalRay`, and what became of it.
struct Rays {
  V origin, direction;
  S begin, end, blur;

  [[gnu::always_inline]] Rays(const rays::RayBlock& block, std::size_t i)
      : origin(V::load(block.origin, i)),
        direction(V::load(block.direction, i)),
        begin(0),
        end(S::load(block.end + i)),
        blur(S::load(block.blur + i)) {}
  [[gnu::always_inline]] V at(const S& t) const { return origin + direction * t; }

  /// Moves the origin to the point nearest to `center`; returns how far.
  [[gnu::always_inline]] S recenter(const V& center) {
    const S shift = greatest(dot(center - origin, direction), begin);
    origin = at(shift);
    begin = begin - shift;
    end = end - shift;
    return shift;
  }
};

struct Hits {
  M hit, again;
  S t;
  V point, normal;
};

[[gnu::always_inline]] inline M none() { return S(1) < S(0); }

[[gnu::always_inline]] inline Hits entered(const Rays& ray, const S& shift, const M& met, const S& enter,
                                           const S& leave, const V& normal) {
  const M hit = met & (enter <= leave) & (leave >= ray.begin) & (enter <= ray.end), inside = enter <= ray.begin;
  const S t = select(inside, ray.begin, enter);
  return {hit, none(), t + shift, ray.at(t), select(inside, -ray.direction, normal)};
}

}  // namespace graze::GRAZE_ISA::ray_lanes
