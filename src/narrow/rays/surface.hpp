// Rays at surfaces of triangles: meshes and height fields.
//
// Guarantee: every triangle that the ray crosses is found, however thin its bounds: they are widened by what rounding
// can move a crossing by. Nearer subtrees first, so that a ray that shrinks prunes the rest.
#pragma once

#include "narrow/rays/sheared.hpp"
#include "narrow/rays/tree_walk.hpp"
#include "shape/mesh_data.hpp"

namespace graze::rays {

/// Component by component; infinite where the ray does not move.
inline Vec3d inverse_of(const Vec3d& direction) {
  const auto inverse = [](double v) { return v == 0 ? infinity : 1 / v; };
  return {inverse(direction.x), inverse(direction.y), inverse(direction.z)};
}

/// Calls `f(leaf, i)` for the triangles of a mesh that the ray may cross; `f` returns how far it has still to be followed.
/// `radius` as in `TreeWalk`.
template <class T, class F>
void walk_mesh(const MeshData<T>& mesh, const LocalRay& ray, double radius, F& f) {
  TreeWalk<T> walk{
      mesh.tree.nodes().data(),
      mesh.leaves.data(),
      static_cast<double>(mesh.extent),
      radius,
      {ray.origin.x, ray.origin.y, ray.origin.z},
      {ray.direction.x, ray.direction.y, ray.direction.z},
      ray.begin,
      ray.end,
      [](void* owner, const PackedLeaf& leaf, std::size_t i) { return (*static_cast<F*>(owner))(leaf, i); },
      &f};
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), walk_tree<T>);
  kernel(walk);
}

/// Calls `found(hit, triangle)` for the triangles that the ray crosses; `found` returns the ray's new end.
template <class Surface, class Found>
void cast_at_surface(const Surface& surface, const LocalRay& far, bool both_sides, Found& found) {
  const auto& hierarchy = surface.hierarchy();
  if (hierarchy.empty()) return;
  const auto& bounds = hierarchy.bounds();
  const Vec3d center = cast<double>(bounds.center());
  const Recentered near = recentered(far, center);
  LocalRay ray = near.ray;
  std::optional<Sheared> sheared;  // many a ray meets nothing

  const auto try_triangle = [&](const auto& corners, const auto& number) __attribute__((flatten)) {
    const auto vertex = [&](std::size_t i) { return cast<double>(corners[i]); };
    const Vec3d a = vertex(0), b = vertex(1), c = vertex(2);
    if (!sheared) sheared.emplace(ray);
    const Crossing at = crossing((*sheared)(a), (*sheared)(b), (*sheared)(c));
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
    if (hit) ray.end = found(*near.restored(hit), number()) - near.shift;
  };
  using Hierarchy = std::decay_t<decltype(hierarchy)>;
  using T = typename Surface::Scalar;
  if constexpr (std::is_same_v<Hierarchy, WideTree<T>>) {
    // Of a ray from afar the nearest point is known up to the rounding of where it comes from.
    const double reach = surface.radius + greatest(dot(center - ray.origin, ray.direction), 0.0);
    if (!(length_squared(ray.origin - center) <= reach * reach)) return;
    auto try_lane = [&](const PackedLeaf& leaf, std::size_t i) {
      const Vec3<T> corners[3] = {surface.points[leaf.corners[i][0]], surface.points[leaf.corners[i][1]],
                                  surface.points[leaf.corners[i][2]]};
      try_triangle(corners, [&] { return hierarchy.order()[leaf.first + i]; });
      return ray.end;
    };
    walk_mesh(surface, ray, reach, try_lane);
  } else {
    // Some ten operations on coordinates up to these.
    const double slack = 16 * epsilon * (static_cast<double>(surface.extent) + max_abs(ray.origin));
    const auto try_piece = [&](std::uint32_t number) {
      try_triangle(surface.triangle(number), [&] { return number; });
    };
    visit_ray(
        hierarchy, ray.origin, inverse_of(ray.direction), [&] { return ray.end; }, try_piece, ray.begin, slack);
  }
}

}  // namespace graze::rays
