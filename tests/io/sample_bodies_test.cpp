// Scenes of bodies without joints, after the subjects of KHR_physics_rigid_bodies' samples, each of which puts together
// what the conformance scenes show one by one. They are played for twenty seconds.
#include <gtest/gtest.h>

#include <algorithm>

#include "graze/query.hpp"
#include "kept_scene.hpp"

namespace graze::io::sample_bodies_test {
namespace {

using Json = nlohmann::json;

constexpr double g = 9.81;
const double pi = std::acos(-1.0);

Json solid(const Json& geometry) { return {{"collider", {{"geometry", geometry}}}}; }
Json moving(const Json& geometry, const Json& motion = {{"mass", 1}}) {
  Json json = solid(geometry);
  json["motion"] = motion;
  return json;
}
void add_floor(PhysicsScene& scene, const Json& more = Json::object()) {
  Json floor = solid({{"shape", scene.box(60, 1, 60)}});
  floor["collider"].update(more);
  scene.node("floor", floor, {0, -0.5, 0});
}

/// Nothing is no number, and what `stays` names is never below the floor.
void expect_above(const Played& played, const std::vector<std::string>& stays) {
  for (const SimulationFrame& frame : played.frames) {
    for (const BodyState& body : frame.bodies)
      ASSERT_TRUE(std::isfinite(length(body.pose.translation) + length(body.linear) + length(body.angular)));
    for (const std::string& name : stays)
      ASSERT_GT(frame.bodies[played.index(name)].pose.translation.y, 0) << name << " at " << frame.time;
  }
}

/// Three kinds of balls in three trays: each tray holds the kinds that its filter names.
TEST(SampleBodies, Filtering) {
  PhysicsScene scene;
  const auto ball = scene.ball(0.3), tray = scene.box(3, 0.2, 6);
  const char* kinds[] = {"red", "green", "blue"};
  std::vector<std::size_t> balls;
  for (const char* kind : kinds) balls.push_back(scene.filter({{"collisionSystems", {kind}}}));
  const std::vector<std::vector<std::string>> held{{"red"}, {"red", "green"}, {"red", "green", "blue"}};
  for (int i = 0; i < 3; ++i) {
    const auto sieve =
        scene.filter({{"collisionSystems", {"tray"}}, {"collideWithSystems", held[static_cast<std::size_t>(i)]}});
    scene.node("tray " + std::to_string(i), with(solid({{"shape", tray}}), "collisionFilter", sieve),
               {4.0 * i, 1.9, 0});
    for (int k = 0; k < 3; ++k)
      scene.node(kinds[k] + std::string(" ") + std::to_string(i),
                 with(moving({{"shape", ball}}), "collisionFilter", balls[static_cast<std::size_t>(k)]),
                 {4.0 * i, 4, 2.0 * (k - 1)});
  }
  add_floor(scene);
  const Played played(kept(scene, "sample-filtering", "trays hold some kinds of balls and let others through"), 20);
  std::vector<std::string> all;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const std::string name = kinds[k] + std::string(" ") + std::to_string(i);
      all.push_back(name);
      EXPECT_NEAR(played.end(name).pose.translation.y, k <= i ? 2.3 : 0.3, 0.002) << name;
    }
  expect_above(played, all);
}

/// Blocks that slide over the floor from 4 m/s stop after v^2 / (2 mu g).
TEST(SampleBodies, MaterialsFriction) {
  PhysicsScene scene;
  const Json block{{"shape", scene.box(0.8, 0.4, 0.8)}};
  add_floor(scene);
  const auto name = [](int i) { return "friction " + std::to_string(i); };
  for (int i = 1; i <= 4; ++i) {
    const auto material =
        scene.material({{"staticFriction", 0.2 * i}, {"dynamicFriction", 0.2 * i}, {"frictionCombine", "minimum"}});
    scene.node(name(i), with(moving(block, {{"mass", 1}, {"linearVelocity", {2, 0, 0}}}), "physicsMaterial", material),
               {0, 0.2, 1.5 * i});
  }
  const Played played(kept(scene, "sample-materials-friction", "the rougher, the sooner a block stops"), 20);
  expect_above(played, {name(1), name(2), name(3), name(4)});
  for (int i = 1; i <= 4; ++i) {
    // Rougher than the floor's own 0.6 no contact is.
    const double way = 4 / (2 * std::min(0.2 * i, 0.6) * g);
    EXPECT_NEAR(played.end(name(i)).pose.translation.x, way, 0.02 * way + 0.002) << i;
    EXPECT_LE(length(played.end(name(i)).linear), 1e-3) << i;
  }
}

/// A sled on two skids, each a collider of its own: one is of ice, the other takes half of the weight and brakes by its
/// own friction. Below one body they are one solid, which does not give.
TEST(SampleBodies, CollidersOfOneBodyKeepTheirMaterials) {
  PhysicsScene scene;
  const Json skid{{"shape", scene.box(2, 0.2, 0.2)}};
  add_floor(scene);
  const auto material = [&](double friction) {
    return scene.material(
        {{"staticFriction", friction}, {"dynamicFriction", friction}, {"frictionCombine", "minimum"}});
  };
  const auto ice = material(0), felt = material(0.3);
  const Json motion{{"mass", 3}, {"inertiaDiagonal", {0, 0, 0}}, {"linearVelocity", {3, 0, 0}}};
  const auto sled = scene.node("sled", Json{{"motion", motion}}, {0, 0.1, 0});
  scene.put_below(sled, scene.node("ice", with(solid(skid), "physicsMaterial", ice), {0, 0, -0.5}));
  scene.put_below(sled, scene.node("felt", with(solid(skid), "physicsMaterial", felt), {0, 0, 0.5}));
  const Played played(scene, 1);
  EXPECT_NEAR(played.end("sled").linear.x, 3 - 0.15 * g, 0.03);
  EXPECT_NEAR(played.end("sled").linear.z, 0, 0.01);
}

/// Balls that fall 2 m rebound to e^2 of it.
TEST(SampleBodies, MaterialsRestitution) {
  PhysicsScene scene;
  const Json ball{{"shape", scene.ball(0.25)}};
  add_floor(scene);
  const auto name = [](int i) { return "restitution " + std::to_string(i); };
  for (int i = 0; i <= 4; ++i) {
    const auto material = scene.material({{"restitution", 0.25 * i}, {"restitutionCombine", "maximum"}});
    scene.node(name(i), with(moving(ball), "physicsMaterial", material), {1.5 * i, 2.25, 0});
  }
  const Played played(kept(scene, "sample-materials-restitution", "the more elastic, the higher a ball rebounds"), 20);
  for (int i = 0; i <= 4; ++i) {
    double highest = 0;
    bool risen = false;
    for (const SimulationFrame& frame : played.frames) {
      if (frame.time > 2.2 * std::sqrt(4 / g)) break;
      const BodyState& body = frame.bodies[played.index(name(i))];
      risen |= frame.time > 0.3 && body.linear.y > 0;
      if (risen) highest = std::max(highest, body.pose.translation.y - 0.25);
    }
    EXPECT_NEAR(highest, 2 * 0.0625 * i * i, 0.02) << i;
  }
  expect_above(played, {name(0), name(1), name(2), name(3), name(4)});
}

/// Without gravity, with half of it, thrown, turning, of another centre of mass, carried along.
TEST(SampleBodies, MotionProperties) {
  PhysicsScene scene;
  const Json cube{{"shape", scene.box(0.5, 0.5, 0.5)}};
  add_floor(scene);
  scene.node("floating", moving(cube, {{"mass", 1}, {"gravityFactor", 0}}), {0, 5, 0});
  scene.node("light", moving(cube, {{"mass", 1}, {"gravityFactor", 0.5}}), {2, 19.25, 0});
  scene.node("thrown", moving(cube, {{"mass", 1}, {"linearVelocity", {3, 4, 0}}}), {4, 10, 0});
  scene.node("turning", moving(cube, {{"mass", 1}, {"gravityFactor", 0}, {"angularVelocity", {0, pi, 0}}}), {-2, 5, 0});
  scene.node("tumbler", moving(cube, {{"mass", 1}, {"centerOfMass", {0, -0.2, 0}}}), {-4, 0.4, 0},
             Quatd::from_axis_angle({0, 0, 1}, 0.5));
  scene.node("carried", moving(cube, {{"isKinematic", true}, {"linearVelocity", {0.1, 0, 0}}}), {-6, 2, 0});
  const Played played(kept(scene, "sample-motion-properties", "gravity, velocities and centres of mass of their own"),
                      20);
  expect_above(played, {"floating", "light", "thrown", "turning", "tumbler", "carried"});
  EXPECT_LE(length(played.end("floating").pose.translation - Vec3d{0, 5, 0}), 1e-9);
  EXPECT_NEAR(played.place("light", 2).y, 19.25 - g, 1e-6);
  const Vec3d thrown = played.place("thrown", 1);
  EXPECT_LE(length(thrown - Vec3d{7, 14 - g / 2, 0}), 1e-6);
  EXPECT_LE(length(played.end("turning").angular - Vec3d{0, pi, 0}), 1e-9);
  EXPECT_LE(length(played.end("turning").pose.translation - Vec3d{-2, 5, 0}), 1e-9);
  // Its low centre of mass has righted it.
  EXPECT_GT(rotate(played.end("tumbler").pose.rotation, Vec3d{0, 1, 0}).y, 0.999);
  EXPECT_NEAR(played.end("carried").pose.translation.x, -4, 1e-6);
}

/// One of each shape falls on a floor and comes to rest on it.
TEST(SampleBodies, ShapeTypes) {
  PhysicsScene scene;
  add_floor(scene);
  const auto shaped = [&](const Json& json) { return Json{{"shape", scene.shape(json)}}; };
  const std::vector<float> points{-0.5F, -0.5F, -0.5F, 0.5F, -0.5F, -0.5F, 0, -0.5F, 0.6F, 0, 0.6F, 0};
  const std::vector<std::uint32_t> corners{0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
  const auto cylinder = [&](double bottom, double top) {
    return shaped({{"type", "cylinder"}, {"cylinder", {{"height", 1}, {"radiusBottom", bottom}, {"radiusTop", top}}}});
  };
  const std::vector<std::pair<std::string, Json>> shapes{
      {"sphere", {{"shape", scene.ball(0.5)}}},
      {"box", {{"shape", scene.box(1, 1, 1)}}},
      {"capsule",
       shaped({{"type", "capsule"}, {"capsule", {{"height", 1}, {"radiusBottom", 0.3}, {"radiusTop", 0.3}}}})},
      {"cylinder", cylinder(0.5, 0.5)},
      {"cone", cylinder(0.5, 0)},
      {"hull", {{"mesh", scene.mesh(points, corners)}, {"convexHull", true}}},
      {"mesh", {{"mesh", scene.mesh(points, corners)}}}};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    names.push_back(shapes[i].first);
    const bool lies = shapes[i].first == "capsule";
    scene.node(shapes[i].first, moving(shapes[i].second), {2.0 * static_cast<double>(i), 1.5, 0},
               lies ? Quatd::from_axis_angle({0, 0, 1}, pi / 2) : Quatd{});
  }
  const Played played(kept(scene, "sample-shape-types", "a shape of each type comes to rest"), 20);
  expect_above(played, names);
  for (const std::string& name : names) {
    EXPECT_LE(length(played.end(name).linear), 1e-3) << name;
    EXPECT_LE(length(played.end(name).angular), 2e-3) << name;
  }
  for (const ContactState& contact : played.frames.back().contacts) EXPECT_LE(contact.depth, 0.002);
}

/// A ball falls through two triggers, one of which a filter keeps from it, on its way to the floor.
TEST(SampleBodies, Triggers) {
  PhysicsScene scene;
  add_floor(scene);
  const auto ball = scene.ball(0.25), zone = scene.box(2, 1, 2);
  const auto other = scene.filter({{"collisionSystems", {"zone"}}, {"collideWithSystems", {"nobody"}}});
  scene.node("zone", {{"trigger", {{"geometry", {{"shape", zone}}}}}}, {0, 3, 0});
  scene.node("blind zone", {{"trigger", {{"geometry", {{"shape", zone}}}, {"collisionFilter", other}}}}, {0, 1.5, 0});
  scene.node("ball", moving({{"shape", ball}}), {0, 5, 0});
  const Played played(kept(scene, "sample-triggers", "a ball falls through zones that do not hold it"), 20);
  expect_above(played, {"ball"});
  // Nothing holds it between 5 m and the floor.
  EXPECT_NEAR(played.place("ball", 0.5).y, 5 - g / 8, 1e-9);
  EXPECT_NEAR(played.end("ball").pose.translation.y, 0.25, 0.002);
  // Zones are met, and do not push.
  std::size_t in_zone = 0;
  const Collider& trigger = *std::find_if(played.scene.colliders.begin(), played.scene.colliders.end(),
                                          [](const Collider& c) { return c.trigger; });
  for (const SimulationFrame& frame : played.frames) {
    in_zone += overlap(trigger.shape, trigger.pose, Shape<double>(Sphere<double>(0.25)), frame.bodies[0].pose) ? 1 : 0;
    for (const ContactState& contact : frame.contacts) {
      EXPECT_TRUE(played.scene.bodies[contact.a].name == "floor" || played.scene.bodies[contact.b].name == "floor");
    }
  }
  // From a quarter above its top until a quarter below its bottom.
  const double seconds = std::sqrt(2 * (5 - 2.25) / g) - std::sqrt(2 * (5 - 3.75) / g);
  EXPECT_NEAR(static_cast<double>(in_zone) / 60, seconds, 2.0 / 60);
  const auto& events = played.summary.triggers;
  ASSERT_EQ(events.size(), 2u);
  EXPECT_TRUE(events[0].begins && !events[1].begins);
  for (const TriggerEvent& event : events) {
    EXPECT_EQ(played.scene.colliders[event.trigger].name, "zone");
    EXPECT_EQ(played.scene.bodies[event.body].name, "ball");
  }
  EXPECT_NEAR(events[0].time, std::sqrt(2 * (5 - 3.75) / g), 1.0 / 60);
  EXPECT_NEAR(events[1].time, std::sqrt(2 * (5 - 2.25) / g), 1.0 / 60);
}

}  // namespace
}  // namespace graze::io::sample_bodies_test
