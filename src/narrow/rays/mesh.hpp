// Rays through a mesh's tree of bounds.
//
// Guarantee: every triangle that the ray crosses is found, however thin its bounds: they are widened by what rounding
// can move a crossing by. Nearer subtrees first, so that a ray that shrinks prunes the rest.
#pragma once

#include <array>

#include "narrow/rays/sheared.hpp"
#include "shape/mesh_data.hpp"

namespace graze::rays {

/// Calls `visit(piece)` for every piece of the leaves that the ray enters before `end`, nearer subtrees first; `visit` may
/// lessen `end`. `entry(box)` is where the ray enters a box, infinite when it does not. This is all that rays know of
/// the tree.
template <class T, class Entry, class Visit>
void front_to_back(const BoundsTree<T>& tree, const double& end, const Entry& entry, const Visit& visit) {
  struct Postponed {
    std::uint32_t node;
    double enter;
  };
  std::array<Postponed, 2 * 32 + 2> stack;  // one for each level; the tree is at most 2 log2(n) + 1 deep
  std::size_t waiting = 0;
  const auto nodes = tree.nodes();
  stack[waiting++] = {0, entry(nodes[0].box)};
  while (waiting > 0) {
    auto [index, enter] = stack[--waiting];
    while (enter <= end && enter < infinity) {
      const auto& node = nodes[index];
      if (node.count > 0) {
        for (const std::uint32_t piece : tree.pieces(node)) visit(piece);
        break;
      }
      Postponed left{index + 1, entry(nodes[index + 1].box)}, right{node.first, entry(nodes[node.first].box)};
      if (right.enter < left.enter) std::swap(left, right);
      stack[waiting++] = right;
      index = left.node;
      enter = left.enter;
    }
  }
}

/// Where the ray enters a box widened by `slack` (slabs: Kay, Kajiya 1986); infinite when it does not. A crossing that
/// the shear's rounding moves by up to `slack` stays in the box, and the two divisions err by less than `slack` does.
template <class T>
double slab_entry(const LocalRay& ray, const Aabb<T>& box, double slack) {
  double enter = ray.begin, leave = ray.end;
  for (std::size_t i = 0; i < 3; ++i) {
    const double low = static_cast<double>(box.lower[i]) - slack - ray.origin[i];
    const double high = static_cast<double>(box.upper[i]) + slack - ray.origin[i];
    const double d = ray.direction[i];
    if (d == 0) {
      if (low > 0 || high < 0) return infinity;
      continue;
    }
    enter = greatest(enter, (d > 0 ? low : high) / d);
    leave = least(leave, (d > 0 ? high : low) / d);
  }
  return enter <= leave + slack ? enter : infinity;
}

/// Calls `found(hit, triangle)` for the triangles that the ray crosses; `found` returns the ray's new end.
template <class T, class Found>
void cast_at_mesh(const MeshData<T>& mesh, const LocalRay& far, bool both_sides, Found& found) {
  if (mesh.tree.empty()) return;
  const Recentered near = recentered(far, cast<double>(mesh.tree.bounds().center()));
  LocalRay ray = near.ray;
  const Sheared sheared(ray);
  // Some ten operations on coordinates up to these.
  const double slack = 16 * epsilon * (static_cast<double>(mesh.extent) + max_abs(ray.origin));

  const auto try_triangle = [&](std::uint32_t index) {
    const auto& corner = mesh.triangles[index];
    const auto vertex = [&](std::size_t i) { return cast<double>(mesh.points[corner[i]]); };
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
  const auto entry = [&](const Aabb<T>& box) { return slab_entry(ray, box, slack); };
  front_to_back(mesh.tree, ray.end, entry, try_triangle);
}

}  // namespace graze::rays
