// Rays at surfaces of triangles: meshes and height fields.
//
// Guarantee: every triangle that the ray crosses is found, however thin its bounds: these are widened by the rounding
// of a crossing. Nearer subtrees come first, so that the shortened ray prunes the rest.
#pragma once

#include "rays/bvh_traversal.hpp"
#include "rays/height_field_traversal.hpp"
#include "rays/ray_triangle.hpp"
#include "shape/height_field_data.hpp"
#include "shape/mesh_data.hpp"
#include "simd/flatten.hpp"

namespace graze::rays {

/// The inverse of each component; infinite for zero.
inline Vec3d inverse_of(const Vec3d& direction) {
  const auto inverse = [](double v) { return v == 0 ? infinity : 1 / v; };
  return {inverse(direction.x), inverse(direction.y), inverse(direction.z)};
}

/// Calls `f(leaf, i)` for the triangles of a mesh that the ray may cross; `f` returns the length up to which the ray is
/// still to be followed. `radius` as in `BvhQuestion`.
template <class T, class F>
void traverse_mesh(const MeshData<T>& mesh, const LocalRay& ray, double radius, F& f) {
  BvhQuestion<T> question{mesh.tree.nodes().data(),
                          mesh.leaves.data(),
                          static_cast<double>(mesh.extent),
                          radius,
                          {ray.origin.x, ray.origin.y, ray.origin.z},
                          {ray.direction.x, ray.direction.y, ray.direction.z},
                          ray.begin,
                          ray.end,
                          [](void* owner, std::uint32_t place) { return (*static_cast<F*>(owner))(place); },
                          &f};
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), traverse_bvh<T>);
  kernel(question);
}

/// A ray that is cast at one triangle after the other of a surface about `center`.
template <class Found>
class TriangleCast {
 public:
  TriangleCast(const LocalRay& far, const Vec3d& center, bool both_sides, Found& found)
      : near_(recentered(far, center)), end_(near_.ray.end), both_sides_(both_sides), found_(found) {}

  /// The ray with its origin near the centre.
  const LocalRay& ray() const { return near_.ray; }
  /// The length up to which it is still to be followed.
  double end() const { return end_; }

  /// Casts the ray at one triangle; `number()` returns its number and is called for a hit. Returns `end()`.
  template <class Corners, class Number>
  GRAZE_FLATTEN double at(const Corners& corners, const Number& number) {
    const LocalRay& ray = near_.ray;
    const auto vertex = [&](std::size_t i) { return converted<double>(corners[i]); };
    const Vec3d a = vertex(0), b = vertex(1), c = vertex(2);
    if (!frame_) frame_.emplace(ray);
    const LineCrossing<double> at = line_crossing((*frame_)(a), (*frame_)(b), (*frame_)(c));
    MaybeHit hit;
    if (at.edge_on)
      hit = hit_edge_on(ray, a, b, c);
    else if (at.through && (both_sides_ || at.whole > 0) && at.t >= ray.begin && at.t <= ray.end)
      hit = hit_at(ray, at.t, against(ray, normalized(cross(b - a, c - a), -ray.direction)));
    if (hit) {
      const double along = found_(*near_.restored(hit), number());
      end_ = along > -infinity ? least(end_, end_after(along, near_.shift)) : along;
    }
    return end_;
  }

 private:
  [[gnu::noinline]] static MaybeHit hit_edge_on(const LocalRay& ray, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return hit_in_plane(ray, 3, [&](std::size_t i) { return i == 0 ? a : i == 1 ? b : c; });
  }

  Recentered near_;
  double end_;
  std::optional<RayAlignedFrame<double>> frame_;  // absent until needed: many rays come near no triangle
  bool both_sides_;
  Found& found_;
};

/// An upper bound of the distance, from the ray's origin, of all that the ray meets in the ball; less than zero when it
/// passes the ball.
inline double reach_to(const Vec3d& center, double radius, const LocalRay& ray) {
  // For a ray from afar the nearest point is known up to the rounding of its origin.
  const Vec3d to = center - ray.origin;
  const double reach = radius + greatest(dot(to, ray.direction), 0.0);
  return length_squared(to) <= reach * reach ? reach : -1;
}

/// Calls `found(hit, triangle)` for the triangles that the ray crosses; `found` returns the ray's new end.
template <class T, class Found>
void cast_at_surface(const MeshData<T>& mesh, const LocalRay& far, bool both_sides, Found& found) {
  if (mesh.tree.empty()) return;
  const Vec3d center = converted<double>(mesh.tree.bounds().center());
  TriangleCast<Found> triangle(far, center, both_sides, found);
  const LocalRay& ray = triangle.ray();
  const double reach = reach_to(center, mesh.radius, ray);
  if (reach < 0) return;
  auto try_piece = [&](std::uint32_t place) {
    const std::uint32_t number = mesh.tree.order()[place];
    return triangle.at(mesh.triangle(number), [&] { return number; });
  };
  traverse_mesh(mesh, ray, reach, try_piece);
}

template <class T, class Found>
[[gnu::noinline]] void cast_at_surface(const HeightFieldData<T>& field, const LocalRay& far, bool both_sides,
                                       Found& found) {
  const Vec3d center = converted<double>(field.bounds().center());
  TriangleCast<Found> triangle(far, center, both_sides, found);
  const LocalRay& ray = triangle.ray();
  const double reach = reach_to(center, field.radius, ray);
  if (reach < 0) return;
  auto try_cell = [&](std::uint32_t column, std::uint32_t row) {
    const std::uint32_t first = 2 * (row * (field.columns - 1) + column);
    for (std::uint32_t i = first; i < first + 2; ++i) triangle.at(field.triangle(i), [&] { return i; });
    return triangle.end();
  };
  using Cell = decltype(try_cell);
  const FieldQuestion<T> question{
      &field.pyramid,
      static_cast<double>(field.extent),
      reach,
      {ray.origin.x, ray.origin.y, ray.origin.z},
      {ray.direction.x, ray.direction.y, ray.direction.z},
      ray.begin,
      ray.end,
      [](void* owner, std::uint32_t column, std::uint32_t row) { return (*static_cast<Cell*>(owner))(column, row); },
      &try_cell};
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), traverse_field<T>);
  kernel(question);
}

}  // namespace graze::rays
