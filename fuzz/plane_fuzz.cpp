// Any bytes as the points of a hull, a solid polygon and a chain: refused or built, and then right: pieces convex and
// as large as the outline, every answer finite and symmetric, a batch as each pair alone, rays and casts that meet the
// surface where they say.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "graze/error.hpp"
#include "graze/plane/batch.hpp"
#include "graze/plane/cast.hpp"
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

/// A ray at the shape hits where a point of it is, and a batch says what the ray alone does.
void ask_rays(const Shaped& shape, const Pose2d& pose, double size) {
  std::vector<Ray<double>> rays;
  for (const Vec2d& d : {Vec2d{1, 0}, {-1, 0.5}, {0, 1}, {0.3, -1}, {1, 1}, {-1, -1}})
    rays.push_back({pose.translation - d * (2 * size + 1), d});
  std::vector<std::optional<RayHit<double>>> hits(rays.size());
  raycast<double>(shape, pose, rays, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto alone = raycast(shape, pose, rays[i]);
    require(alone.has_value() == hits[i].has_value());
    if (!alone) continue;
    require(alone->t == hits[i]->t && alone->point == hits[i]->point && alone->normal == hits[i]->normal);
    require(std::isfinite(alone->t) && std::abs(length(alone->normal) - 1) < 1e-9);
    require(std::abs(closest(shape, pose, alone->point).distance) <= 1e-9 * (3 * size + 1 + length(pose.translation)));
  }
}

/// Two shapes that meet on the way touch there, and two that do not never overlap.
void ask_cast(const Shaped& a, const Shaped& b, const Pose2d& pose, double turn, double size) {
  const Velocity<double> motion{-pose.translation, turn};
  const auto hit = cast(a, Pose2d{}, {}, b, pose, motion, 1.0);
  if (hit && hit->status != graze::Status::converged) return;
  const double far = size + length(pose.translation);
  if (!hit) {
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
      require(distance(a, Pose2d{}, b, pose_at(pose, motion, t)).distance > -1e-9 * far);
    return;
  }
  require(hit->t >= 0 && hit->t <= 1 && std::abs(length(hit->normal) - 1) < 1e-9);
  const double there = distance(a, Pose2d{}, b, pose_at(pose, motion, hit->t)).distance;
  require(there <= 1e-6 * far && (hit->t == 0 || there >= -1e-6 * far));
}

/// A batch gives what the pair alone does, whatever stands beside it.
void ask_batch(const Shaped& a, const Shaped& b, const Pose2d& pose, double margin) {
  const std::vector<Shaped> shapes{a, b};
  const std::vector<Pose2d> poses{Pose2d{}, pose};
  const Bodies<double> bodies(shapes, poses);
  const std::vector<graze::IdPair> pairs{{0, 1}, {1, 0}, {0, 0}, {1, 1}, {0, 1}};
  std::vector<Distance<double>> distances;
  BatchContacts<double> found;
  distance(Batch<double>(bodies, bodies, pairs), distances);
  contacts(Batch<double>(bodies, bodies, pairs), margin, found);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [p, q] = pairs[i];
    const auto alone = distance(shapes[p], poses[p], shapes[q], poses[q]);
    require(distances[i].distance == alone.distance && distances[i].normal == alone.normal);
    require(distances[i].a == alone.a && distances[i].b == alone.b);
    Manifolds<double> manifolds;
    require(contacts(shapes[p], poses[p], shapes[q], poses[q], margin, manifolds) == found.pairs[i].overlap);
    require(found.manifolds_of(i).size() == manifolds.size());
    for (std::size_t m = 0; m < manifolds.size(); ++m) {
      const auto points = found.points_of(found.manifolds_of(i)[m]);
      require(points.size() == manifolds[m].points.size());
      for (std::size_t k = 0; k < points.size(); ++k)
        require(points[k].a == manifolds[m].points[k].a && points[k].feature == manifolds[m].points[k].feature);
    }
  }
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
  ask_batch(a, b, pose, 0.1 * size);
  ask_rays(a, pose, size);
  ask_cast(a, b, pose, 0, size);
  ask_cast(a, b, pose, 1, size);
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
    const Shaped chain{Chain<double>(points, bytes[0] & 2, bytes[0] & 4 ? ChainSides::one : ChainSides::both)};
    ask(chain, box, pose);
    ask(chain, hull, pose);
  } catch (const graze::InvalidValue&) {
  }
  return 0;
}
