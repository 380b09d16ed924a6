#include <algorithm>
#include <cmath>

#include "graze/angles.hpp"
#include "graze/tessellate.hpp"
#include "plane/leaves.hpp"

namespace graze {

namespace {

using plane::Core;
using plane::CoreKind;
using plane::Pose2d;
using plane::Vec2d;

constexpr int arc_directions = 72;

Vec3d in_space(const Vec2d& v) { return {v.x, v.y, 0}; }

void add_loop(const std::vector<Vec2d>& loop, const Pose2d& pose, Polygons& out) {
  std::vector<std::uint32_t>& numbers = out.loops.emplace_back();
  for (const Vec2d& v : loop) {
    numbers.push_back(static_cast<std::uint32_t>(out.points.size()));
    out.points.push_back(in_space(transform(pose, v)));
  }
}

/// The outline around a rounded core, by directions: those of an arc, and both ends of an edge along its own.
template <class T>
std::vector<Vec2d> around(const Core<T>& core) {
  if (core.kind == CoreKind::polygon && core.radius == 0) {
    std::vector<Vec2d> out;
    for (std::uint32_t i = 0; i < core.count; ++i) out.push_back(core.vertex(i));
    return out;
  }
  struct At {
    double angle;
    Vec2d point;
  };
  std::vector<At> points;
  for (int i = 0; i < arc_directions; ++i) {
    const double angle = 6.283185307179586 * (i + 0.5) / arc_directions - 3.141592653589793;
    const CosineSine turn = cosine_sine(angle);
    const Vec2d n{turn.cosine, turn.sine};
    points.push_back({angle, plane::support(core, n).point + n * core.radius});
  }
  if (core.kind == CoreKind::polygon && core.count > 1)
    for (std::uint32_t i = 0; i < core.count; ++i)
      if (const Vec2d e = core.edge(i); length_squared(e) > 0) {
        const Vec2d n = normalized(plane::right(e));
        const double angle = angle_of(n.x, n.y);
        points.push_back({angle, core.vertex(i) + n * core.radius});
        points.push_back({angle, core.vertex(core.next(i)) + n * core.radius});
      }
  std::stable_sort(points.begin(), points.end(), [](const At& p, const At& q) { return p.angle < q.angle; });
  std::vector<Vec2d> out;
  out.reserve(points.size());
  for (const At& p : points) out.push_back(p.point);
  return out;
}

void add_half_plane(double top, const Pose2d& pose, const Vec3d& center, double size, Polygons& out) {
  const Vec2d own = inverse_transform(pose, Vec2d{center.x, center.y});
  add_loop({{own.x - size, top - size / 2}, {own.x + size, top - size / 2}, {own.x + size, top}, {own.x - size, top}},
           pose, out);
}

/// Adds a solid polygon without rounding as it was given, without its cuts.
template <class T>
void add_outline(const plane::Pieces<T>& pieces, const Pose2d& pose, Polygons& out) {
  std::vector<Vec2d> loop;
  for (const plane::Vec2<T>& v : pieces.outline_vertices()) loop.push_back(plane::converted<double>(v));
  add_loop(loop, pose, out);
}

template <class T>
void add(const plane::Shape<T>& shape, const Pose2d& pose, const Vec3d& center, double size, Polygons& out,
         double grown = 0) {
  const double rounding = double(shape.rounding()) + grown;
  if (const auto* compound = shape.template as<plane::Compound<T>>()) {
    for (const plane::Placed<T>& child : compound->children())
      add(child.shape, compose(pose, plane::at_unit(child.pose)), center, size, out, rounding);
    return;
  }
  if (const auto* polygon = shape.template as<plane::Polygon<T>>(); polygon && rounding == 0)
    return add_outline(polygon->pieces(), pose, out);
  const auto add_leaf = [&](const Core<T>& core, const Pose2d& at, double, std::uint32_t) {
    core.kind == CoreKind::half_plane ? add_half_plane(core.radius, at, center, size, out)
                                      : add_loop(around(core), at, out);
  };
  plane::for_each_leaf(shape, pose, plane::Everywhere{}, add_leaf, grown);
}

}  // namespace

template <class T>
Polygons tessellate(const plane::Shape<T>& shape, const plane::Pose2<T>& pose, const Vec3d& center,
                    double half_plane_size) {
  Polygons out;
  out.closed = false;
  add(shape, plane::at_unit(pose), center, half_plane_size, out);
  return out;
}

template Polygons tessellate(const plane::Shape<float>&, const plane::Pose2<float>&, const Vec3d&, double);
template Polygons tessellate(const plane::Shape<double>&, const plane::Pose2<double>&, const Vec3d&, double);

}  // namespace graze
