// Any bytes as the points of a hull, a solid polygon and a chain: refused or built, and then right: pieces convex and
// as large as the outline, and every answer finite and symmetric.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "graze/error.hpp"
#include "graze/plane/mass.hpp"
#include "graze/plane/query.hpp"

namespace {

using namespace graze::plane;

void require(bool holds) {
  if (!holds) __builtin_trap();
}

double doubled_area(const std::vector<Vec2d>& p) {
  double area = 0;
  for (std::size_t i = 0; i < p.size(); ++i) area += cross(p[i] - p[0], p[(i + 1) % p.size()] - p[0]);
  return area;
}

void ask(const Shaped& a, const Shaped& b, const Pose2d& pose) {
  const auto there = distance(a, Pose2d{}, b, pose), back = distance(b, pose, a, Pose2d{});
  require(std::isfinite(there.distance) && std::abs(length(there.normal) - 1) < 1e-9);
  const double size = extent(a) + extent(b) + length(pose.translation);
  // Of overlapping solid polygons the depth is a bound, and each order may find another one.
  if (there.distance > 0 || back.distance > 0) require(std::abs(there.distance - back.distance) <= 1e-9 * size);
  require(overlap(a, Pose2d{}, b, pose) == (there.distance <= 0));
  Manifolds<double> manifolds;
  contacts(a, Pose2d{}, b, pose, 0.1 * size, manifolds);
  for (const auto& m : manifolds)
    for (const auto& p : m.points) require(std::isfinite(p.distance) && m.points.size() <= 2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size < 6) return 0;
  // Small integers make collinear and equal points likely; the first byte chooses between them and raw floats.
  const bool raw = bytes[0] & 1;
  const Pose2d pose{{double(std::int8_t(bytes[1])), double(std::int8_t(bytes[2]))}, Rot2d::from_angle(bytes[3] / 40.0)};
  std::vector<Vec2d> points;
  const std::size_t step = raw ? 8 : 2;
  for (std::size_t i = 4; i + step <= size && points.size() < 60; i += step) {
    float f[2] = {float(std::int8_t(bytes[i])), float(std::int8_t(bytes[i + 1]))};
    if (raw) std::memcpy(f, bytes + i, 8);
    for (float& x : f)
      if (!std::isfinite(x) || std::abs(x) > 1e15f || std::abs(x) < 1e-15f) x = 0;
    points.push_back({double(f[0]), double(f[1])});
  }
  if (points.empty()) return 0;
  const Shaped hull{ConvexPolygon<double>(points)}, box{Box<double>({3, 2}), 0.5};
  ask(hull, box, pose);
  try {
    const Polygon<double> polygon(points);
    double pieces = 0, scale = 0;
    for (std::uint32_t i = 0; i < polygon.pieces().size(); ++i) {
      const auto piece = polygon.pieces().vertices(i);
      pieces += doubled_area({piece.begin(), piece.end()});
    }
    for (const Vec2d& p : points) scale = greatest(scale, length(p));
    require(std::abs(pieces - std::abs(doubled_area(points))) <= 1e-9 * scale * scale);
    ask(Shaped(polygon), box, pose);
    ask(Shaped(polygon), hull, pose);
  } catch (const graze::InvalidValue&) {
  }
  try {
    ask(Shaped(Chain<double>(points, bytes[0] & 2)), box, pose);
  } catch (const graze::InvalidValue&) {
  }
  return 0;
}
