// Composites taken apart: the convex pieces of a shape that come near a region.
//
// Guarantee: every piece whose bounds lie within the limit of the region is visited, and the same ones in the same
// order for the same input; nearer subtrees first, so that a limit that shrinks prunes the rest. A region is anything
// that `within` and `order` are written for: a box and a distance here, a moving box and a time in `mid/sweep.hpp`.
#pragma once

#include "graze/shape.hpp"
#include "shape/mesh_data.hpp"

namespace graze {

/// The squared gap between two boxes; 0 when they overlap.
template <class T>
T gap_squared(const Aabb<T>& a, const Aabb<T>& b) {
  return length_squared(greatest(Vec3<T>{}, greatest(a.lower - b.upper, b.lower - a.upper)));
}

/// Whether two boxes come within `limit`; of boxes that overlap, always.
template <class T>
bool within(const Aabb<T>& a, const Aabb<T>& b, T limit) {
  const T gap = gap_squared(a, b);
  return gap == T(0) || (limit > T(0) && gap <= limit * limit);
}

/// What comes first where it is less.
template <class T>
T order(const Aabb<T>& a, const Aabb<T>& b) {
  return gap_squared(a, b);
}

/// Calls `f(shape, pose, number)` for each child or triangle of a composite that comes within `limit()` of `region` (in
/// the composite's frame); a convex shape is its own only piece.
template <class T, class Region, class Limit, class F>
void visit_pieces(const Shape<T>& shape, const Pose<T>& pose, const Region& region, const Limit& limit, F&& f);

namespace detail {

template <class T, class Region, class Limit, class F>
void visit_triangles(const MeshData<T>& mesh, std::uint32_t index, const Pose<T>& pose, const Region& region,
                     const Limit& limit, F& f) {
  const auto& node = mesh.tree.nodes()[index];
  if (!within(node.box, region, limit())) return;
  if (node.count == 0) {
    const std::uint32_t left = index + 1, right = node.first;
    const bool right_first = order(mesh.tree.nodes()[right].box, region) < order(mesh.tree.nodes()[left].box, region);
    visit_triangles(mesh, right_first ? right : left, pose, region, limit, f);
    visit_triangles(mesh, right_first ? left : right, pose, region, limit, f);
    return;
  }
  for (const std::uint32_t t : mesh.tree.pieces(node)) {
    const auto& corner = mesh.triangles[t];
    const Vec3<T>&a = mesh.points[corner[0]], &b = mesh.points[corner[1]], &c = mesh.points[corner[2]];
    if (within(Aabb<T>{least(a, least(b, c)), greatest(a, greatest(b, c))}, region, limit()))
      f(Shape<T>(Triangle<T>(a, b, c)), pose, t);
  }
}

}  // namespace detail

template <class T, class Region, class Limit, class F>
void visit_pieces(const Shape<T>& shape, const Pose<T>& pose, const Region& region, const Limit& limit, F&& f) {
  if (const auto* mesh = shape.template as<Mesh<T>>()) {
    detail::visit_triangles(mesh->data(), 0, pose, region, limit, f);
  } else if (const auto* compound = shape.template as<Compound<T>>()) {
    std::uint32_t number = 0;
    for (const Placed<T>& child : compound->children()) {
      if (within(bounds(child.shape, child.pose), region, limit())) f(child.shape, compose(pose, child.pose), number);
      ++number;
    }
  } else {
    f(shape, pose, 0u);
  }
}

}  // namespace graze
