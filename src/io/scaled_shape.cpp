#include "io/scaled_shape.hpp"

#include <cstdio>

#include "graze/angles.hpp"

namespace graze::io {

namespace {

/// Directions spread evenly over the sphere (Swinbank, Purser 2006, "Fibonacci grids").
std::vector<Vec3d> directions(int count) {
  std::vector<Vec3d> out;
  const double golden = 2.399963229728653;
  for (int i = 0; i < count; ++i) {
    const double y = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - y * y);
    const CosineSine turn = cosine_sine(golden * i);
    out.push_back({r * turn.cosine, y, r * turn.sine});
  }
  return out;
}

/// The mapped shape's furthest point along `direction`: that of the shape along the transposed map.
Vec3d furthest(const Shaped& shape, const Mat3d& map, const Vec3d& direction) {
  return map * support(shape, transposed_times(map, direction));
}

MappedShape sampled_hull(const Shaped& shape, const Affine& map) {
  std::vector<Vec3d> points;
  for (const Vec3d& d : directions(600)) points.push_back(furthest(shape, map.linear, d));
  const Shaped hull = ConvexHull<double>(points);
  double off = 0, size = 0;
  for (const Vec3d& d : directions(5000)) {
    const double reach = dot(furthest(shape, map.linear, d), d);
    off = std::max(off, reach - dot(support(hull, d), d));
    size = std::max(size, reach);
  }
  char text[160];
  std::snprintf(text, sizeof text, "a scaled %s became the hull of %zu points, %.2g of its size too small",
                shape.name(), hull.as<ConvexHull<double>>()->data().vertices.size(), size > 0 ? off / size : 0.0);
  return {hull, {map.translation, {}}, text};
}

std::vector<Vec3d> box_corners(const Vec3d& half) {
  const auto corners = vertices_of(OrientedBox<double>{{}, half});
  return {corners.begin(), corners.end()};
}

MappedShape mapped_points(std::vector<Vec3d> points, const Affine& map) {
  for (Vec3d& p : points) p = map.linear * p;
  return {ConvexHull<double>(points), {map.translation, {}}, ""};
}

MappedShape mapped_mesh(const Mesh<double>& mesh, const Affine& map) {
  std::vector<Vec3d> points;
  for (const Vec3d& p : mesh.points()) points.push_back(map.linear * p);
  std::vector<Mesh<double>::Index> triangles(mesh.triangles().begin(), mesh.triangles().end());
  if (determinant(map.linear) < 0)
    for (auto& t : triangles) std::swap(t[1], t[2]);  // a mirror turns the winding around
  return {Mesh<double>(std::move(points), std::move(triangles), mesh.sides(), mesh.solid()), {map.translation, {}}, ""};
}

/// A height field as triangles: under most maps it is no grid any more.
MappedShape mapped_height_field(const HeightField<double>& field, const Affine& map) {
  std::vector<Vec3d> points;
  std::vector<Mesh<double>::Index> triangles;
  for (std::uint32_t i = 0; i < field.triangle_numbers(); ++i) {
    if (!field.has_triangle(i)) continue;
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Vec3d& p : field.triangle(i)) points.push_back(p);
    triangles.push_back({first, first + 1, first + 2});
  }
  return mapped_mesh(Mesh<double>(std::move(points), std::move(triangles), field.sides()), map);
}

/// The half-space under any map: its normal goes with the inverse transpose, the product of the mapped X and Z axes.
MappedShape mapped_half_space(const Affine& map) {
  const Vec3d x = map.linear.column(0), z = map.linear.column(2);
  const Vec3d up = normalized(cross(z, x) * (determinant(map.linear) < 0 ? -1.0 : 1.0));
  const Vec3d side = normalized(x);
  return {
      HalfSpace<double>(), {map.translation, rotation_quaternion(Mat3d::from_columns(side, up, cross(side, up)))}, ""};
}

/// The shape under a scale without shear where it keeps its kind, or nothing.
std::optional<Shaped> scaled_kind(const Shaped& shape, const Vec3d& s) {
  const bool round = equal_scales(s.x, s.z), uniform = round && equal_scales(s.x, s.y);
  if (const auto* sphere = shape.as<Sphere<double>>()) {
    if (uniform) return Shaped(Sphere<double>(sphere->radius() * s.x));
    return Shaped(Ellipsoid<double>(s * sphere->radius()));
  }
  if (const auto* box = shape.as<Box<double>>()) return Shaped(Box<double>(scaled(box->half_extents() * 2.0, s)));
  if (const auto* r = shape.as<Rectangle<double>>()) {
    const Vec3d size = scaled(r->as_box().half_extents() * 2.0, s);
    return Shaped(Rectangle<double>(size.x, size.z));
  }
  if (const auto* c = shape.as<Capsule<double>>(); c && uniform)
    return Shaped(Capsule<double>(2 * c->half_height() * s.x, c->radius_bottom() * s.x, c->radius_top() * s.x));
  if (const auto* c = shape.as<Cylinder<double>>(); c && round)
    return Shaped(Cylinder<double>(2 * c->half_height() * s.y, c->radius_bottom() * s.x, c->radius_top() * s.x));
  return std::nullopt;
}

}  // namespace

MappedShape mapped(const Shaped& shape, const Affine& map) {
  if (shape.as<HalfSpace<double>>()) return mapped_half_space(map);
  if (const auto* mesh = shape.as<Mesh<double>>()) return mapped_mesh(*mesh, map);
  if (const auto* field = shape.as<HeightField<double>>()) return mapped_height_field(*field, map);
  if (const auto* hull = shape.as<ConvexHull<double>>()) return mapped_points(hull->data().vertices, map);
  if (const auto rigid = without_shear(map))
    if (const auto kind = scaled_kind(shape, rigid->scale)) return {*kind, rigid->pose, ""};
  if (const auto* box = shape.as<Box<double>>()) return mapped_points(box_corners(box->half_extents()), map);
  if (const auto* r = shape.as<Rectangle<double>>()) return mapped_points(box_corners(r->as_box().half_extents()), map);
  return sampled_hull(shape, map);
}

}  // namespace graze::io
