#include "io/mesh_collider.hpp"

#include <map>
#include <tuple>

namespace graze::io {

namespace {

TriangleSoup welded(const TriangleSoup& soup) {
  TriangleSoup out;
  std::map<std::tuple<double, double, double>, std::uint32_t> place;
  std::vector<std::uint32_t> renamed;
  for (const Vec3d& p : soup.points) {
    const auto [found, fresh] = place.emplace(std::tuple{p.x, p.y, p.z}, static_cast<std::uint32_t>(out.points.size()));
    if (fresh) out.points.push_back(p);
    renamed.push_back(found->second);
  }
  for (const auto& t : soup.triangles) out.triangles.push_back({renamed[t[0]], renamed[t[1]], renamed[t[2]]});
  return out;
}

Shaped bounding_box(const std::vector<Vec3d>& points) {
  Aabbd box = Aabbd::empty();
  for (const Vec3d& p : points) box = merged(box, p);
  Shaped shape = Box<double>(box.extent());
  if (box.center() == Vec3d{}) return shape;
  // A box stands about its own origin; one beside it becomes a compound of one.
  return Compound<double>({Placed<double>{shape, {box.center(), {}}}});
}

Shaped bounding_ball(const std::vector<Vec3d>& points) {
  const auto furthest = [&](const Vec3d& from) {
    const Vec3d* best = &points[0];
    for (const Vec3d& p : points)
      if (length_squared(p - from) > length_squared(*best - from)) best = &p;
    return *best;
  };
  const Vec3d a = furthest(points[0]), b = furthest(a);
  Vec3d center = (a + b) * 0.5;
  double radius = length(b - a) / 2;
  for (const Vec3d& p : points) {
    const double l = length(p - center);
    if (l <= radius) continue;
    radius = (radius + l) / 2;
    center = p + (center - p) * (radius / l);
  }
  for (const Vec3d& p : points) radius = std::max(radius, length(p - center));
  return Sphere<double>(radius, center);
}

}  // namespace

Shaped mesh_collider(const TriangleSoup& soup, MeshColliders kind) {
  TriangleSoup mesh = welded(soup);
  switch (kind) {
  case MeshColliders::hull: return ConvexHull<double>(mesh.points);
  case MeshColliders::box: return bounding_box(mesh.points);
  case MeshColliders::sphere: return bounding_ball(mesh.points);
  default: return Mesh<double>(std::move(mesh.points), std::move(mesh.triangles));
  }
}

}  // namespace graze::io
