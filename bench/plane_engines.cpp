// The engines that play scenes of the plane: Graze in float and in double, and Debian's Box2D 2.4.
#include <cmath>
#include <memory>

#include "plane_scene.hpp"

#ifdef GRAZE_BENCH_BOX2D
#include <box2d/b2_body.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_revolute_joint.h>
#include <box2d/b2_world.h>
#endif

namespace graze::plane {

namespace {

/// A shape of a scene in another scalar.
template <class T>
Shape<T> in_scalar(const Shape<double>& shape) {
  if (const auto* circle = shape.as<Circle<double>>()) return Circle<T>(T(circle->radius()));
  if (const auto* polygon = shape.as<ConvexPolygon<double>>()) {
    std::vector<Vec2<T>> vertices;
    for (const Vec2d& vertex : polygon->vertices()) vertices.push_back(converted<T>(vertex));
    return ConvexPolygon<T>(vertices);
  }
  if (const auto* compound = shape.as<Compound<double>>()) {
    std::vector<Placed<T>> children;
    for (const auto& child : compound->children())
      children.push_back({in_scalar<T>(child.shape), converted<T>(child.pose)});
    return Compound<T>(std::move(children));
  }
  return Box<T>(converted<T>(2 * shape.as<Box<double>>()->half_extents()));
}

template <class T>
BodyId add(Simulation<T>& simulation, const SceneBody& entry) {
  const Body<double>& from = entry.body;
  Body<T> body{in_scalar<T>(from.shape),
               converted<T>(from.pose),
               converted<T>(from.linear),
               T(from.angular),
               from.filter,
               from.fixed};
  Dynamics<T> dynamics;
  dynamics.density = T(entry.density);
  dynamics.kinematic = entry.kinematic;
  Material<T> material;
  material.static_friction = material.dynamic_friction = T(scene_friction);
  return simulation.add(std::move(body), dynamics, material);
}

template <class T>
Joint<T> joint(const Scene& scene, const SceneHinge& hinge, const std::vector<BodyId>& ids) {
  const auto frame = [&](std::size_t body) {
    return converted<T>(relative(scene.bodies[body].body.pose, Pose2d{hinge.at, {}}));
  };
  Joint<T> made = hinge_joint(ids[hinge.a], frame(hinge.a), ids[hinge.b], frame(hinge.b));
  if (hinge.most < SceneHinge::infinite_angle)
    made.limits.push_back({JointSpace::angular, {false, false, true}, T(hinge.least), T(hinge.most), {}, T(0)});
  return made;
}

template <class T>
Engine graze_engine(const char* name, const Scene& scene) {
  SimulationSettings<T> settings;
  settings.gravity = converted<T>(scene.gravity);
  settings.sleep = false;
  const auto simulation = std::make_shared<Simulation<T>>(settings);
  std::vector<BodyId> ids;
  for (const SceneBody& entry : scene.bodies) ids.push_back(add(*simulation, entry));
  for (const SceneHinge& hinge : scene.hinges) simulation->add(joint<T>(scene, hinge, ids));
  return {name, [simulation] { simulation->step(T(1) / T(steps_per_second)); },
          [simulation, ids](std::size_t i) { return converted<double>(simulation->poses()[ids[i].index]); }};
}

#ifdef GRAZE_BENCH_BOX2D
b2Vec2 box2d(const Vec2d& v) { return {float(v.x), float(v.y)}; }

void add_fixtures(b2Body& body, const Shape<double>& shape, const Pose2d& pose, const SceneBody& entry) {
  if (const auto* compound = shape.as<Compound<double>>()) {
    for (const auto& child : compound->children()) add_fixtures(body, child.shape, compose(pose, child.pose), entry);
    return;
  }
  b2CircleShape circle;
  b2PolygonShape polygon;
  b2FixtureDef fixture;
  fixture.shape = &polygon;
  if (const auto* disc = shape.as<Circle<double>>()) {
    circle.m_radius = float(disc->radius());
    circle.m_p = box2d(pose.translation);
    fixture.shape = &circle;
  } else if (const auto* corners = shape.as<ConvexPolygon<double>>()) {
    std::vector<b2Vec2> vertices;
    for (const Vec2d& vertex : corners->vertices()) vertices.push_back(box2d(transform(pose, vertex)));
    polygon.Set(vertices.data(), int(vertices.size()));
  } else {
    const Vec2d& half = shape.as<Box<double>>()->half_extents();
    polygon.SetAsBox(float(half.x), float(half.y), box2d(pose.translation),
                     float(std::atan2(pose.rotation.sine, pose.rotation.cosine)));
  }
  fixture.density = float(entry.density);
  fixture.friction = float(scene_friction);
  fixture.filter.groupIndex = static_cast<int16>(entry.body.filter.group);
  body.CreateFixture(&fixture);
}

b2Body* add(b2World& world, const SceneBody& entry) {
  const Body<double>& from = entry.body;
  b2BodyDef definition;
  definition.type = from.fixed ? b2_staticBody : entry.kinematic ? b2_kinematicBody : b2_dynamicBody;
  definition.position = box2d(from.pose.translation);
  definition.angle = float(std::atan2(from.pose.rotation.sine, from.pose.rotation.cosine));
  definition.linearVelocity = box2d(from.linear);
  definition.angularVelocity = float(from.angular);
  b2Body* body = world.CreateBody(&definition);
  add_fixtures(*body, from.shape, {}, entry);
  return body;
}

Engine box2d_engine(const Scene& scene) {
  const auto world = std::make_shared<b2World>(box2d(scene.gravity));
  world->SetAllowSleeping(false);
  std::vector<b2Body*> bodies;
  for (const SceneBody& entry : scene.bodies) bodies.push_back(add(*world, entry));
  for (const SceneHinge& hinge : scene.hinges) {
    b2RevoluteJointDef definition;
    definition.Initialize(bodies[hinge.a], bodies[hinge.b], box2d(hinge.at));
    definition.enableLimit = hinge.most < SceneHinge::infinite_angle;
    if (definition.enableLimit) {
      definition.lowerAngle = float(hinge.least);
      definition.upperAngle = float(hinge.most);
    }
    world->CreateJoint(&definition);
  }
  return {"Box2D 2.4", [world] { world->Step(float(1 / steps_per_second), 8, 3); },
          [world, bodies](std::size_t i) {
            const b2Transform& at = bodies[i]->GetTransform();
            return Pose2d{{double(at.p.x), double(at.p.y)}, {double(at.q.c), double(at.q.s)}};
          }};
}
#endif

}  // namespace

std::vector<std::function<Engine(const Scene&)>> engines_of_the_plane() {
  return {
      [](const Scene& scene) { return graze_engine<float>("Graze, float", scene); },
      [](const Scene& scene) { return graze_engine<double>("Graze, double", scene); },
#ifdef GRAZE_BENCH_BOX2D
      box2d_engine,
#endif
  };
}

}  // namespace graze::plane
