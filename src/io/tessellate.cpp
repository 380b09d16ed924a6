#include "graze/io/tessellate.hpp"

#include <cmath>

namespace graze::io {

namespace {

constexpr int meridians = 24, parallels = 11;

/// Directions along meridians about Y, so that the rims of cylinders and cones are regular polygons.
std::vector<Vec3d> globe() {
  const double pi = std::acos(-1.0);
  std::vector<Vec3d> out{{0, 1, 0}, {0, -1, 0}};
  for (int i = 1; i <= parallels; ++i)
    for (int k = 0; k < meridians; ++k) {
      const double polar = pi * i / (parallels + 1), around = 2 * pi * k / meridians;
      out.push_back({std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around)});
    }
  return out;
}

Polygons of_hull(const ConvexHull<double>& hull, const Posed& pose) {
  Polygons out;
  const auto& data = hull.data();
  for (const Vec3d& v : data.vertices) out.points.push_back(transform(pose, v));
  for (std::size_t f = 0; f < data.planes.size(); ++f) {
    const auto loop = data.loop(f);
    out.loops.emplace_back(loop.begin(), loop.end());
  }
  return out;
}

Polygons of_mesh(const Mesh<double>& mesh, const Posed& pose) {
  Polygons out;
  out.closed = false;
  for (const Vec3d& p : mesh.points()) out.points.push_back(transform(pose, p));
  for (const auto& t : mesh.triangles()) out.loops.emplace_back(t.begin(), t.end());
  return out;
}

/// Two triangles for each cell that is no hole.
Polygons of_height_field(const HeightField<double>& field, const Posed& pose) {
  Polygons out;
  out.closed = false;
  for (std::uint32_t i = 0; i < field.triangle_numbers(); ++i) {
    if (!field.has_triangle(i)) continue;
    const auto first = static_cast<std::uint32_t>(out.points.size());
    for (const Vec3d& p : field.triangle(i)) out.points.push_back(transform(pose, p));
    out.loops.push_back({first, first + 1, first + 2});
  }
  return out;
}

Polygons of_half_space(const Posed& pose, double lift, const Vec3d& center, double size) {
  const Vec3d up = rotate(pose.rotation, Vec3d{0, 1, 0}), u = any_perpendicular(up), v = cross(up, u);
  const Vec3d foot = center - up * (dot(up, center - pose.translation) - lift);
  Polygons out;
  out.closed = false;
  for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    out.points.push_back(foot + u * (size * s) + v * (size * t));
  out.loops = {{0, 1, 2, 3}};
  return out;
}

void append(Polygons& to, const Polygons& more) {
  const auto first = static_cast<std::uint32_t>(to.points.size());
  to.points.insert(to.points.end(), more.points.begin(), more.points.end());
  for (const auto& loop : more.loops) {
    to.loops.push_back(loop);
    for (std::uint32_t& i : to.loops.back()) i += first;
  }
  to.smooth = to.smooth || more.smooth;
  to.closed = to.closed && more.closed;
}

/// The hull of the shape's support points: exact where it has corners, sampled where it is curved.
Polygons sampled(const Shaped& shape, const Posed& pose) {
  static const std::vector<Vec3d> directions = globe();
  std::vector<Vec3d> points;
  points.reserve(directions.size());
  for (const Vec3d& d : directions) points.push_back(support(shape, d));
  Polygons out = of_hull(ConvexHull<double>(points), pose);
  const bool flat = shape.as<Box<double>>() || shape.as<Rectangle<double>>() || shape.as<Triangle<double>>();
  out.smooth = !flat || shape.rounding() > 0;
  return out;
}

}  // namespace

Polygons tessellate(const Shaped& shape, const Posed& pose, const Vec3d& center, double half_space_size) {
  if (shape.as<HalfSpace<double>>()) return of_half_space(pose, shape.rounding(), center, half_space_size);
  if (const auto* mesh = shape.as<Mesh<double>>()) return of_mesh(*mesh, pose);
  if (const auto* field = shape.as<HeightField<double>>()) return of_height_field(*field, pose);
  if (const auto* compound = shape.as<Compound<double>>()) {
    Polygons out;
    for (const Placed<double>& child : compound->children())
      append(out, tessellate(child.shape, compose(pose, child.pose), center, half_space_size));
    return out;
  }
  const auto* hull = shape.as<ConvexHull<double>>();
  return hull && shape.rounding() == 0 ? of_hull(*hull, pose) : sampled(shape, pose);
}

}  // namespace graze::io
