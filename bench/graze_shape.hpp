// A body of the comparison as a shape of Graze.
#pragma once

#include "graze/shape.hpp"
#include "pairs.hpp"

namespace graze::bench {

template <class T>
Shape<T> graze_shape(const Body& body) {
  const Vec3<T> s = converted<T>(body.size);
  switch (body.kind) {
  case Kind::sphere: return Sphere<T>(s.x);
  case Kind::capsule: return Capsule<T>(s.y, s.x);
  case Kind::box: return Box<T>(s);
  case Kind::cylinder: return Cylinder<T>(s.y, s.x);
  case Kind::cone: return Cylinder<T>(s.y, s.x, T(0));
  case Kind::ellipsoid: return Ellipsoid<T>(s);
  case Kind::half_space: return HalfSpace<T>();
  case Kind::hull:
  case Kind::triangle:
  case Kind::mesh: break;
  }
  std::vector<Vec3<T>> points;
  for (const Vec3d& p : body.corners->points) points.push_back(converted<T>(p));
  if (body.kind == Kind::triangle) return Triangle<T>(points[0], points[1], points[2]);
  if (body.kind == Kind::hull) return ConvexHull<T>(points);
  std::vector<typename Mesh<T>::Index> triangles;
  for (const auto& [i, j, k] : body.corners->faces)
    triangles.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(k)});
  return Mesh<T>(std::move(points), std::move(triangles));
}

}  // namespace graze::bench
