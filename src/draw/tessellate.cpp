#include "graze/tessellate.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "graze/angles.hpp"

namespace graze {

namespace {

constexpr int meridians = 24, parallels = 11;

/// Directions along meridians about Y, so that the rims of cylinders and cones are regular polygons.
std::vector<Vec3d> globe() {
  using std::numbers::pi;
  std::vector<Vec3d> out{{0, 1, 0}, {0, -1, 0}};
  for (int i = 1; i <= parallels; ++i)
    for (int k = 0; k < meridians; ++k) {
      const CosineSine polar = cosine_sine(pi * i / (parallels + 1)), around = cosine_sine(2 * pi * k / meridians);
      out.push_back({polar.sine * around.cosine, polar.cosine, polar.sine * around.sine});
    }
  return out;
}

template <class T>
Vec3d in_world(const Posed& pose, const Vec3<T>& p) {
  return transform(pose, converted<double>(p));
}

/// A hull by its faces; one that is a segment or a point by that alone.
template <class T>
Polygons of_hull(const ConvexHull<T>& hull, const Posed& pose) {
  Polygons out;
  const auto& data = hull.data();
  for (const Vec3<T>& v : data.vertices) out.points.push_back(in_world(pose, v));
  for (std::size_t f = 0; f < data.planes.size(); ++f) {
    const auto loop = data.loop(f);
    out.loops.emplace_back(loop.begin(), loop.end());
  }
  if (out.loops.empty()) {
    std::vector<std::uint32_t>& thin = out.loops.emplace_back(out.points.size());
    std::iota(thin.begin(), thin.end(), 0u);
  }
  return out;
}

template <class T>
Polygons of_mesh(const Mesh<T>& mesh, const Posed& pose) {
  Polygons out;
  out.closed = false;
  for (const Vec3<T>& p : mesh.points()) out.points.push_back(in_world(pose, p));
  for (const auto& t : mesh.triangles()) out.loops.emplace_back(t.begin(), t.end());
  return out;
}

/// Two triangles for each cell that is no hole.
template <class T>
Polygons of_height_field(const HeightField<T>& field, const Posed& pose) {
  Polygons out;
  out.closed = false;
  for (std::uint32_t i = 0; i < field.triangle_numbers(); ++i) {
    if (!field.has_triangle(i)) continue;
    const auto first = static_cast<std::uint32_t>(out.points.size());
    for (const Vec3<T>& p : field.triangle(i)) out.points.push_back(in_world(pose, p));
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
template <class T>
Polygons sampled(const Shape<T>& shape, const Posed& pose) {
  static const std::vector<Vec3d> directions = globe();
  std::vector<Vec3d> points;
  points.reserve(directions.size());
  for (const Vec3d& d : directions) points.push_back(converted<double>(support(shape, converted<T>(d))));
  Polygons out = of_hull(ConvexHull<double>(points), pose);
  const bool flat =
      shape.template as<Box<T>>() || shape.template as<Rectangle<T>>() || shape.template as<Triangle<T>>();
  out.smooth = !flat || shape.rounding() > T(0);
  return out;
}

template <class T>
Polygons of_shape(const Shape<T>& shape, const Posed& pose, const Vec3d& center, double half_space_size) {
  if (shape.template as<HalfSpace<T>>()) return of_half_space(pose, double(shape.rounding()), center, half_space_size);
  if (const auto* mesh = shape.template as<Mesh<T>>()) return of_mesh(*mesh, pose);
  if (const auto* field = shape.template as<HeightField<T>>()) return of_height_field(*field, pose);
  if (const auto* compound = shape.template as<Compound<T>>()) {
    Polygons out;
    for (const Placed<T>& child : compound->children())
      append(out, of_shape(child.shape, compose(pose, converted<double>(child.pose)), center, half_space_size));
    return out;
  }
  const auto* hull = shape.template as<ConvexHull<T>>();
  return hull && shape.rounding() == T(0) ? of_hull(*hull, pose) : sampled(shape, pose);
}

}  // namespace

template <class T>
Polygons tessellate(const Shape<T>& shape, const Pose<T>& pose, const Vec3d& center, double half_space_size) {
  return of_shape(shape, converted<double>(pose), center, half_space_size);
}

template Polygons tessellate(const Shape<float>&, const Pose<float>&, const Vec3d&, double);
template Polygons tessellate(const Shape<double>&, const Pose<double>&, const Vec3d&, double);

}  // namespace graze
