// Bullet in single precision, its usual build. Margins are 0, so that its shapes are those of everybody else: it rounds
// corners by 0.04 of the unit otherwise. Contacts and overlap come from the collision algorithm that its dispatcher
// finds for the pair, kept as a simulation keeps it; distance from its GJK with its EPA.
#ifdef GRAZE_BENCH_BULLET

#include <btBulletCollisionCommon.h>

#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>

#include "peer.hpp"

namespace graze::bench {

namespace {

btScalar number(double v) { return static_cast<btScalar>(v); }
btVector3 vector(const Vec3d& v) { return {number(v.x), number(v.y), number(v.z)}; }

/// Keeps only how deep, as the callback of Bullet's contactPairTest can.
class Deepest final : public btManifoldResult {
 public:
  using btManifoldResult::btManifoldResult;
  void addContactPoint(const btVector3&, const btVector3&, btScalar distance) override {
    deepest = std::min(deepest, distance);
  }
  btScalar deepest = BT_LARGE_FLOAT;
};

class Bullet {
 public:
  static constexpr const char* name = "bullet";
  static constexpr bool single_precision = sizeof(btScalar) == sizeof(float);
  static std::string version() { return GRAZE_BENCH_BULLET_VERSION; }

  Bullet() : dispatcher_(&configuration_) {}
  Bullet(const Bullet&) = delete;
  Bullet& operator=(const Bullet&) = delete;
  ~Bullet() { clear(); }

  bool prepare(std::span<const Pair> pairs) {
    clear();
    for (const Pair& pair : pairs)
      for (const Body* body : {&pair.a, &pair.b}) {
        auto shape = make(*body);
        if (!shape) return false;
        const Quatd& q = body->pose.rotation;
        auto object = std::make_unique<btCollisionObject>();
        object->setCollisionShape(shape.get());
        object->setWorldTransform(
            btTransform(btQuaternion(number(q.x), number(q.y), number(q.z), number(q.w)).normalized(),
                        vector(body->pose.translation)));
        shapes_.push_back(std::move(shape));
        objects_.push_back(std::move(object));
      }
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto a = wrapped(2 * i), b = wrapped(2 * i + 1);
      algorithms_.push_back(dispatcher_.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS));
    }
    return true;
  }
  /// Its plane has no support function, which its GJK asks for.
  bool has(Query query) const {
    return query != Query::distance ||
           std::all_of(shapes_.begin(), shapes_.end(), [](const auto& shape) { return shape->isConvex(); });
  }

  bool overlap(std::size_t i) {
    const auto a = wrapped(2 * i), b = wrapped(2 * i + 1);
    Deepest result(&a, &b);
    algorithms_[i]->processCollision(&a, &b, info_, &result);
    return result.deepest <= 0;
  }
  double distance(std::size_t i) {
    const auto& a = static_cast<const btConvexShape&>(*shapes_[2 * i]);
    const auto& b = static_cast<const btConvexShape&>(*shapes_[2 * i + 1]);
    btGjkPairDetector detector(&a, &b, &simplex_, &penetration_);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = objects_[2 * i]->getWorldTransform();
    input.m_transformB = objects_[2 * i + 1]->getWorldTransform();
    btPointCollector result;
    detector.getClosestPoints(input, result, nullptr);
    return result.m_hasResult ? static_cast<double>(result.m_distance) : std::numeric_limits<double>::quiet_NaN();
  }
  Contacts contacts(std::size_t i) {
    // What it keeps of the last call is for bodies that move; these are asked about as if for the first time.
    for (int m = 0; m < manifolds_of(i); ++m) manifolds_[m]->clearManifold();
    const auto a = wrapped(2 * i), b = wrapped(2 * i + 1);
    btManifoldResult result(&a, &b);
    algorithms_[i]->processCollision(&a, &b, info_, &result);
    Contacts found;
    for (int m = 0; m < manifolds_of(i); ++m)
      for (int k = 0; k < manifolds_[m]->getNumContacts(); ++k) {
        const double depth = static_cast<double>(manifolds_[m]->getContactPoint(k).getDistance());
        if (depth > 0) continue;  // it also keeps points that are near
        const btVector3& normal = manifolds_[m]->getContactPoint(k).m_normalWorldOnB;
        found.normal = {static_cast<double>(normal.x()), static_cast<double>(normal.y()),
                        static_cast<double>(normal.z())};
        ++found.count;
        found.deepest = std::min(found.deepest, depth);
      }
    return found;
  }

 private:
  btCollisionObjectWrapper wrapped(std::size_t k) const {
    const btCollisionObject& object = *objects_[k];
    return {nullptr, object.getCollisionShape(), &object, object.getWorldTransform(), -1, -1};
  }
  int manifolds_of(std::size_t i) {
    manifolds_.resize(0);
    algorithms_[i]->getAllContactManifolds(manifolds_);
    return manifolds_.size();
  }
  void clear() {
    for (btCollisionAlgorithm* algorithm : algorithms_) {
      algorithm->~btCollisionAlgorithm();
      dispatcher_.freeCollisionAlgorithm(algorithm);
    }
    algorithms_.clear();
    objects_.clear();
    shapes_.clear();
  }

  static std::unique_ptr<btCollisionShape> make(const Body& body) {
    const Vec3d& s = body.size;
    std::unique_ptr<btCollisionShape> shape;
    switch (body.kind) {
    case Kind::sphere: return std::make_unique<btSphereShape>(number(s.x));
    case Kind::capsule: return std::make_unique<btCapsuleShape>(number(s.x), number(s.y));
    case Kind::box: shape = std::make_unique<btBoxShape>(vector(s) / 2); break;
    case Kind::cylinder: shape = std::make_unique<btCylinderShape>(vector({s.x, s.y / 2, s.x})); break;
    case Kind::cone: shape = std::make_unique<btConeShape>(number(s.x), number(s.y)); break;
    case Kind::ellipsoid: return nullptr;
    case Kind::half_space: shape = std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), number(0)); break;
    case Kind::triangle:
      shape = std::make_unique<btTriangleShape>(vector(body.points[0]), vector(body.points[1]), vector(body.points[2]));
      break;
    case Kind::hull: {
      auto hull = std::make_unique<btConvexHullShape>();
      for (const Vec3d& p : body.points) hull->addPoint(vector(p), false);
      hull->recalcLocalAabb();
      shape = std::move(hull);
    }
    }
    shape->setMargin(0);
    return shape;
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDispatcherInfo info_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver penetration_;
  btManifoldArray manifolds_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
  std::vector<btCollisionAlgorithm*> algorithms_;
};

const Registered<Bullet> registered;

}  // namespace

}  // namespace graze::bench

#endif
