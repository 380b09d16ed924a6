// Bullet in single precision, its usual build. Contacts and overlap come from the collision algorithm that its
// dispatcher finds for the pair, kept as a simulation keeps it; distance from its GJK with its EPA; rays and casts from
// the functions that its world asks a single body with.
#ifdef GRAZE_BENCH_BULLET

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>

#include "bullet_shape.hpp"
#include "peer.hpp"

namespace graze::bench {

namespace {

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
  ~Bullet() {
    for (btCollisionAlgorithm* algorithm : algorithms_) {
      algorithm->~btCollisionAlgorithm();
      dispatcher_.freeCollisionAlgorithm(algorithm);
    }
  }

  bool prepare(std::span<const Pair> pairs) {
    OncePerCorners<btCollisionShape*> shared;
    const auto make = [&](const Body& body) {
      shapes_.push_back(bullet::shape(body));
      return shapes_.back().get();
    };
    for (const Pair& pair : pairs) {
      for (const Body* body : {&pair.a, &pair.b}) {
        btCollisionShape* shape = shared.of(*body, make);
        if (!shape) return false;
        objects_.push_back(std::make_unique<btCollisionObject>());
        objects_.back()->setCollisionShape(shape);
        objects_.back()->setWorldTransform(bullet::transform(body->pose));
      }
      if (max_abs(pair.motion) > 0) ways_.push_back(bullet::vector(pair.motion));
    }
    if (!ways_.empty()) return true;
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
    const btConvexShape &a = convex(2 * i), &b = convex(2 * i + 1);
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
  double raycast(std::size_t i) {
    btTransform from = objects_[2 * i + 1]->getWorldTransform(), to = from;
    from.setBasis(btMatrix3x3::getIdentity());
    to.setOrigin(from.getOrigin() + ways_[i]);
    btCollisionWorld::ClosestRayResultCallback result(from.getOrigin(), to.getOrigin());
    btCollisionObject& object = *objects_[2 * i];
    btCollisionWorld::rayTestSingle(from, to, &object, object.getCollisionShape(), object.getWorldTransform(), result);
    return result.hasHit() ? static_cast<double>(result.m_closestHitFraction) : never;
  }
  double cast(std::size_t i) {
    const btTransform& from = objects_[2 * i]->getWorldTransform();
    btTransform to = from;
    to.setOrigin(from.getOrigin() + ways_[i]);
    btCollisionWorld::ClosestConvexResultCallback result(from.getOrigin(), to.getOrigin());
    btCollisionObject& object = *objects_[2 * i + 1];
    btCollisionWorld::objectQuerySingle(&convex(2 * i), from, to, &object, object.getCollisionShape(),
                                        object.getWorldTransform(), result, 0);
    return result.hasHit() ? static_cast<double>(result.m_closestHitFraction) : never;
  }

 private:
  const btConvexShape& convex(std::size_t k) const {
    return static_cast<const btConvexShape&>(*objects_[k]->getCollisionShape());
  }
  btCollisionObjectWrapper wrapped(std::size_t k) const {
    const btCollisionObject& object = *objects_[k];
    return {nullptr, object.getCollisionShape(), &object, object.getWorldTransform(), -1, -1};
  }
  int manifolds_of(std::size_t i) {
    manifolds_.resize(0);
    algorithms_[i]->getAllContactManifolds(manifolds_);
    return manifolds_.size();
  }
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDispatcherInfo info_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver penetration_;
  btManifoldArray manifolds_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
  std::vector<btVector3> ways_;
  std::vector<btCollisionAlgorithm*> algorithms_;
};

const Registered<Bullet> registered;

}  // namespace

}  // namespace graze::bench

#endif
