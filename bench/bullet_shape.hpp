// A body of the benchmarks as a shape of Bullet.
#pragma once

#ifdef GRAZE_BENCH_BULLET

#include <btBulletCollisionCommon.h>

#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <memory>

#include "pairs.hpp"

namespace graze::bench::bullet {

inline btScalar number(double v) { return static_cast<btScalar>(v); }
inline btVector3 vector(const Vec3d& v) { return {number(v.x), number(v.y), number(v.z)}; }
inline btTransform transform(const Posed& pose) {
  const Quatd& q = pose.rotation;
  return btTransform(btQuaternion(number(q.x), number(q.y), number(q.z), number(q.w)).normalized(),
                     vector(pose.translation));
}

/// A mesh with the triangles that it points to.
class MeshShape final : private std::unique_ptr<btTriangleMesh>, public btBvhTriangleMeshShape {
 public:
  explicit MeshShape(std::unique_ptr<btTriangleMesh> triangles)
      : std::unique_ptr<btTriangleMesh>(std::move(triangles)), btBvhTriangleMeshShape(get(), true) {}
};

inline std::unique_ptr<btCollisionShape> mesh_shape(const Corners& corners) {
  auto triangles = std::make_unique<btTriangleMesh>();
  for (const auto& [i, j, k] : corners.faces)
    triangles->addTriangle(vector(corners.points[i]), vector(corners.points[j]), vector(corners.points[k]));
  return std::make_unique<MeshShape>(std::move(triangles));
}

/// Null for what it lacks. Margins are 0, so that its shapes are those of everybody else: it rounds corners by 0.04 of
/// the unit otherwise.
inline std::unique_ptr<btCollisionShape> shape(const Body& body) {
  const Vec3d& s = body.size;
  std::unique_ptr<btCollisionShape> made;
  switch (body.kind) {
  case Kind::sphere: return std::make_unique<btSphereShape>(number(s.x));
  case Kind::capsule: return std::make_unique<btCapsuleShape>(number(s.x), number(s.y));
  case Kind::box: made = std::make_unique<btBoxShape>(vector(s) / 2); break;
  case Kind::cylinder: made = std::make_unique<btCylinderShape>(vector({s.x, s.y / 2, s.x})); break;
  case Kind::cone: made = std::make_unique<btConeShape>(number(s.x), number(s.y)); break;
  case Kind::ellipsoid: return nullptr;
  case Kind::half_space: made = std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), number(0)); break;
  case Kind::triangle: {
    const auto& p = body.corners->points;
    made = std::make_unique<btTriangleShape>(vector(p[0]), vector(p[1]), vector(p[2]));
    break;
  }
  case Kind::mesh: made = mesh_shape(*body.corners); break;
  case Kind::hull: {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec3d& p : body.corners->points) hull->addPoint(vector(p), false);
    hull->recalcLocalAabb();
    made = std::move(hull);
  }
  }
  made->setMargin(0);
  return made;
}

}  // namespace graze::bench::bullet

#endif
