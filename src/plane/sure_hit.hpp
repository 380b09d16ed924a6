// Sure hits of rays in closed form, at circles, boxes and convex polygons without rounding.
//
// Guarantee: where the answer is known, the bits are those of `ray_hit`. A ray that begins inside or passes a vertex so
// closely that rounding decides is left to `ray_hit`. Inlined, so that a ray stays in registers.
#pragma once

#include <bit>
#include <optional>
#include <span>
#include <type_traits>

#include "plane/axes_kernels.hpp"
#include "plane/outline_hit.hpp"
#include "plane/ray_sides.hpp"

namespace graze::plane {

/// A hit of a ray at a shape, or a sure miss.
struct SureHit {
  bool known = false;
  double t = never;  ///< `never` on a miss
  Vec2d normal{};
};

/// The kernel of the level that the machine runs at.
inline RaySidesKernel ray_sides_kernel() {
  static const RaySidesKernel chosen = GRAZE_KERNEL(chosen_isa(), plane_ray_sides)();
  return chosen;
}

/// The sides on which the vertices lie, by the kernel in floats; a vertex is on neither where floats do not decide.
[[gnu::always_inline]] inline RaySides sides_in_lanes(const AxesPolygon<float>& polygon, const Vec2d& origin,
                                                      const Vec2d& direction, double size) {
  const double offset = cross(direction, origin);
  // Two products and two differences of floats, of numbers no larger than the size and the offset.
  const double slack = 8 * double(std::numeric_limits<float>::epsilon()) * (size + std::abs(offset));
  return ray_sides_kernel()(polygon.vertices, polygon.count, float(direction.x), float(direction.y), float(offset),
                            float(slack));
}
/// Whether the kernel takes a polygon; four vertices are seen to as fast one by one.
template <class T>
bool sided_in_lanes(const AxesPolygon<T>& polygon, double size) {
  return std::is_same_v<T, float> && polygon.count > 4 && polygon.count <= most_sided && size >= least_size &&
         size <= most_size;
}

/// The sides on which the vertices lie, in doubles, one by one.
template <class T>
[[gnu::always_inline]] inline RaySides sides_one_by_one(const AxesPolygon<T>& polygon, const Vec2d& origin,
                                                        const Vec2d& direction) {
  RaySides sides{0, 0};
  for (std::uint32_t i = 0; i < polygon.count; ++i) {
    const Vec2d to = converted<double>(polygon.vertices[i]) - origin;
    // A vertex that the ray passes closely is on neither side: rounding decides.
    const double left = direction.x * to.y, right = direction.y * to.x;
    const double beside = left - right, slack = beside_rounding * (std::abs(left) + std::abs(right));
    sides.left |= static_cast<std::uint32_t>(beside > slack) << i;
    sides.right |= static_cast<std::uint32_t>(beside < -slack) << i;
  }
  return sides;
}

/// The bits of edges that lead from the left of a ray to its right: of a convex polygon one, which the ray sees from
/// the front, or none.
inline std::uint32_t front_edges(const RaySides& sides, std::uint32_t count) {
  const std::uint32_t next_on_left = sides.left >> 1 | (sides.left & 1) << (count - 1);
  return sides.left & ~next_on_left;
}

/// An edge with the outward normal `n`, between whose ends a ray passes. `start`: one of them, seen from the ray's
/// origin.
inline SureHit hit_edge(const Vec2d& start, const Vec2d& n, const Vec2d& direction) {
  const double toward = -dot(n, direction), above = -dot(n, start);
  if (!(toward > 0 && above > 0)) return {};
  return {true, above / toward, n};
}

/// The hit of a polygon without rounding.
template <class T>
[[gnu::always_inline]] inline SureHit sure_hit(const AxesPolygon<T>& polygon, const Vec2d& origin,
                                               const Vec2d& direction, double size) {
  if (polygon.count < 3 || polygon.count > 32) return {};
  const std::uint32_t all = ~std::uint32_t{0} >> (32 - polygon.count);
  RaySides sides{0, 0};
  if constexpr (std::is_same_v<T, float>)
    if (sided_in_lanes(polygon, size)) sides = sides_in_lanes(polygon, origin, direction, size);
  if ((sides.left | sides.right) != all) sides = sides_one_by_one(polygon, origin, direction);
  if ((sides.left | sides.right) != all) return {};
  const std::uint32_t front = front_edges(sides, polygon.count);
  if (front == 0) return {true};
  const auto i = static_cast<std::uint32_t>(std::countr_zero(front));
  const Vec2d from = converted<double>(polygon.vertices[i]),
              to = converted<double>(polygon.vertices[i + 1 == polygon.count ? 0 : i + 1]), edge = to - from;
  return hit_edge(from - origin, right(edge / length(edge)), direction);
}

/// The hit of a box about the origin, whose vertices and edges are numbered as in its core.
inline SureHit sure_hit(const Vec2d& half, const Vec2d& origin, const Vec2d& direction) {
  const double x = direction.y * half.x, y = direction.x * half.y;
  const double left = direction.x * origin.y, right = direction.y * origin.x, offset = left - right;
  const double slack = beside_rounding * (std::abs(x) + std::abs(y) + std::abs(left) + std::abs(right));
  const double beside[] = {x - y - offset, -x - y - offset, y - x - offset, x + y - offset};
  RaySides sides{0, 0};
  for (std::uint32_t i = 0; i < 4; ++i) {
    sides.left |= static_cast<std::uint32_t>(beside[i] > slack) << i;
    sides.right |= static_cast<std::uint32_t>(beside[i] < -slack) << i;
  }
  if ((sides.left | sides.right) != 15) return {};
  const std::uint32_t front = front_edges(sides, 4);
  if (front == 0) return {true};
  constexpr Vec2d normals[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  const Vec2d n = normals[std::countr_zero(front)];
  return hit_edge(Vec2d{n.x * half.x, n.y * half.y} - origin, n, direction);
}

/// The hit of a disc about the origin.
inline SureHit sure_hit(double radius, const Vec2d& origin, const Vec2d& direction) {
  if (!(radius > 0 && length_squared(origin) > radius * radius)) return {};
  OutlineHit hit;
  meet_disc(-origin, radius, direction, hit);
  return {true, hit.t, hit.normal};
}

/// The hit of a shape, with the ray seen from its frame.
template <class T>
[[gnu::always_inline]] inline SureHit sure_hit(const Shape<T>& shape, const Vec2d& origin, const Vec2d& direction) {
  if (const auto* circle = shape.template as<Circle<T>>())
    return sure_hit(double(circle->radius()) + double(shape.rounding()), origin, direction);
  if (shape.rounding() != T(0)) return {};
  if (const auto* polygon = shape.template as<ConvexPolygon<T>>()) {
    const std::span<const Vec2<T>> vertices = polygon->vertices();
    return sure_hit(AxesPolygon<T>{vertices.data(), static_cast<std::uint32_t>(vertices.size())}, origin, direction,
                    double(polygon->core_extent()));
  }
  if (const auto* box = shape.template as<Box<T>>())
    return sure_hit(converted<double>(box->half_extents()), origin, direction);
  return {};
}

}  // namespace graze::plane
