// What a simulation needs of a scene: motions, materials and joints as KHR_physics_rigid_bodies has them.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "gltf_text.hpp"

namespace graze::io::scene_physics_test {
namespace {

using Json = nlohmann::json;

constexpr double infinity = std::numeric_limits<double>::infinity();
const double root = std::sqrt(0.5);

/// A floor, and a crate that hangs on it; the crate's parent is turned by 90 degrees about y.
Json base() {
  return Json::parse(R"({
    "asset": {"version": "2.0"},
    "extensions": {
      "KHR_implicit_shapes": {"shapes": [{"type": "box", "box": {"size": [1, 1, 1]}}]},
      "KHR_physics_rigid_bodies": {
        "physicsMaterials": [{}],
        "physicsJoints": [{"limits": [{"linearAxes": [0, 1, 2], "min": 0, "max": 0}],
                           "drives": [{"type": "linear", "mode": "force", "axis": 0}]}]}},
    "nodes": [
      {"name": "floor", "translation": [0, -1, 0], "children": [4],
       "extensions": {"KHR_physics_rigid_bodies": {"collider": {"geometry": {"shape": 0}}}}},
      {"name": "turned", "translation": [1, 2, 3], "rotation": [0, 0.70710678118654752, 0, 0.70710678118654752],
       "children": [2]},
      {"name": "crate", "children": [3],
       "extensions": {"KHR_physics_rigid_bodies": {
         "motion": {"mass": 2}, "collider": {"geometry": {"shape": 0}, "physicsMaterial": 0}}}},
      {"name": "pivot", "translation": [0, 0, 2],
       "extensions": {"KHR_physics_rigid_bodies": {"joint": {"joint": 0, "connectedNode": 4}}}},
      {"name": "hook", "translation": [0, 3, 0]}]})");
}

Json& physics(Json& scene, std::size_t node) { return scene["nodes"][node]["extensions"]["KHR_physics_rigid_bodies"]; }
Json& lists(Json& scene) { return scene["extensions"]["KHR_physics_rigid_bodies"]; }
Json& motion(Json& scene) { return physics(scene, 2)["motion"]; }
Scene load(const Json& json) { return load_gltf(json.dump(), "test.gltf"); }

const Body& crate(const Scene& scene) {
  for (const Body& body : scene.bodies)
    if (body.name == "crate") return body;
  throw std::logic_error("no crate");
}

void expect_near(const Vec3d& found, const Vec3d& wanted) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], wanted[i], 1e-15) << i;
}

TEST(ScenePhysics, WhatAFileLeavesOutIsLeftOut) {
  Json json = base();
  motion(json) = Json::object();
  const Scene scene = load(json);
  const BodyMotion& m = *crate(scene).motion;
  EXPECT_FALSE(m.kinematic || m.mass || m.center_of_mass || m.inertia_diagonal);
  EXPECT_EQ(m.gravity_factor, 1);
  for (const Collider& c : scene.colliders) {
    if (c.name == "floor") {
      EXPECT_FALSE(c.material);
      continue;
    }
    ASSERT_TRUE(c.material);
    EXPECT_EQ(c.material->static_friction, 0.6);
    EXPECT_EQ(c.material->dynamic_friction, 0.6);
    EXPECT_EQ(c.material->restitution, 0);
    EXPECT_EQ(c.material->friction_combine, Combine::unset);
    EXPECT_EQ(c.material->restitution_combine, Combine::unset);
  }
}

TEST(ScenePhysics, MaterialsHaveTheirModes) {
  Json json = base();
  const std::pair<const char*, Combine> modes[] = {{"average", Combine::average},
                                                   {"minimum", Combine::minimum},
                                                   {"maximum", Combine::maximum},
                                                   {"multiply", Combine::multiply}};
  for (const auto& [name, mode] : modes) {
    lists(json)["physicsMaterials"][0] = {{"staticFriction", 10},
                                          {"dynamicFriction", 0.25},
                                          {"restitution", 0.5},
                                          {"frictionCombine", name},
                                          {"restitutionCombine", name}};
    const Scene scene = load(json);
    for (const Collider& c : scene.colliders)
      if (c.name == "crate") {
        EXPECT_EQ(c.material->static_friction, 10);
        EXPECT_EQ(c.material->dynamic_friction, 0.25);
        EXPECT_EQ(c.material->restitution, 0.5);
        EXPECT_EQ(c.material->friction_combine, mode);
        EXPECT_EQ(c.material->restitution_combine, mode);
      }
  }
}

/// The reader says so, and not the simulation later.
TEST(ScenePhysics, RestitutionIsAtMostOne) {
  Json json = base();
  lists(json)["physicsMaterials"][0] = {{"restitution", 1}};
  EXPECT_NO_THROW(load(json));
  lists(json)["physicsMaterials"][0] = {{"restitution", 1.5}};
  try {
    load(json);
    FAIL() << "taken";
  } catch (const InvalidValue& e) {
    EXPECT_NE(std::string(e.what()).find("a number from 0 to 1"), std::string::npos) << e.what();
  }
}

TEST(ScenePhysics, ZeroMassAndInertiaAreInfinite) {
  Json json = base();
  motion(json) = {{"mass", 0}, {"inertiaDiagonal", {0, 3, 0}}};
  const Scene scene = load(json);
  const BodyMotion& m = *crate(scene).motion;
  EXPECT_EQ(m.mass, infinity);
  EXPECT_EQ(*m.inertia_diagonal, (Vec3d{infinity, 3, infinity}));
}

/// The parent's quarter turn about y takes x to -z and z to x.
TEST(ScenePhysics, MotionsTurnWithTheirParents) {
  Json json = base();
  motion(json) = {{"mass", 2},
                  {"centerOfMass", {0.5, 0, 0.25}},
                  {"inertiaDiagonal", {1, 2, 3}},
                  {"inertiaOrientation", {0, 0, 2, 2}},
                  {"linearVelocity", {1, 2, 0}},
                  {"angularVelocity", {0, 0, 3}},
                  {"gravityFactor", -0.5},
                  {"isKinematic", true}};
  json["nodes"][2]["scale"] = {2, 2, 2};
  const Scene scene = load(json);
  const Body& body = crate(scene);
  EXPECT_EQ(body.type, MotionType::kinematic);
  expect_near(body.pose.translation, {1, 2, 3});
  expect_near(rotate(body.pose.rotation, Vec3d{1, 0, 0}), {0, 0, -1});
  const BodyMotion& m = *body.motion;
  expect_near(m.linear_velocity, {0, 2, -1});
  expect_near(m.angular_velocity, {3, 0, 0});
  // In the body's frame, which has no scale.
  expect_near(*m.center_of_mass, {1, 0, 0.5});
  EXPECT_EQ(*m.inertia_diagonal, (Vec3d{1, 2, 3}));
  EXPECT_NEAR(m.inertia_orientation.z, root, 1e-15);
  EXPECT_NEAR(m.inertia_orientation.w, root, 1e-15);
  EXPECT_EQ(m.gravity_factor, -0.5);
}

TEST(ScenePhysics, AMirroredNodeHasAFrameToo) {
  Json json = base();
  json["nodes"][2]["scale"] = {1, 1, -2};
  motion(json)["centerOfMass"] = {0, 0, 1};
  const Scene scene = load(json);
  const Body& body = crate(scene);
  // The node's z axis has become -2 x; the body's frame is right-handed, so its own z is +x.
  expect_near(rotate(body.pose.rotation, Vec3d{0, 0, 1}), {1, 0, 0});
  expect_near(*body.motion->center_of_mass, {0, 0, -2});
}

/// Negative scales leave a body's rotation that of its nodes, and velocities along the node's axes. Two of them are no
/// half turn. The crate hangs on a quarter turn about y, which takes x to -z and z to x.
TEST(ScenePhysics, NegativeScalesTurnNoBody) {
  for (const Vec3d& s : {Vec3d{-1, 1, 1}, Vec3d{1, -1, 1}, Vec3d{1, 1, -3}, Vec3d{-1, -2, 1}, Vec3d{-1, -1, -1}}) {
    Json json = base();
    json["nodes"][2]["scale"] = {s.x, s.y, s.z};
    motion(json) = {{"mass", 2},
                    {"linearVelocity", {1, 2, 3}},
                    {"angularVelocity", {4, 5, 6}},
                    {"inertiaDiagonal", {1, 2, 3}},
                    {"inertiaOrientation", {0.1, 0.3, 0.5, 0.8}}};
    const Scene scene = load(json);
    const Body& body = crate(scene);
    expect_near(rotate(body.pose.rotation, Vec3d{1, 0, 0}), {0, 0, -1});
    expect_near(rotate(body.pose.rotation, Vec3d{0, 0, 1}), {1, 0, 0});
    const Vec3d sign{std::copysign(1.0, s.x), std::copysign(1.0, s.y), std::copysign(1.0, s.z)};
    expect_near(body.motion->linear_velocity, {3 * sign.z, 2 * sign.y, -sign.x});
    expect_near(body.motion->angular_velocity, {6 * sign.z, 5 * sign.y, -4 * sign.x});
    // The first principal axis, which is that of the file with the node's axes.
    const Vec3d axis = rotate(normalized(Quatd{0.1, 0.3, 0.5, 0.8}), Vec3d{1, 0, 0});
    const Vec3d found = rotate(body.motion->inertia_orientation, Vec3d{1, 0, 0});
    EXPECT_NEAR(std::abs(dot(found, scaled(axis, sign))), 1, 1e-12);
  }
}

/// A mirror above a turned node turns the node the other way round, and a matrix may mirror as a scale does.
TEST(ScenePhysics, MirrorsAboveANodeReflectItsTurn) {
  const double half = 0.5 * std::sqrt(2.0);
  Json json = base();
  json["nodes"][2]["rotation"] = {0, 0, half, half};  // a quarter turn about z, x to y
  Json& parent = json["nodes"][1];
  parent.erase("rotation");
  for (const bool matrix : {false, true}) {
    if (matrix) {
      parent.erase("translation");
      parent["matrix"] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    } else {
      parent["scale"] = {-1, 1, 1};
    }
    motion(json)["linearVelocity"] = {1, 2, 3};
    const Scene scene = load(json);
    const Body& body = crate(scene);
    expect_near(rotate(body.pose.rotation, Vec3d{1, 0, 0}), {0, -1, 0});
    expect_near(rotate(body.pose.rotation, Vec3d{0, 0, 1}), {0, 0, 1});
    // The node's x axis is y of the world, and its y axis, -x of the mirrored space, is x.
    expect_near(body.motion->linear_velocity, {2, 1, 3});
  }
}

TEST(ScenePhysics, JointsHoldTheirFramesInTheirBodies) {
  Json json = base();
  physics(json, 3)["joint"]["enableCollision"] = true;
  const Scene scene = load(json);
  ASSERT_EQ(scene.joints.size(), 1u);
  const Joint& joint = scene.joints[0];
  EXPECT_EQ(joint.name, "pivot");
  EXPECT_EQ(joint.node, 3);
  ASSERT_TRUE(joint.body_a && joint.body_b);
  EXPECT_EQ(scene.bodies[*joint.body_a].name, "crate");
  EXPECT_EQ(scene.bodies[*joint.body_b].name, "floor");  // whose child the hook is, so that the two do not collide
  expect_near(joint.frame_a.translation, {0, 0, 2});
  expect_near(joint.frame_b.translation, {0, 3, 0});
  EXPECT_TRUE(joint.enable_collision);
  ASSERT_EQ(joint.limits.size(), 1u);
  EXPECT_FALSE(joint.limits[0].angular);
  EXPECT_EQ(joint.limits[0].axes, (std::array<bool, 3>{true, true, true}));
  EXPECT_EQ(joint.limits[0].max, 0);
  EXPECT_FALSE(joint.limits[0].stiffness);
  ASSERT_EQ(joint.drives.size(), 1u);
  EXPECT_EQ(joint.drives[0].max_force, infinity);
}

TEST(ScenePhysics, AJointOnNothingHoldsTheWorld) {
  Json json = base();
  json["nodes"][0].erase("children");
  json["nodes"][4]["rotation"] = {0, 0, 1, 0};
  const Scene scene = load(json);
  ASSERT_EQ(scene.joints.size(), 1u);
  EXPECT_FALSE(scene.joints[0].body_b);
  expect_near(scene.joints[0].frame_b.translation, {0, 3, 0});
  expect_near(rotate(scene.joints[0].frame_b.rotation, Vec3d{1, 0, 0}), {-1, 0, 0});
}

TEST(ScenePhysics, LimitsAndDrivesAreReadWhole) {
  Json json = base();
  lists(json)["physicsJoints"][0] = Json::parse(R"({
    "limits": [{"angularAxes": [2, 0], "max": 0.5, "stiffness": 0, "damping": 3},
               {"linearAxes": [1], "min": -2, "stiffness": 100}],
    "drives": [{"type": "angular", "mode": "acceleration", "axis": 2, "maxForce": 3.4028234663852886e38,
                "positionTarget": -1, "velocityTarget": 1.5, "stiffness": 7, "damping": 8}]})");
  const Scene scene = load(json);
  const Joint& joint = scene.joints.at(0);
  ASSERT_EQ(joint.limits.size(), 2u);
  EXPECT_TRUE(joint.limits[0].angular);
  EXPECT_EQ(joint.limits[0].axes, (std::array<bool, 3>{true, false, true}));
  EXPECT_EQ(joint.limits[0].min, -infinity);
  EXPECT_EQ(joint.limits[0].max, 0.5);
  EXPECT_EQ(joint.limits[0].stiffness, 0.0);  // a spring without force is not a hard limit
  EXPECT_EQ(joint.limits[0].damping, 3);
  EXPECT_FALSE(joint.limits[1].angular);
  EXPECT_EQ(joint.limits[1].min, -2);
  EXPECT_EQ(joint.limits[1].max, infinity);
  EXPECT_EQ(joint.limits[1].stiffness, 100.0);
  ASSERT_EQ(joint.drives.size(), 1u);
  const JointDrive& drive = joint.drives[0];
  EXPECT_TRUE(drive.angular && drive.acceleration);
  EXPECT_EQ(drive.axis, 2);
  EXPECT_EQ(drive.max_force, 3.4028234663852886e38);
  EXPECT_EQ(drive.position_target, -1);
  EXPECT_EQ(drive.velocity_target, 1.5);
  EXPECT_EQ(drive.stiffness, 7);
  EXPECT_EQ(drive.damping, 8);
}

/// Two scenes in one: the bodies of the second move up, and so do what its joints hold.
TEST(ScenePhysics, JointsMoveUpWithTheirBodies) {
  Scene scene = load(base());
  const std::size_t bodies = scene.bodies.size();
  append(scene, load(base()));
  ASSERT_EQ(scene.joints.size(), 2u);
  EXPECT_EQ(*scene.joints[1].body_a, *scene.joints[0].body_a + bodies);
  EXPECT_EQ(*scene.joints[1].body_b, *scene.joints[0].body_b + bodies);
}

TEST(ScenePhysics, AJointThatHoldsNothingIsSkipped) {
  Json json = base();
  physics(json, 3)["joint"]["connectedNode"] = 2;
  Scene scene = load(json);
  EXPECT_TRUE(scene.joints.empty());
  ASSERT_EQ(scene.notices.size(), 1u);
  EXPECT_EQ(scene.notices[0], "pivot: a joint of what cannot move against each other is skipped");
  json = base();
  physics(json, 2).erase("motion");
  scene = load(json);
  EXPECT_TRUE(scene.joints.empty());
  EXPECT_EQ(scene.notices.size(), 1u);
}

TEST(ScenePhysics, WhatIsWrongIsNamed) {
  const auto refusal = [](const std::function<void(Json&)>& change) {
    Json json = base();
    change(json);
    return gltf_refusal(json);
  };
  const auto of_motion = [&](const char* key, const Json& value) {
    return refusal([&](Json& json) { motion(json)[key] = value; });
  };
  const std::string at = "test.gltf: nodes[2].extensions.KHR_physics_rigid_bodies.motion.";
  EXPECT_EQ(of_motion("mass", -1), at + "mass: expected a finite number >= 0, got -1");
  EXPECT_EQ(of_motion("mass", "2"), at + "mass: expected a finite number >= 0, got \"2\"");
  EXPECT_EQ(of_motion("inertiaDiagonal", {1, 1, -1}), at + "inertiaDiagonal[2]: expected a finite number >= 0, got -1");
  EXPECT_EQ(of_motion("inertiaDiagonal", {1, 3, 1}),
            at +
                "inertiaDiagonal[1]: expected a moment of inertia that is at most the sum of the two others, 2, got 3");
  EXPECT_EQ(of_motion("inertiaDiagonal", {1, 2, 1}), "loaded");
  EXPECT_EQ(of_motion("inertiaDiagonal", {1, 0, 1}), "loaded");
  EXPECT_EQ(of_motion("inertiaOrientation", {0, 0, 0, 0}),
            at + "inertiaOrientation: expected a quaternion that is not zero, got [0,0,0,0]");
  EXPECT_EQ(of_motion("isKinematic", 1), at + "isKinematic: expected true or false, got 1");
  EXPECT_NE(of_motion("gravityFactor", nullptr).find("gravityFactor: expected a finite number"), std::string::npos);
  EXPECT_NE(of_motion("linearVelocity", {1, 2}).find("linearVelocity: expected"), std::string::npos);

  const auto of_material = [&](const char* key, const Json& value) {
    return refusal([&](Json& json) { lists(json)["physicsMaterials"][0][key] = value; });
  };
  const std::string material = "test.gltf: extensions.KHR_physics_rigid_bodies.physicsMaterials[0].";
  EXPECT_EQ(of_material("frictionCombine", "min"),
            material + "frictionCombine: expected one of average, minimum, maximum, multiply, got \"min\"");
  EXPECT_EQ(of_material("restitutionCombine", 3), material + "restitutionCombine: expected a string, got 3");
  EXPECT_EQ(of_material("restitution", -0.5), material + "restitution: expected a finite number >= 0, got -0.5");

  const auto of_limit = [&](const char* limit) {
    return refusal([&](Json& json) { lists(json)["physicsJoints"][0]["limits"][0] = Json::parse(limit); });
  };
  const std::string limit = "test.gltf: extensions.KHR_physics_rigid_bodies.physicsJoints[0].limits[0]";
  EXPECT_EQ(of_limit(R"({"min": 0})"), limit + ": expected either linearAxes or angularAxes, got neither");
  EXPECT_EQ(of_limit(R"({"linearAxes": [0], "angularAxes": [0]})"),
            limit + ": expected either linearAxes or angularAxes, got both");
  EXPECT_EQ(of_limit(R"({"linearAxes": []})"),
            limit + ".linearAxes: expected one to three axes, each 0, 1 or 2, got []");
  EXPECT_EQ(of_limit(R"({"linearAxes": [0, 3]})"), limit + ".linearAxes[1]: expected an index below 3, got 3");
  EXPECT_EQ(of_limit(R"({"linearAxes": [1, 1]})"),
            limit + ".linearAxes[1]: expected an axis that is not named twice, got 1");
  EXPECT_EQ(of_limit(R"({"linearAxes": [1], "min": 2, "max": 1})"),
            limit + ".min: expected at most the limit's max, 1, got 2");
  EXPECT_EQ(of_limit(R"({"angularAxes": [1, 2], "max": -1})"),
            limit + ".max: expected at least 0 of a limit with several axes, got -1");
  EXPECT_EQ(of_limit(R"({"linearAxes": [1], "stiffness": -1})"),
            limit + ".stiffness: expected a finite number >= 0, got -1");

  const auto of_drive = [&](const char* key, const Json& value) {
    return refusal([&](Json& json) { lists(json)["physicsJoints"][0]["drives"][0][key] = value; });
  };
  const std::string drive = "test.gltf: extensions.KHR_physics_rigid_bodies.physicsJoints[0].drives[0].";
  EXPECT_EQ(of_drive("type", "turn"), drive + "type: expected linear or angular, got \"turn\"");
  EXPECT_EQ(of_drive("mode", "speed"), drive + "mode: expected force or acceleration, got \"speed\"");
  EXPECT_EQ(of_drive("axis", 3), drive + "axis: expected an index below 3, got 3");
  EXPECT_EQ(of_drive("maxForce", -1), drive + "maxForce: expected a finite number >= 0, got -1");

  const auto of_joint = [&](const char* key, const Json& value) {
    return refusal([&](Json& json) { physics(json, 3)["joint"][key] = value; });
  };
  const std::string joint = "test.gltf: nodes[3].extensions.KHR_physics_rigid_bodies.joint.";
  EXPECT_EQ(of_joint("joint", 1), joint + "joint: expected an index below 1, got 1");
  EXPECT_EQ(of_joint("connectedNode", 9), joint + "connectedNode: expected an index below 5, got 9");
  EXPECT_EQ(refusal([&](Json& json) { physics(json, 3)["joint"].erase("connectedNode"); }),
            joint + "connectedNode: expected a value, got nothing");
  EXPECT_EQ(refusal([&](Json& json) {
              json["scenes"] = {{{"nodes", {1}}}};
            }),
            joint + "connectedNode: expected a node of the scene, got 4");
  EXPECT_EQ(refusal([&](Json& json) { json["nodes"][3]["scale"] = {1, 0, 1}; }).substr(0, 20), "test.gltf: nodes[3]:");
}

}  // namespace
}  // namespace graze::io::scene_physics_test
