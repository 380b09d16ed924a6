// The subjects of KHR_physics_rigid_bodies' conformance scenes, each as a scene of our own with what follows from the
// laws of mechanics: colliders, filters, materials and motions.
#include <gtest/gtest.h>

#include "kept_scene.hpp"

namespace graze::io::conformance_test {
namespace {

using Json = nlohmann::json;

constexpr double g = 9.81;
const double pi = std::acos(-1.0);

Json collider(std::size_t shape) { return {{"collider", {{"geometry", {{"shape", shape}}}}}}; }
Json moving(std::size_t shape, const Json& motion = Json::object()) {
  Json json = collider(shape);
  json["motion"] = motion;
  return json;
}

/// The corners and outward triangles of a box about the origin.
std::size_t box_mesh(PhysicsScene& scene, float half) {
  std::vector<float> points;
  for (int i = 0; i < 8; ++i)
    for (const int bit : {1, 2, 4}) points.push_back(i & bit ? half : -half);
  return scene.mesh(points, {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                             2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5});
}

constexpr const char* type_names[] = {"a sphere", "a box", "a capsule", "a cylinder", "a hull", "a mesh"};
std::string numbered(const std::string& name, int number) {
  return name + (number < 10 ? "-0" : "-") + std::to_string(number);
}

/// A shape of each type whose top and bottom are `half` from its origin.
Json geometry(PhysicsScene& scene, int type, double half) {
  const auto shaped = [&](const Json& json) { return Json{{"shape", scene.shape(json)}}; };
  switch (type) {
  case 0: return {{"shape", scene.ball(half)}};
  case 1: return {{"shape", scene.box(2 * half, 2 * half, 2 * half)}};
  case 2:
    return shaped({{"type", "capsule"}, {"capsule", {{"height", half}, {"radiusBottom", half}, {"radiusTop", half}}}});
  case 3:
    return shaped(
        {{"type", "cylinder"}, {"cylinder", {{"height", 2 * half}, {"radiusBottom", half}, {"radiusTop", half}}}});
  case 4: return {{"mesh", box_mesh(scene, static_cast<float>(half))}, {"convexHull", true}};
  default: return {{"mesh", box_mesh(scene, static_cast<float>(half))}};
  }
}

/// Every type on every type stays above, and not deeper than 0.2 % of its size. Capsules lie on their sides.
TEST(Conformance, ColliderTypeMatrix) {
  for (int below = 0; below < 6; ++below)
    for (int above = 0; above < 6; ++above) {
      PhysicsScene scene;
      const Quatd lying = Quatd::from_axis_angle({0, 0, 1}, pi / 2);
      scene.node("below", {{"collider", {{"geometry", geometry(scene, below, 5)}}}}, {0, -5, 0},
                 below == 2 ? lying : Quatd{});
      scene.node("above", {{"collider", {{"geometry", geometry(scene, above, 0.5)}}}, {"motion", {{"mass", 1}}}},
                 {0, 0.501, 0}, above == 2 ? lying : Quatd{});
      const std::string says = std::string(type_names[above]) + " stays on " + type_names[below];
      const Played played(kept(scene, numbered("collider-type-matrix", 6 * below + above), says), 20);
      for (const SimulationFrame& frame : played.frames)
        ASSERT_GT(frame.bodies[0].pose.translation.y, 0) << below << " " << above << " at " << frame.time;
      EXPECT_LE(played.summary.deepest, 0.002) << below << " " << above;
      EXPECT_NEAR(played.end("above").pose.translation.y, 0.5, 0.002) << below << " " << above;
    }
}

/// What is to collide with the floor lies on it; what is not falls through it as if alone.
TEST(Conformance, FiltersIncludeAndExclude) {
  for (const bool include : {true, false}) {
    PhysicsScene scene;
    const auto cube = scene.box(1, 1, 1), ground = scene.box(10, 1, 10);
    const auto floor = scene.filter({{"collisionSystems", {"floor"}}});
    const char* key = include ? "collideWithSystems" : "notCollideWithSystems";
    const auto solid = scene.filter({{"collisionSystems", {"a"}}, {key, {include ? "floor" : "other"}}});
    const auto ghost = scene.filter({{"collisionSystems", {"b"}}, {key, {include ? "other" : "floor"}}});
    scene.node("floor", with(collider(ground), "collisionFilter", floor), {0, -0.5, 0});
    scene.node("solid", with(moving(cube), "collisionFilter", solid), {-2, 1, 0});
    scene.node("ghost", with(moving(cube), "collisionFilter", ghost), {2, 1, 0});
    const Played played(kept(scene, numbered("collision-filter", include ? 0 : 1), "one lies, the other falls through"),
                        2);
    EXPECT_NEAR(played.end("solid").pose.translation.y, 0.5, 0.002);
    EXPECT_NEAR(played.end("ghost").pose.translation.y, 1 - g * 2, 1e-9);
  }
}

/// A dumbbell of which one weight meets the floor: that one stays above it while the other swings through.
TEST(Conformance, FiltersOfCompounds) {
  for (const bool include : {true, false}) {
    PhysicsScene scene;
    const auto cube = scene.box(1, 1, 1), ground = scene.box(20, 1, 20);
    const auto floor = scene.filter({{"collisionSystems", {"floor"}}});
    const char* key = include ? "collideWithSystems" : "notCollideWithSystems";
    const auto ghost = scene.filter({{"collisionSystems", {"b"}}, {key, {include ? "other" : "floor"}}});
    scene.node("floor", with(collider(ground), "collisionFilter", floor), {0, -0.5, 0});
    const auto body = scene.node("body", {{"motion", {{"mass", 2}}}}, {0, 0.6, 0});
    scene.put_below(body, scene.node("left", collider(cube), {-1, 0, 0}));
    scene.put_below(body, scene.node("right", with(collider(cube), "collisionFilter", ghost), {1, 0, 0}));
    const Played played(
        kept(scene, numbered("collision-filter", include ? 2 : 3), "one weight swings through the floor"), 1);
    double lowest_left = 1, lowest_right = 1;
    for (const SimulationFrame& frame : played.frames) {
      lowest_left = std::min(lowest_left, transform(frame.bodies[0].pose, Vec3d{-1, 0, 0}).y);
      lowest_right = std::min(lowest_right, transform(frame.bodies[0].pose, Vec3d{1, 0, 0}).y);
    }
    EXPECT_GT(lowest_left, 0.4);
    EXPECT_LT(lowest_right, 0);
  }
}

double rebound(const Played& played, const std::string& name) {
  double highest = 0;
  bool rising = false;
  for (const SimulationFrame& frame : played.frames) {
    const BodyState& ball = frame.bodies[played.index(name)];
    rising |= frame.time > 0.5 && ball.linear.y > 0;
    if (rising) highest = std::max(highest, ball.pose.translation.y - 0.5);
  }
  return highest;
}

TEST(Conformance, MaterialsRestitution) {
  PhysicsScene scene;
  const auto ball = scene.ball(0.5), ground = scene.box(20, 1, 20);
  scene.node("floor", with(collider(ground), "physicsMaterial", scene.material({{"restitution", 0.5}})), {0, -0.5, 0});
  for (const int e : {0, 1}) {
    const auto material = scene.material({{"restitution", e}, {"restitutionCombine", "maximum"}});
    scene.node("ball " + std::to_string(e), with(moving(ball), "physicsMaterial", material), {3.0 * e, 4.5, 0});
  }
  const Played played(kept(scene, "materials-00", "restitution: rebounds of 1 m and of 4 m"), 2.5);
  EXPECT_NEAR(rebound(played, "ball 0"), 1.00, 0.01);
  EXPECT_NEAR(rebound(played, "ball 1"), 4.00, 0.01);
}

/// The floor names no mode, and leaves it to the balls.
TEST(Conformance, MaterialsCombine) {
  PhysicsScene scene;
  const auto ball = scene.ball(0.5), ground = scene.box(20, 1, 20);
  scene.node("floor", with(collider(ground), "physicsMaterial", scene.material({{"restitution", 0.5}})), {0, -0.5, 0});
  for (const char* mode : {"minimum", "maximum"}) {
    const auto material = scene.material({{"restitution", 0}, {"restitutionCombine", mode}});
    scene.node(mode, with(moving(ball), "physicsMaterial", material), {mode[1] == 'i' ? 3.0 : -3.0, 4.5, 0});
  }
  const Played played(kept(scene, "materials-01", "modes to combine: one stays down, one rebounds by 1 m"), 2.5);
  EXPECT_LE(rebound(played, "minimum"), 0.01);
  EXPECT_NEAR(rebound(played, "maximum"), 1.00, 0.01);
}

/// On 45 degrees: friction (0 + 0.6) / 2 lets slide at g (sin - 0.3 cos), (10 + 0.6) / 2 holds.
TEST(Conformance, MaterialsFriction) {
  PhysicsScene scene;
  const auto plate = scene.box(1, 0.2, 1), slope = scene.box(40, 1, 40);
  const Quatd turn = Quatd::from_axis_angle({0, 0, 1}, pi / 4);
  scene.node("slope", collider(slope), rotate(turn, Vec3d{0, -0.5, 0}), turn);
  for (const int mu : {0, 10}) {
    const auto material = scene.material({{"staticFriction", mu}, {"dynamicFriction", mu}});
    scene.node("mu " + std::to_string(mu), with(moving(plate), "physicsMaterial", material),
               rotate(turn, Vec3d{5, 0.1, mu / 2.0}), turn);
  }
  const Played played(kept(scene, "materials-02", "friction at 45 degrees: one slides, one holds"), 2);
  const double way = g * (1 - 0.3) * std::sqrt(0.5) * 2;
  EXPECT_NEAR(length(played.place("mu 0", 2) - played.place("mu 0", 0)), way, 0.005 * way);
  EXPECT_LE(length(played.place("mu 10", 2) - played.place("mu 10", 0)), 1e-3);
}

/// Velocities are in the node's space, which a turned parent turns.
TEST(Conformance, MotionProperties) {
  for (const bool turned : {false, true}) {
    PhysicsScene scene;
    const auto ball = scene.ball(0.5);
    const auto parent = scene.node("parent", nullptr, {}, turned ? Quatd::from_axis_angle({0, 0, 1}, pi / 2) : Quatd{});
    const auto add = [&](const char* name, double x, const Json& motion) {
      const auto node = scene.node(name, moving(ball, motion), {x, 0, 0});
      scene.put_below(parent, node);
    };
    add("still", 0, {{"gravityFactor", 0}});
    add("going", 5, {{"gravityFactor", 0}, {"linearVelocity", {1, 0, 0}}});
    add("turning", -5, {{"gravityFactor", 0}, {"angularVelocity", {1, 0, 0}}});
    const Played played(kept(scene, numbered("motion-properties", turned ? 1 : 0),
                             turned ? "velocities below a turned parent" : "still, going, turning, without gravity"),
                        2);
    const Vec3d axis = turned ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
    EXPECT_LE(length(played.end("still").pose.translation), 1e-12);
    EXPECT_LE(length(played.end("going").pose.translation - axis * 7.0), 1e-9);
    EXPECT_LE(length(played.end("going").linear - axis), 1e-12);
    EXPECT_LE(length(played.end("turning").angular - axis), 1e-12);
    EXPECT_LE(length(played.end("turning").pose.translation + axis * 5.0), 1e-12);
    const Quatd turn = played.end("turning").pose.rotation * conjugate(played.at("turning", 0).pose.rotation);
    EXPECT_NEAR(std::abs(dot(turn.vector(), axis)), std::sin(1.0), 1e-6);
  }
}

/// A parent that is turned and moved, and the parent of that: velocities are in the space of the node, which all of
/// them turn.
TEST(Conformance, MotionPropertiesBelowTurnedParents) {
  const Quatd about_x = Quatd::from_axis_angle({1, 0, 0}, pi / 2), about_y = Quatd::from_axis_angle({0, 1, 0}, pi / 2);
  struct Parents {
    const char* says;
    Quatd outer, inner, own;
  };
  const Parents all[] = {{"velocities of a turned node below a turned parent", {}, about_y, about_x},
                         {"velocities below two turned parents", about_x, about_y, {}},
                         {"velocities of a turned node below two turned parents", about_y, about_x, about_y}};
  for (int i = 0; i < 3; ++i) {
    PhysicsScene scene;
    const auto ball = scene.ball(0.5);
    const auto outer = scene.node("outer", nullptr, {0, 1, 0}, all[i].outer);
    const auto inner = scene.node("inner", nullptr, {0, 0, 2}, all[i].inner);
    scene.put_below(outer, inner);
    const auto add = [&](const char* name, double x, const Json& motion) {
      scene.put_below(inner, scene.node(name, moving(ball, motion), {x, 0, 0}, all[i].own));
    };
    add("still", 0, {{"gravityFactor", 0}});
    add("going", 5, {{"gravityFactor", 0}, {"linearVelocity", {1, 0, 0}}});
    add("turning", -5, {{"gravityFactor", 0}, {"angularVelocity", {0, 1, 0}}});
    const Played played(kept(scene, numbered("motion-properties", 2 + i), all[i].says), 2);
    const Quatd above = all[i].outer * all[i].inner, world = above * all[i].own;
    const Vec3d middle = Vec3d{0, 1, 0} + rotate(all[i].outer, Vec3d{0, 0, 2});
    const Vec3d apart = rotate(above, Vec3d{5, 0, 0}), along = rotate(world, Vec3d{1, 0, 0});
    const Vec3d axis = rotate(world, Vec3d{0, 1, 0});
    EXPECT_LE(length(played.end("still").pose.translation - middle), 1e-12) << i;
    EXPECT_LE(length(played.end("going").linear - along), 1e-12) << i;
    EXPECT_LE(length(played.end("going").pose.translation - middle - apart - along * 2.0), 1e-9) << i;
    EXPECT_LE(length(played.end("turning").angular - axis), 1e-12) << i;
    EXPECT_LE(length(played.end("turning").pose.translation - middle + apart), 1e-12) << i;
    const Quatd turn = played.end("turning").pose.rotation * conjugate(played.at("turning", 0).pose.rotation);
    EXPECT_NEAR(std::abs(dot(turn.vector(), axis)), std::sin(1.0), 1e-6) << i;
  }
}

/// It is no pair of the fixed box around it, whose depth would be reported.
TEST(Conformance, KinematicBodiesAreNotPushed) {
  PhysicsScene scene;
  scene.node("around", collider(scene.box(3, 3, 3)));
  scene.node("inside", moving(scene.box(1, 1, 1), {{"isKinematic", true}}));
  const Played played(kept(scene, "motion-properties-05", "a kinematic body is not pushed"), 2);
  EXPECT_EQ(played.end("inside").pose.translation, Vec3d{});
  EXPECT_EQ(played.summary.deepest, 0);
  for (const SimulationFrame& frame : played.frames) EXPECT_TRUE(frame.contacts.empty());
}

/// Masses of 1 and 100 at 5 m/s into masses of 1, inelastic: both leave together, at 5 m / (m + 1).
TEST(Conformance, MassesShareTheirMomentum) {
  for (const int mass : {1, 100}) {
    PhysicsScene scene;
    const auto ball = scene.ball(0.5);
    scene.node("striking", moving(ball, {{"mass", mass}, {"gravityFactor", 0}, {"linearVelocity", {5, 0, 0}}}),
               {-2, 0, 0});
    scene.node("struck", moving(ball, {{"mass", 1}, {"gravityFactor", 0}}));
    const std::string says = std::to_string(mass) + " kg at 5 m/s into 1 kg";
    const Played played(kept(scene, "motion-properties-06-mass-" + std::to_string(mass), says), 1);
    EXPECT_NEAR(played.end("struck").linear.x, 5.0 * mass / (mass + 1), 0.01) << mass;
    EXPECT_NEAR(played.end("striking").linear.x * mass + played.end("struck").linear.x, 5.0 * mass, 1e-9 * mass);
  }
}

/// A cube that cannot turn, dropped on its edge, stays on it; one that can tips over.
TEST(Conformance, InfiniteInertiaDoesNotTip) {
  PhysicsScene scene;
  const auto cube = scene.box(1, 1, 1);
  scene.node("floor", collider(scene.box(20, 1, 20)), {0, -0.5, 0});
  const Quatd turn = Quatd::from_axis_angle({0, 0, 1}, pi / 5);
  scene.node("stiff", moving(cube, {{"mass", 1}, {"inertiaDiagonal", {0, 0, 0}}}), {-3, 1.5, 0}, turn);
  scene.node("free", moving(cube, {{"mass", 1}}), {3, 1.5, 0}, turn);
  const Played played(kept(scene, "motion-properties-07", "infinite inertia: one stands on its edge, one tips"), 3);
  const double edge = std::sqrt(0.5) * std::cos(pi / 4 - pi / 5);
  EXPECT_NEAR(played.end("stiff").pose.translation.y, edge, 0.002);
  EXPECT_NEAR(std::abs(played.end("stiff").pose.rotation.w), std::cos(pi / 10), 1e-12);
  EXPECT_NEAR(played.end("free").pose.translation.y, 0.5, 0.002);
}

}  // namespace
}  // namespace graze::io::conformance_test
