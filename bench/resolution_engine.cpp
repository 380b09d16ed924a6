#include "resolution_engine.hpp"

#include <cmath>
#include <deque>

#ifdef GRAZE_BENCH_BULLET
#include <btBulletDynamicsCommon.h>
#endif
#ifdef GRAZE_BENCH_ODE
#include <ode/ode.h>
#endif

#include "graze/simulation.hpp"
#include "resolution_bowl.hpp"
#include "threads.hpp"

namespace graze::bench {

ThingMass mass_of(const Thing& thing) {
  const Vec3d& s = thing.size;
  switch (thing.form) {
  case Form::box: {
    const double m = thing.density * s.x * s.y * s.z;
    return {m, Vec3d{s.y * s.y + s.z * s.z, s.x * s.x + s.z * s.z, s.x * s.x + s.y * s.y} * (m / 12)};
  }
  case Form::ball: {
    const double m = thing.density * 4.18879020478639 * s.x * s.x * s.x;
    return {m, Vec3d{1, 1, 1} * (0.4 * m * s.x * s.x)};
  }
  case Form::cylinder: {
    const double m = thing.density * 3.14159265358979 * s.x * s.x * s.y, across = s.x * s.x / 4 + s.y * s.y / 12;
    return {m, Vec3d{across, s.x * s.x / 2, across} * m};
  }
  case Form::floor:
  case Form::bowl: break;
  }
  return {};
}

namespace {

template <class T>
class GrazeEngine final : public Engine {
 public:
  explicit GrazeEngine(const EngineOptions& o)
      : executor_(make_executor(o.threads)),
        simulation_({.gravity = converted<T>(o.gravity), .sleep = o.sleep}, executor_.get()) {}
  void add(const Thing& thing) override {
    Material<T> material;
    material.static_friction = material.dynamic_friction = static_cast<T>(thing.friction);
    material.restitution = static_cast<T>(thing.restitution);
    graze::Body<T> body{shape(thing), converted<T>(thing.pose), converted<T>(thing.linear),
                        converted<T>(thing.angular)};
    body.fixed = thing.density == 0;
    Dynamics<T> dynamics;
    if (!body.fixed) dynamics.density = static_cast<T>(thing.density);
    ids_.push_back(simulation_.add(body, dynamics, material));
  }
  void step(double dt) override { simulation_.step(static_cast<T>(dt)); }
  Moving moving(std::size_t body) const override {
    const Motion<T> m = simulation_.motion(ids_[body]);
    return {converted<double>(simulation_.poses()[ids_[body].index]), converted<double>(m.linear),
            converted<double>(m.angular)};
  }
  bool asleep(std::size_t body) const override { return simulation_.asleep(ids_[body]); }
  std::function<void()> saved() override {
    return [this, state = simulation_.save()] { simulation_.restore(state); };
  }

 private:
  static Shape<T> shape(const Thing& thing) {
    const auto x = static_cast<T>(thing.size.x), y = static_cast<T>(thing.size.y);
    switch (thing.form) {
    case Form::ball: return Sphere<T>(x);
    case Form::cylinder: return Cylinder<T>(y, x);
    case Form::floor: return HalfSpace<T>();
    case Form::bowl: return bowl_of(thing.size.x).template mesh<T>();
    case Form::box: break;
    }
    return Box<T>(converted<T>(thing.size));
  }
  std::unique_ptr<Executor> executor_;
  Simulation<T> simulation_;
  std::vector<BodyId> ids_;
};

#ifdef GRAZE_BENCH_BULLET
btScalar number(double v) { return static_cast<btScalar>(v); }
btVector3 vector(const Vec3d& v) { return {number(v.x), number(v.y), number(v.z)}; }
Vec3d vector(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// Coefficients are handed over as roots: Bullet multiplies those of two bodies.
class BulletEngine final : public Engine {
 public:
  explicit BulletEngine(const EngineOptions& o) : sleep_(o.sleep), continuous_(o.continuous) {
    world_.setGravity(vector(o.gravity));
  }
  ~BulletEngine() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  void add(const Thing& thing) override {
    const Vec3d& s = thing.size;
    switch (thing.form) {
    case Form::box: shapes_.push_back(std::make_unique<btBoxShape>(vector(s) / 2)); break;
    case Form::ball: shapes_.push_back(std::make_unique<btSphereShape>(number(s.x))); break;
    case Form::cylinder: shapes_.push_back(std::make_unique<btCylinderShape>(vector(Vec3d{s.x, s.y / 2, s.x}))); break;
    // Its plane has a contact a step, and lets boxes creep; a box is the floor that its own demonstrations use.
    case Form::floor: shapes_.push_back(std::make_unique<btBoxShape>(vector(Vec3d{200, 1, 200}))); break;
    case Form::bowl: {
      const Bowl bowl = bowl_of(s.x);
      auto mesh = std::make_unique<btTriangleMesh>();
      for (std::size_t i = 0; i < bowl.indices.size(); i += 3)
        mesh->addTriangle(vector(bowl.points[bowl.indices[i]]), vector(bowl.points[bowl.indices[i + 1]]),
                          vector(bowl.points[bowl.indices[i + 2]]));
      shapes_.push_back(std::make_unique<btBvhTriangleMeshShape>(mesh.get(), true));
      meshes_.push_back(std::move(mesh));
      break;
    }
    }
    const ThingMass mass = thing.density > 0 ? mass_of(thing) : ThingMass{};
    btRigidBody::btRigidBodyConstructionInfo info(number(mass.mass), nullptr, shapes_.back().get(),
                                                  vector(mass.inertia));
    const Quatd& q = thing.pose.rotation;
    info.m_startWorldTransform =
        btTransform(btQuaternion(number(q.x), number(q.y), number(q.z), number(q.w)),
                    vector(thing.pose.translation - (thing.form == Form::floor ? Vec3d{0, 1, 0} : Vec3d{})));
    info.m_friction = number(std::sqrt(thing.friction));
    info.m_restitution = number(std::sqrt(thing.restitution));
    auto body = std::make_unique<btRigidBody>(info);
    body->setLinearVelocity(vector(thing.linear));
    body->setAngularVelocity(vector(thing.angular));
    if (!sleep_) body->setActivationState(DISABLE_DEACTIVATION);
    if (continuous_ && thing.form != Form::floor && thing.density > 0) {
      const double least_half = thing.form == Form::ball ? s.x : std::min({s.x, s.y, s.z}) / 2;
      body->setCcdMotionThreshold(number(least_half));
      body->setCcdSweptSphereRadius(number(least_half * 0.8));
    }
    world_.addRigidBody(body.get());
    bodies_.push_back(std::move(body));
  }
  void step(double dt) override { world_.stepSimulation(number(dt), 0); }
  Moving moving(std::size_t body) const override {
    const btRigidBody& b = *bodies_[body];
    const btQuaternion q = b.getWorldTransform().getRotation();
    return {{vector(b.getWorldTransform().getOrigin()), {q.x(), q.y(), q.z(), q.w()}},
            vector(b.getLinearVelocity()),
            vector(b.getAngularVelocity())};
  }
  bool asleep(std::size_t body) const override { return !bodies_[body]->isActive(); }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broad_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  bool sleep_, continuous_;
};
#endif

#ifdef GRAZE_BENCH_ODE
Vec3d vector(const dReal* v) { return {v[0], v[1], v[2]}; }

/// QuickStep with ODE's defaults.
class OdeEngine final : public Engine {
 public:
  explicit OdeEngine(const EngineOptions& o) : sleep_(o.sleep) {
    static const bool started = dInitODE2(0) != 0;
    static_cast<void>(started);
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    group_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, static_cast<dReal>(o.gravity.x), static_cast<dReal>(o.gravity.y),
                     static_cast<dReal>(o.gravity.z));
    dWorldSetAutoDisableFlag(world_, o.sleep ? 1 : 0);
    dRandSetSeed(1);
  }
  ~OdeEngine() override {
    dJointGroupDestroy(group_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    for (const dTriMeshDataID mesh : meshes_) dGeomTriMeshDataDestroy(mesh);
  }
  OdeEngine(const OdeEngine&) = delete;
  OdeEngine& operator=(const OdeEngine&) = delete;
  void add(const Thing& thing) override {
    const auto n = [](double v) { return static_cast<dReal>(v); };
    const Vec3d &s = thing.size, &at = thing.pose.translation;
    // ODE's cylinders stand along z.
    const double half = 0.7071067811865476;
    const Quatd q = thing.form == Form::cylinder ? thing.pose.rotation * Quatd{half, 0, 0, half} : thing.pose.rotation;
    const dQuaternion turn{n(q.w), n(q.x), n(q.y), n(q.z)};
    dGeomID geom{};
    switch (thing.form) {
    case Form::box: geom = dCreateBox(space_, n(s.x), n(s.y), n(s.z)); break;
    case Form::ball: geom = dCreateSphere(space_, n(s.x)); break;
    case Form::cylinder: geom = dCreateCylinder(space_, n(s.x), n(s.y)); break;
    case Form::floor: {
      const Vec3d up = rotate(thing.pose.rotation, Vec3d{0, 1, 0});
      geom = dCreatePlane(space_, n(up.x), n(up.y), n(up.z), n(dot(up, at)));
      break;
    }
    case Form::bowl: {
      // ODE reads the numbers where they are.
      const Bowl& bowl = bowls_.emplace_back(bowl_of(s.x));
      const dTriMeshDataID mesh = meshes_.emplace_back(dGeomTriMeshDataCreate());
      dGeomTriMeshDataBuildDouble(mesh, bowl.points.data(), sizeof(Vec3d), static_cast<int>(bowl.points.size()),
                                  bowl.indices.data(), static_cast<int>(bowl.indices.size()),
                                  3 * sizeof(std::uint32_t));
      geom = dCreateTriMesh(space_, mesh, nullptr, nullptr, nullptr);
      break;
    }
    }
    dGeomSetData(geom, reinterpret_cast<void*>(things_.size()));
    dBodyID body{};
    if (thing.density > 0) {
      body = dBodyCreate(world_);
      const ThingMass m = mass_of(thing);
      const Vec3d i = thing.form == Form::cylinder ? Vec3d{m.inertia.x, m.inertia.z, m.inertia.y} : m.inertia;
      dMass mass;
      dMassSetParameters(&mass, n(m.mass), 0, 0, 0, n(i.x), n(i.y), n(i.z), 0, 0, 0);
      dBodySetMass(body, &mass);
      dGeomSetBody(geom, body);
      dBodySetPosition(body, n(at.x), n(at.y), n(at.z));
      dBodySetQuaternion(body, turn);
      dBodySetLinearVel(body, n(thing.linear.x), n(thing.linear.y), n(thing.linear.z));
      dBodySetAngularVel(body, n(thing.angular.x), n(thing.angular.y), n(thing.angular.z));
    } else if (thing.form != Form::floor) {
      dGeomSetPosition(geom, n(at.x), n(at.y), n(at.z));
      dGeomSetQuaternion(geom, turn);
    }
    things_.push_back({body, thing});
  }
  void step(double dt) override {
    dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) { static_cast<OdeEngine*>(self)->collide(a, b); });
    dWorldQuickStep(world_, static_cast<dReal>(dt));
    dJointGroupEmpty(group_);
  }
  Moving moving(std::size_t i) const override {
    const auto& [body, thing] = things_[i];
    if (body == nullptr) return {thing.pose, {}, {}};
    const dReal* q = dBodyGetQuaternion(body);
    const double half = 0.7071067811865476;
    Quatd turn{q[1], q[2], q[3], q[0]};
    if (thing.form == Form::cylinder) turn = turn * Quatd{-half, 0, 0, half};
    return {{vector(dBodyGetPosition(body)), turn}, vector(dBodyGetLinearVel(body)), vector(dBodyGetAngularVel(body))};
  }
  bool asleep(std::size_t i) const override {
    return sleep_ && things_[i].first != nullptr && dBodyIsEnabled(things_[i].first) == 0;
  }

 private:
  const Thing& thing_of(dGeomID geom) const {
    return things_[reinterpret_cast<std::size_t>(dGeomGetData(geom))].second;
  }
  void collide(dGeomID a, dGeomID b) {
    if (dGeomGetBody(a) == nullptr && dGeomGetBody(b) == nullptr) return;
    dContact contacts[16];
    const int count = dCollide(a, b, 16, &contacts[0].geom, sizeof(dContact));
    const Thing &ta = thing_of(a), &tb = thing_of(b);
    for (int i = 0; i < count; ++i) {
      dSurfaceParameters& surface = contacts[i].surface;
      surface = {};
      surface.mode = dContactApprox1 | (ta.restitution > 0 || tb.restitution > 0 ? dContactBounce : 0);
      surface.mu = static_cast<dReal>((ta.friction + tb.friction) / 2);
      surface.bounce = static_cast<dReal>((ta.restitution + tb.restitution) / 2);
      dJointAttach(dJointCreateContact(world_, group_, &contacts[i]), dGeomGetBody(a), dGeomGetBody(b));
    }
  }

  bool sleep_;
  dWorldID world_{};
  dSpaceID space_{};
  dJointGroupID group_{};
  std::deque<Bowl> bowls_;
  std::vector<dTriMeshDataID> meshes_;
  std::vector<std::pair<dBodyID, Thing>> things_;
};
#endif

template <class E>
EngineKind kind(const char* name, bool has_threads = false) {
  const auto make = [](const EngineOptions& o) -> std::unique_ptr<Engine> { return std::make_unique<E>(o); };
  return {name, make, has_threads};
}

}  // namespace

std::vector<EngineKind> engine_kinds() {
  const bool threads = make_executor(2) != nullptr;
  std::vector<EngineKind> kinds{kind<GrazeEngine<float>>("Graze, float", threads),
                                kind<GrazeEngine<double>>("Graze, double", threads)};
#ifdef GRAZE_BENCH_BULLET
  kinds.push_back(kind<BulletEngine>("Bullet " GRAZE_BENCH_BULLET_VERSION));
#endif
#ifdef GRAZE_BENCH_ODE
  kinds.push_back(kind<OdeEngine>("ODE " GRAZE_BENCH_ODE_VERSION));
#endif
  return kinds;
}

}  // namespace graze::bench
