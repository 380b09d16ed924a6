// Every pair of shapes and every query, beside Bullet, ODE and FCL on the same pairs.
//
// Names read library/query/pair. `overlapping` is the share of pairs that the library says touch: about half, and what
// differs between libraries here is a wrong answer of one of them. Compare rates within one run: machines are noisy.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "graze/query.hpp"

#ifdef GRAZE_BENCH_BULLET
#include <btBulletCollisionCommon.h>
#endif
#ifdef GRAZE_BENCH_ODE
#include <ode/ode.h>
#endif
#ifdef GRAZE_BENCH_FCL
#include <fcl/fcl.h>
#endif

namespace {

using graze::Posed;
using graze::Quatd;
using graze::Vec3d;

enum class Kind { sphere, capsule, box, cylinder, cone, ellipsoid, hull };
constexpr Kind kinds[] = {Kind::sphere, Kind::capsule,   Kind::box, Kind::cylinder,
                          Kind::cone,   Kind::ellipsoid, Kind::hull};
constexpr const char* names[] = {"sphere", "capsule", "box", "cylinder", "cone", "ellipsoid", "hull32"};
constexpr std::size_t pair_count = 1000;

/// One placed shape, told in numbers that every library understands; heights along Y.
struct Body {
  Kind kind;
  Vec3d size;
  std::vector<Vec3d> points;
  Posed pose;
};
using Pair = std::array<Body, 2>;

class Generator {
 public:
  double number(double low, double high) { return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53; }
  Vec3d vector(double reach) {
    const double x = number(-reach, reach), y = number(-reach, reach);
    return {x, y, number(-reach, reach)};
  }
  Body body(Kind kind, double reach) {
    Body b{kind, {number(0.3, 1), number(0.3, 1), number(0.3, 1)}, {}, {}};
    for (int i = 0; kind == Kind::hull && i < 32; ++i) b.points.push_back(normalized(vector(1)) * 0.6);
    const Vec3d v = vector(1);
    b.pose = {vector(reach), normalized(Quatd{v.x, v.y, v.z, number(-1, 1)})};
    return b;
  }

 private:
  std::mt19937_64 random_{7};
};

std::vector<Pair> make_pairs(Kind a, Kind b) {
  Generator random;
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < pair_count; ++i) pairs.push_back({random.body(a, 0.0), random.body(b, 0.75)});
  return pairs;
}

template <class T>
graze::Shape<T> graze_shape(const Body& b) {
  const graze::Vec3<T> s = graze::cast<T>(b.size);
  const T half(0.5f);
  switch (b.kind) {
  case Kind::sphere: return graze::Sphere<T>(s.x * half);
  case Kind::capsule: return graze::Capsule<T>(s.y, s.x * half);
  case Kind::box: return graze::Box<T>(s);
  case Kind::cylinder: return graze::Cylinder<T>(s.y, s.x * half);
  case Kind::cone: return graze::Cylinder<T>(s.y, s.x * half, T(0));
  case Kind::ellipsoid: return graze::Ellipsoid<T>(s * half);
  default: {
    std::vector<graze::Vec3<T>> points;
    for (const Vec3d& p : b.points) points.push_back(graze::cast<T>(p));
    return graze::ConvexHull<T>(points);
  }
  }
}

/// A library: shapes built once, then asked by number. Every query tells whether the pair touches.
class Library {
 public:
  virtual ~Library() = default;
  virtual bool overlap(std::size_t pair) = 0;
  virtual bool distance(std::size_t pair) = 0;
  virtual bool contacts(std::size_t pair) = 0;
};

template <class T>
class Graze final : public Library {
 public:
  explicit Graze(const std::vector<Pair>& pairs) {
    for (const Pair& p : pairs)
      for (const Body& b : p) {
        shapes_.push_back(graze_shape<T>(b));
        poses_.push_back(graze::cast<T>(b.pose));
      }
  }
  bool overlap(std::size_t i) override {
    return graze::overlap(shapes_[2 * i], poses_[2 * i], shapes_[2 * i + 1], poses_[2 * i + 1]);
  }
  bool distance(std::size_t i) override {
    return graze::distance(shapes_[2 * i], poses_[2 * i], shapes_[2 * i + 1], poses_[2 * i + 1]).distance <= T(0);
  }
  bool contacts(std::size_t i) override {
    manifolds_.clear();
    return graze::contacts(shapes_[2 * i], poses_[2 * i], shapes_[2 * i + 1], poses_[2 * i + 1], T(0), manifolds_);
  }

 private:
  std::vector<graze::Shape<T>> shapes_;
  std::vector<graze::Pose<T>> poses_;
  graze::Manifolds<T> manifolds_;
};

#ifdef GRAZE_BENCH_FCL
class Fcl final : public Library {
 public:
  explicit Fcl(const std::vector<Pair>& pairs) {
    for (const Pair& p : pairs)
      for (const Body& b : p) objects_.push_back(make(b));
  }
  bool overlap(std::size_t i) override {
    fcl::CollisionResult<double> result;
    return fcl::collide(&objects_[2 * i], &objects_[2 * i + 1], {}, result) > 0;
  }
  bool distance(std::size_t i) override {
    fcl::DistanceRequest<double> request(true, true);
    fcl::DistanceResult<double> result;
    return fcl::distance(&objects_[2 * i], &objects_[2 * i + 1], request, result) <= 0;
  }
  bool contacts(std::size_t i) override {
    fcl::CollisionRequest<double> request(8, true);
    fcl::CollisionResult<double> result;
    return fcl::collide(&objects_[2 * i], &objects_[2 * i + 1], request, result) > 0;
  }
  static bool has(Kind kind) { return kind != Kind::hull; }

 private:
  /// FCL's heights run along Z, so its shapes are turned by a quarter about X.
  static fcl::CollisionObject<double> make(const Body& b) {
    using Geometry = std::shared_ptr<fcl::CollisionGeometry<double>>;
    Geometry g;
    const Vec3d& s = b.size;
    switch (b.kind) {
    case Kind::sphere: g = std::make_shared<fcl::Sphere<double>>(s.x / 2); break;
    case Kind::capsule: g = std::make_shared<fcl::Capsule<double>>(s.x / 2, s.y); break;
    case Kind::box: g = std::make_shared<fcl::Box<double>>(s.x, s.z, s.y); break;
    case Kind::cylinder: g = std::make_shared<fcl::Cylinder<double>>(s.x / 2, s.y); break;
    case Kind::cone: g = std::make_shared<fcl::Cone<double>>(s.x / 2, s.y); break;
    default: g = std::make_shared<fcl::Ellipsoid<double>>(s.x / 2, s.z / 2, s.y / 2); break;
    }
    const Quatd q = b.pose.rotation * Quatd::from_axis_angle({1, 0, 0}, -std::acos(-1.0) / 2);
    const Vec3d& t = b.pose.translation;
    return {g, Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix(), Eigen::Vector3d(t.x, t.y, t.z)};
  }
  std::vector<fcl::CollisionObject<double>> objects_;
};
#endif

#ifdef GRAZE_BENCH_ODE
class Ode final : public Library {
 public:
  explicit Ode(const std::vector<Pair>& pairs) {
    static const int started = dInitODE2(0);
    static_cast<void>(started);
    for (const Pair& p : pairs)
      for (const Body& b : p) geoms_.push_back(make(b));
  }
  ~Ode() override {
    for (const dGeomID g : geoms_) dGeomDestroy(g);
  }
  bool overlap(std::size_t i) override { return touching(i, 1 | static_cast<int>(CONTACTS_UNIMPORTANT)); }
  bool distance(std::size_t i) override { return touching(i, 1); }
  bool contacts(std::size_t i) override { return touching(i, 8); }
  static bool has(Kind kind) {
    return kind == Kind::sphere || kind == Kind::capsule || kind == Kind::box || kind == Kind::cylinder;
  }

 private:
  bool touching(std::size_t i, int flags) {
    dContactGeom contact[8];
    return dCollide(geoms_[2 * i], geoms_[2 * i + 1], flags, contact, sizeof(dContactGeom)) > 0;
  }
  static dGeomID make(const Body& b) {
    const auto r = [](double v) { return static_cast<dReal>(v); };
    const Vec3d& s = b.size;
    Quatd q = b.pose.rotation * Quatd::from_axis_angle({1, 0, 0}, -std::acos(-1.0) / 2);
    dGeomID g = nullptr;
    switch (b.kind) {
    case Kind::sphere: g = dCreateSphere(nullptr, r(s.x / 2)); break;
    case Kind::capsule: g = dCreateCapsule(nullptr, r(s.x / 2), r(s.y)); break;
    case Kind::cylinder: g = dCreateCylinder(nullptr, r(s.x / 2), r(s.y)); break;
    default: g = dCreateBox(nullptr, r(s.x), r(s.z), r(s.y)); break;
    }
    const Vec3d& t = b.pose.translation;
    dGeomSetPosition(g, r(t.x), r(t.y), r(t.z));
    const dQuaternion turn = {r(q.w), r(q.x), r(q.y), r(q.z)};
    dGeomSetQuaternion(g, turn);
    return g;
  }
  std::vector<dGeomID> geoms_;
};
#endif

#ifdef GRAZE_BENCH_BULLET
class Bullet final : public Library {
 public:
  explicit Bullet(const std::vector<Pair>& pairs) : dispatcher_(&configuration_) {
    for (const Pair& p : pairs)
      for (const Body& b : p) {
        shapes_.push_back(make(b));
        objects_.push_back(std::make_unique<btCollisionObject>());
        objects_.back()->setCollisionShape(shapes_.back().get());
        const auto f = [](double v) { return static_cast<btScalar>(v); };
        const Quatd& q = b.pose.rotation;
        const Vec3d& t = b.pose.translation;
        objects_.back()->setWorldTransform(
            btTransform(btQuaternion(f(q.x), f(q.y), f(q.z), f(q.w)), btVector3(f(t.x), f(t.y), f(t.z))));
      }
  }
  bool overlap(std::size_t i) override { return contacts(i); }
  bool distance(std::size_t i) override { return contacts(i); }
  bool contacts(std::size_t i) override {
    const auto &a = *objects_[2 * i], &b = *objects_[2 * i + 1];
    btCollisionObjectWrapper wa(nullptr, a.getCollisionShape(), &a, a.getWorldTransform(), -1, -1);
    btCollisionObjectWrapper wb(nullptr, b.getCollisionShape(), &b, b.getWorldTransform(), -1, -1);
    btCollisionAlgorithm* algorithm = dispatcher_.findAlgorithm(&wa, &wb, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    btManifoldResult result(&wa, &wb);
    algorithm->processCollision(&wa, &wb, info_, &result);
    btManifoldArray manifolds;
    algorithm->getAllContactManifolds(manifolds);
    bool touch = false;
    for (int m = 0; m < manifolds.size(); ++m)
      for (int k = 0; k < manifolds[m]->getNumContacts(); ++k)
        touch = touch || manifolds[m]->getContactPoint(k).getDistance() <= 0;
    algorithm->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm);
    return touch;
  }
  static bool has(Kind kind) { return kind != Kind::ellipsoid; }

 private:
  static std::unique_ptr<btCollisionShape> make(const Body& b) {
    const auto f = [](double v) { return static_cast<btScalar>(v); };
    const Vec3d& s = b.size;
    switch (b.kind) {
    case Kind::sphere: return std::make_unique<btSphereShape>(f(s.x / 2));
    case Kind::capsule: return std::make_unique<btCapsuleShape>(f(s.x / 2), f(s.y));
    case Kind::box: return std::make_unique<btBoxShape>(btVector3(f(s.x / 2), f(s.y / 2), f(s.z / 2)));
    case Kind::cylinder: return std::make_unique<btCylinderShape>(btVector3(f(s.x / 2), f(s.y / 2), f(s.x / 2)));
    case Kind::cone: return std::make_unique<btConeShape>(f(s.x / 2), f(s.y));
    default: {
      auto hull = std::make_unique<btConvexHullShape>();
      for (const Vec3d& p : b.points) hull->addPoint(btVector3(f(p.x), f(p.y), f(p.z)), false);
      hull->recalcLocalAabb();
      return hull;
    }
    }
  }
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDispatcherInfo info_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};
#endif

using Query = bool (Library::*)(std::size_t);

template <class L>
void add(const std::string& library, const char* query, Query ask, Kind a, Kind b) {
  const std::string name = library + "/" + query + "/" + names[static_cast<int>(a)] + "-" + names[static_cast<int>(b)];
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    L peer(make_pairs(a, b));
    Library& asked = peer;
    std::size_t touching = 0;
    for (std::size_t i = 0; i < pair_count; ++i) touching += (asked.*ask)(i);
    std::size_t i = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize((asked.*ask)(i));
      i = i + 1 == pair_count ? 0 : i + 1;
    }
    state.counters["overlapping"] = static_cast<double>(touching) / static_cast<double>(pair_count);
  })->MinTime(0.02);
}

template <class L>
void add_queries(const std::string& library, Kind a, Kind b) {
  add<L>(library, "overlap", &Library::overlap, a, b);
  add<L>(library, "distance", &Library::distance, a, b);
  add<L>(library, "contacts", &Library::contacts, a, b);
}

void add_pair(Kind a, Kind b) {
  add_queries<Graze<double>>("graze<double>", a, b);
  add_queries<Graze<float>>("graze<float>", a, b);
#ifdef GRAZE_BENCH_BULLET
  if (Bullet::has(a) && Bullet::has(b)) add<Bullet>("bullet", "contacts", &Library::contacts, a, b);
#endif
#ifdef GRAZE_BENCH_ODE
  if (Ode::has(a) && Ode::has(b)) add<Ode>("ode", "contacts", &Library::contacts, a, b);
#endif
#ifdef GRAZE_BENCH_FCL
  if (Fcl::has(a) && Fcl::has(b)) add_queries<Fcl>("fcl", a, b);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  for (std::size_t i = 0; i < std::size(kinds); ++i)
    for (std::size_t j = i; j < std::size(kinds); ++j) add_pair(kinds[i], kinds[j]);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
