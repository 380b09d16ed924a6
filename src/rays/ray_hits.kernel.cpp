// Rays against shapes of closed form, several at a time: `hit_ball`, `hit_half_space`, `hit_polygon` and
// what `quadric_lanes.hpp` names of one ray, with choices in place of branches. What those do for few rays only is left
// to them.
#include "rays/quadric_lanes.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace ray_lanes;

[[gnu::always_inline]] inline Hits hit_ball(Rays ray, const rays::BlockShape& shape) {
  const V center = V::all(shape.points[0]);
  const S shift = ray.recenter(center), radius(shape.radius);
  const V to = center - ray.origin;
  const S along = dot(to, ray.direction), across = length(to - ray.direction * along);
  const S half = sqrt((radius - across) * (radius + across)), enter = along - half;
  const V normal = normalized(ray.at(enter) - center, -ray.direction);
  return entered(ray, shift, across <= radius, enter, along + half, normal);
}

[[gnu::always_inline]] inline Hits hit_half_space(const Rays& ray, const rays::BlockShape& shape) {
  const S height(shape.radius), above = ray.at(ray.begin).y - height;
  const M inside = above <= S(0);
  const S t = ray.begin - above / ray.direction.y;
  const M met = (ray.direction.y < S(0)) & (t <= ray.end) & (t != S(infinity));
  const V p = ray.at(select(inside, ray.begin, t));
  return {inside | met,
          none(),
          select(inside, ray.begin, t),
          {p.x, select(inside, p.y, height), p.z},
          select(inside, -ray.direction, V{S(0), S(1), S(0)})};
}

[[gnu::always_inline]] inline Hits hit_triangle(Rays ray, const rays::BlockShape& shape) {
  const V p[3] = {V::all(shape.points[0]), V::all(shape.points[1]), V::all(shape.points[2])};
  const S shift = ray.recenter((p[0] + p[1] + p[2]) / S(3));
  // The frame along the ray: z is the greatest coordinate of the direction, x and y follow it, exchanged where it is
  // less than zero.
  const V size{abs(ray.direction.x), abs(ray.direction.y), abs(ray.direction.z)};
  const M along_x = (size.x >= size.y) & (size.x >= size.z), along_y = (!along_x) & (size.y >= size.z);
  const auto turned = [&](const V& v) __attribute__((always_inline)) {
    return V{select(along_x, v.y, select(along_y, v.z, v.x)), select(along_x, v.z, select(along_y, v.x, v.y)),
             select(along_x, v.x, select(along_y, v.y, v.z))};
  };
  const V d = turned(ray.direction);
  const M back = d.z < S(0);
  const auto exchanged = [&](const V& v) __attribute__((always_inline)) {
    return V{select(back, v.y, v.x), select(back, v.x, v.y), v.z};
  };
  const V e = exchanged(d);
  const S shear_x = e.x / e.z, shear_y = e.y / e.z, shear_z = S(1) / e.z;
  V c[3];
  for (int i = 0; i < 3; ++i) {
    const V q = exchanged(turned(p[i] - ray.origin));
    c[i] = {q.x - shear_x * q.z, q.y - shear_y * q.z, shear_z * q.z};
  }
  M again = none(), left = none(), right = none();
  S whole(0), low(infinity), high(-infinity);
  for (int i = 0; i < 3; ++i) {
    const V &from = c[(i + 2) % 3], &to = c[i];
    const S one = to.x * from.y, other = to.y * from.x, side = one - other;
    again = again | (one == other);  // rounding's share decides the sign
    left = left | (side > S(0));
    right = right | (side < S(0));
    whole = whole + side;
    low = least(low, to.z);
    high = greatest(high, to.z);
  }
  again = again | (whole == S(0));
  const V first = p[0], area = V{S(0), S(0), S(0)} + cross(p[1] - first, p[2] - first);
  const V normal = normalized(area, -ray.direction);
  const S t = greatest(low, least(dot(normal, first - ray.origin) / dot(normal, ray.direction), high));
  M hit = (!(left & right)) & (t >= ray.begin) & (t <= ray.end);
  if (!shape.both_sides) hit = hit & (!(whole < S(0)));
  return {hit, again, t + shift, ray.at(t), select(dot(normal, ray.direction) > S(0), -normal, normal)};
}

template <class F>
[[gnu::always_inline]] inline void each_ray(rays::RayBlock& block, std::size_t count, double around, const F& hit) {
  for (std::size_t i = 0; i < count; i += step) {
    const Rays ray(block, i);
    // As `near_ball`: its rounding, too, decides what is hit.
    const S reach = S(around) + ray.blur;
    const V nearest = ray.at(greatest(ray.begin, least(-dot(ray.origin, ray.direction), ray.end)));
    const M aimed = (ray.end >= S(0)) & (dot(nearest, nearest) <= reach * reach);
    const Hits h = hit(ray);
    h.t.store(block.t + i);
    h.point.store(block.point, i);
    h.normal.store(block.normal, i);
    const M met = aimed & h.hit & (h.t < S(infinity)) & (!h.again), again = aimed & h.again;
    select(again, S(rays::ray_again), select(met, S(rays::ray_hit), S(rays::ray_missed))).store(block.state + i);
  }
}

}  // namespace

void block_hits(rays::RayBlock& block, std::size_t count, const rays::BlockShape& shape) {
  const auto each = [&](const auto& hit) __attribute__((always_inline)) {
    each_ray(
        block, count, shape.around, [&](const Rays& ray) __attribute__((always_inline)) { return hit(ray, shape); });
  };
  switch (shape.kind) {
  case rays::BlockShape::none: return;
  case rays::BlockShape::ball: return each(hit_ball);
  case rays::BlockShape::half_space: return each(hit_half_space);
  case rays::BlockShape::triangle: return each(hit_triangle);
  case rays::BlockShape::ball_cone: return each(hit_ball_cone);
  case rays::BlockShape::frustum: return each(hit_frustum);
  case rays::BlockShape::ellipsoid: return each(hit_ellipsoid);
  }
}

}  // namespace graze::GRAZE_ISA
