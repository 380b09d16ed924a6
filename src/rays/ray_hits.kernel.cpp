// Rays against shapes in closed form, several at a time.
#include "rays/half_space.hpp"
#include "rays/quadrics.hpp"
#include "rays/ray_lanes.hpp"
#include "rays/ray_triangle.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace ray_lanes;
using Rays = rays::LocalRayOf<S>;
using Found = rays::FoundHit<S>;

template <class F>
[[gnu::always_inline]] inline void each_ray(rays::RayBlock& block, std::size_t count, double around, const F& hit) {
  for (std::size_t i = 0; i < count; i += step) {
    const Rays ray = load_ray(block, i);
    const M aimed = (ray.end >= S(0)) & near_ball(ray, S(around));
    const Found found = hit(ray);
    found.t.store(block.t + i);
    store(found.point, block.point, i);
    store(found.normal, block.normal, i);
    const M met = aimed & found.hit & (found.t < S(rays::infinity)) & (!found.undecided),
            again = aimed & found.undecided;
    select(again, S(rays::ray_again), select(met, S(rays::ray_hit), S(rays::ray_missed))).store(block.state + i);
  }
}

}  // namespace

[[gnu::flatten]] void block_hits(rays::RayBlock& block, std::size_t count, const rays::BlockShape& shape) {
  const auto each = [&](const auto& hit) __attribute__((always_inline)) { each_ray(block, count, shape.around, hit); };
  const auto point = [&](std::size_t i) { return Vec3d{shape.points[i][0], shape.points[i][1], shape.points[i][2]}; };
  switch (shape.kind) {
  case rays::BlockShape::none: return;
  case rays::BlockShape::ball:
    return each([&](const Rays& ray) __attribute__((always_inline)) {
      return rays::hit_ball(ray, broadcast<S>(shape.points[0]), S(shape.radius));
    });
  case rays::BlockShape::half_space:
    return each([&](const Rays& ray)
                    __attribute__((always_inline)) { return rays::hit_half_space(ray, S(shape.radius)); });
  case rays::BlockShape::triangle: {
    const V p[3] = {broadcast<S>(shape.points[0]), broadcast<S>(shape.points[1]), broadcast<S>(shape.points[2])};
    const auto vertex = [&](std::size_t i) __attribute__((always_inline)) { return p[i]; };
    const V center = (p[0] + p[1] + p[2]) / S(3);
    return each([&](const Rays& ray) __attribute__((always_inline)) {
      return rays::hit_across(rays::recentered(ray, center), 3, vertex, shape.both_sides);
    });
  }
  case rays::BlockShape::ball_cone: {
    const rays::BallCone cone(point(0), shape.radius, point(1), shape.other_radius);
    return each([&](const Rays& ray) __attribute__((always_inline)) { return rays::hit_ball_cone(ray, cone); });
  }
  case rays::BlockShape::frustum: {
    const rays::Frustum frustum(shape.points[0][1], shape.radius, shape.other_radius);
    return each([&](const Rays& ray) __attribute__((always_inline)) { return rays::hit_frustum(ray, frustum); });
  }
  case rays::BlockShape::ellipsoid:
    return each([&](const Rays& ray) __attribute__((always_inline)) {
      return rays::hit_solid_ellipsoid(ray, broadcast<S>(shape.points[0]));
    });
  }
}

}  // namespace graze::GRAZE_ISA
