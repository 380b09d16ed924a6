#include "plane/ray_block.hpp"

#include "plane/outline_hit.hpp"
#include "plane/unit_rotation.hpp"
#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace plane;

using S = Lanes<double>;
using Mask = S::Mask;

/// The edge of the polygon that each ray comes upon from the front, as far as it is sure: from its left to its right.
struct Front {
  Mask known, met;
  S start_x, start_y, normal_x, normal_y, world_x, world_y;  ///< its first end seen from the ray, and its normals
};

[[gnu::always_inline]] inline Front front_of(const RayPolygon& polygon, const S& x, const S& y, const S& along_x,
                                             const S& along_y) {
  const S zero(0.0);
  Front front{zero <= zero, zero < zero, zero, zero, zero, zero, zero, zero};
  Mask first_left = front.met, left = front.met;
  S last_x = zero, last_y = zero;
  const auto choose = [&](std::size_t edge, const Mask& next_left) {
    const Mask here = left & !next_left;
    front.met = front.met | here;
    front.start_x = select(here, last_x, front.start_x);
    front.start_y = select(here, last_y, front.start_y);
    front.normal_x = select(here, S(polygon.normal_x[edge]), front.normal_x);
    front.normal_y = select(here, S(polygon.normal_y[edge]), front.normal_y);
    front.world_x = select(here, S(polygon.world_x[edge]), front.world_x);
    front.world_y = select(here, S(polygon.world_y[edge]), front.world_y);
  };
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const S to_x = S(polygon.vertex_x[i]) - x, to_y = S(polygon.vertex_y[i]) - y;
    const S one = along_x * to_y, other = along_y * to_x, beside = one - other;
    const S slack = S(beside_rounding) * (abs(one) + abs(other));
    const Mask is_left = beside > slack;
    front.known = front.known & (is_left | (beside < -slack));
    if (i == 0)
      first_left = is_left;
    else
      choose(i - 1, is_left);
    left = is_left;
    last_x = to_x;
    last_y = to_y;
  }
  choose(polygon.count - 1, first_left);
  return front;
}

[[gnu::flatten]] void ray_block(const RayPolygon& polygon, RayBlock& rays, std::size_t count) {
  const S at_x(polygon.x), at_y(polygon.y), cosine(polygon.cosine), sine(polygon.sine), zero(0.0);
  for (std::size_t i = 0; i < count; i += static_cast<std::size_t>(S::lanes)) {
    const S origin_x = S::load(rays.origin_x + i), origin_y = S::load(rays.origin_y + i),
            to_x = S::load(rays.direction_x + i), to_y = S::load(rays.direction_y + i);
    // The operations of `unit_vector`.
    const S square = to_x * to_x + to_y * to_y;
    const Mask sound = (square >= S(least_plain_square)) & (square <= S(most_plain_square));
    const S length = sqrt(square), direction_x = to_x / length, direction_y = to_y / length;
    const S from_x = origin_x - at_x, from_y = origin_y - at_y;
    const S x = cosine * from_x + sine * from_y, y = cosine * from_y - sine * from_x;
    const S along_x = cosine * direction_x + sine * direction_y, along_y = cosine * direction_y - sine * direction_x;
    const Front front = front_of(polygon, x, y, along_x, along_y);
    const S toward = -(front.normal_x * along_x + front.normal_y * along_y),
            above = -(front.normal_x * front.start_x + front.normal_y * front.start_y);
    const Mask known = sound & front.known;
    const Mask hit = known & front.met & (toward > zero) & (above > zero), missed = known & !front.met;
    const S t = above / select(hit, toward, S(1.0));
    t.store(rays.t + i);
    (origin_x + direction_x * t).store(rays.point_x + i);
    (origin_y + direction_y * t).store(rays.point_y + i);
    front.world_x.store(rays.normal_x + i);
    front.world_y.store(rays.normal_y + i);
    for (int lane = 0; lane < S::lanes; ++lane)
      rays.state[i + static_cast<std::size_t>(lane)] = hit[lane]      ? RayBlock::hit
                                                       : missed[lane] ? RayBlock::missed
                                                                      : RayBlock::unknown;
  }
}

}  // namespace

RayBlockKernel plane_ray_block() { return ray_block; }

}  // namespace graze::GRAZE_ISA
