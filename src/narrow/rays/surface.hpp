// Rays at surfaces of triangles: meshes and height fields.
//
// Guarantee: every triangle that the ray crosses is found, however thin its bounds: they are widened by what rounding
// can move a crossing by. Nearer subtrees first, so that a ray that shrinks prunes the rest.
#pragma once

#include "narrow/rays/passed.hpp"
#include "narrow/rays/sheared.hpp"
#include "shape/wide_tree.hpp"

namespace graze::rays {

/// Component by component; infinite where the ray does not move.
inline Vec3d inverse_of(const Vec3d& direction) {
  const auto inverse = [](double v) { return v == 0 ? infinity : 1 / v; };
  return {inverse(direction.x), inverse(direction.y), inverse(direction.z)};
}

/// Calls `found(hit, triangle)` for the triangles that the ray crosses; `found` returns the ray's new end.
template <class Surface, class Found>
void cast_at_surface(const Surface& surface, const LocalRay& far, bool both_sides, Found& found) {
  const auto& hierarchy = surface.hierarchy();
  if (hierarchy.empty()) return;
  const Recentered near = recentered(far, cast<double>(hierarchy.bounds().center()));
  LocalRay ray = near.ray;
  const Sheared sheared(ray);
  // Some ten operations on coordinates up to these.
  const double slack = 16 * epsilon * (static_cast<double>(surface.extent) + max_abs(ray.origin));

  const auto try_triangle = [&](std::uint32_t index) {
    const auto corners = surface.triangle(index);
    const auto vertex = [&](std::size_t i) { return cast<double>(corners[i]); };
    const Vec3d a = vertex(0), b = vertex(1), c = vertex(2);
    const Crossing at = crossing(sheared(a), sheared(b), sheared(c));
    MaybeHit hit;
    switch (at.kind) {
    case Crossing::none: return;
    case Crossing::edge_on: hit = hit_in_plane(ray, 3, vertex); break;
    case Crossing::back:
      if (!both_sides) return;
      [[fallthrough]];
    case Crossing::front:
      if (at.t >= ray.begin && at.t <= ray.end)
        hit = hit_at(ray, at.t, against(ray, normalized(cross(b - a, c - a), -ray.direction)));
    }
    if (hit) ray.end = found(*near.restored(hit), index) - near.shift;
  };
  using Hierarchy = std::decay_t<decltype(hierarchy)>;
  if constexpr (std::is_same_v<Hierarchy, WideTree<typename Surface::Scalar>>) {
    using T = typename Surface::Scalar;
    const double extent = static_cast<double>(surface.extent);
    const RayQuestion<double> question{ray.origin, inverse_of(ray.direction), ray.begin, ray.end, slack};
    if (!(question(hierarchy.bounds()) < infinity)) return;
    using Filter = PassedFilter<T>;
    const Filter filter(sheared, extent);
    const auto try_leaf = [&](std::size_t first, std::size_t count) {
      for (const std::size_t end = first + count; first < end; first += Filter::lanes) {
        std::uint32_t bits = filter.left(surface, first, least(Filter::lanes, end - first));
        for (; bits != 0; bits &= bits - 1)
          try_triangle(hierarchy.order()[first + static_cast<std::size_t>(std::countr_zero(bits))]);
      }
    };
    const auto soon = [&](std::size_t first) { __builtin_prefetch(&surface.corners[first]); };
    hierarchy.each_leaf(
        TreeRay<T>(ray.origin, ray.direction, ray.begin, extent, slack), [&] { return ray.end; }, soon, try_leaf);
  } else {
    visit_ray(
        hierarchy, ray.origin, inverse_of(ray.direction), [&] { return ray.end; }, try_triangle, ray.begin, slack);
  }
}

}  // namespace graze::rays
