#include "io/plane_outline.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "plane/leaves.hpp"

namespace graze::io {

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

/// Around a rounded core by directions: those of an arc, and both ends of an edge along its own.
std::vector<Vec2d> around(const Core<double>& core) {
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
    const Vec2d n{std::cos(angle), std::sin(angle)};
    points.push_back({angle, plane::support(core, n).point + n * core.radius});
  }
  if (core.kind == CoreKind::polygon && core.count > 1)
    for (std::uint32_t i = 0; i < core.count; ++i)
      if (const Vec2d e = core.edge(i); length_squared(e) > 0) {
        const Vec2d n = normalized(plane::right(e));
        const double angle = std::atan2(n.y, n.x);
        points.push_back({angle, core.vertex(i) + n * core.radius});
        points.push_back({angle, core.vertex(core.next(i)) + n * core.radius});
      }
  std::stable_sort(points.begin(), points.end(), [](const At& p, const At& q) { return p.angle < q.angle; });
  std::vector<Vec2d> out;
  out.reserve(points.size());
  for (const At& p : points) out.push_back(p.point);
  return out;
}

void add_half_plane(const Core<double>& core, const Pose2d& pose, const Vec3d& center, double size, Polygons& out) {
  const Vec2d own = inverse_transform(pose, Vec2d{center.x, center.y});
  const double top = core.radius;
  add_loop({{own.x - size, top - size / 2}, {own.x + size, top - size / 2}, {own.x + size, top}, {own.x - size, top}},
           pose, out);
}

/// A solid polygon without rounding as it was given, without its cuts.
void add_outline(const plane::Pieces<double>& pieces, const Pose2d& pose, Polygons& out) {
  std::map<std::uint32_t, Vec2d> vertices;
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = 0; k < pieces.vertices(i).size(); ++k)
      vertices.emplace(pieces.outline(i)[k].number, pieces.vertices(i)[k]);
  std::vector<Vec2d> loop;
  loop.reserve(vertices.size());
  for (const auto& [number, v] : vertices) loop.push_back(v);
  add_loop(loop, pose, out);
}

void add(const plane::Shaped& shape, const Pose2d& pose, const Vec3d& center, double size, Polygons& out) {
  if (const auto* compound = shape.as<plane::Compound<double>>()) {
    for (const plane::Placed<double>& child : compound->children())
      add(child.shape, compose(pose, child.pose), center, size, out);
    return;
  }
  if (const auto* polygon = shape.as<plane::Polygon<double>>(); polygon && shape.rounding() == 0)
    return add_outline(polygon->pieces(), pose, out);
  plane::for_each_leaf(shape, pose, [&](const Core<double>& core, const Pose2d& at, double, std::uint32_t) {
    core.kind == CoreKind::half_plane ? add_half_plane(core, at, center, size, out) : add_loop(around(core), at, out);
  });
}

}  // namespace

Polygons plane_polygons(const plane::Shaped& shape, const plane::Pose2d& pose, const Vec3d& center,
                        double half_plane_size) {
  Polygons out;
  out.closed = false;
  add(shape, pose, center, half_plane_size, out);
  return out;
}

Aabbd plane_bounds(const plane::Shaped& shape, const plane::Pose2d& pose) {
  const plane::Aabb2<double> box = plane::bounds(shape, pose);
  return {in_space(box.lower), in_space(box.upper)};
}

bool has_straight_sides(const plane::Shaped& shape) {
  bool straight = true;
  plane::for_each_leaf(shape, Pose2d{}, [&](const Core<double>& core, const Pose2d&, double, std::uint32_t) {
    straight = straight && (core.kind == CoreKind::half_plane || (core.kind == CoreKind::polygon && core.radius == 0));
  });
  return straight;
}

}  // namespace graze::io
