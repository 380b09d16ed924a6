// Triggers of scenes that are played: they move along with their bodies and report what comes in and leaves.
#include <gtest/gtest.h>

#include "graze/io/plane_simulate.hpp"
#include "physics_scene.hpp"

namespace graze::io::trigger_scenes_test {
namespace {

using Json = nlohmann::json;

constexpr double fall = 9.81, frame = 1.0 / 60;

/// What is reported, as text: the sign, the trigger and the body.
template <class AnyScene>
std::vector<std::string> told(const AnyScene& scene, const SimulateSummary& summary) {
  std::vector<std::string> lines;
  for (const TriggerEvent& event : summary.triggers)
    lines.push_back((event.begins ? "+" : "-") + scene.colliders[event.trigger].name + " " +
                    scene.bodies[event.body].name);
  return lines;
}
using Lines = std::vector<std::string>;

Json geometry_of(std::size_t shape) { return {{"geometry", {{"shape", shape}}}}; }

/// A feeler below a crate meets the floor before the crate does, and weighs nothing: the crate falls as if alone.
TEST(TriggerScenes, FallWithTheirBody) {
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    PhysicsScene scene;
    scene.node("floor", {{"collider", geometry_of(scene.box(20, 1, 20))}}, {0, -0.5, 0});
    const auto cube = scene.box(1, 1, 1);
    const auto crate = scene.node("crate", {{"collider", geometry_of(cube)}, {"motion", {{"mass", 1}}}}, {0, 5, 0});
    scene.put_below(crate, scene.node("feeler", {{"trigger", geometry_of(scene.box(0.1, 3, 0.1))}}, {0, -1, 0}));
    const Played played(scene, 3, {.precision = precision});
    EXPECT_EQ(told(played.scene, played.summary), (Lines{"+feeler floor"}));
    EXPECT_NEAR(played.summary.triggers.at(0).time, std::sqrt(2 * 2.5 / fall), frame);
    EXPECT_NEAR(played.end("crate").pose.translation.y, 0.5, 0.002);
    EXPECT_TRUE(played.end("crate").asleep);
    EXPECT_NEAR(played.place("crate", 0.5).y, 5 - fall / 8, 1e-5);
  }
}

/// One that an animation moves passes a crate that sleeps, and does not wake it. A body of several parts comes in once.
TEST(TriggerScenes, FollowTheirAnimation) {
  PhysicsScene scene;
  scene.node("floor", {{"collider", geometry_of(scene.box(40, 1, 40))}}, {0, -0.5, 0});
  const auto cube = scene.box(1, 1, 1);
  const auto gate = scene.node("gate", {{"trigger", geometry_of(scene.box(1, 1, 1))}}, {-9, 0.6, 0});
  const auto smooth = scene.material({{"dynamicFriction", 0.1}});
  const auto pair = scene.node("pair", {{"motion", {{"mass", 2}}}}, {0, 0.5, 0});
  scene.put_below(pair, scene.node("left", {{"collider", geometry_of(cube)}}, {-1, 0, 0}));
  scene.put_below(pair,
                  scene.node("right", with({{"collider", geometry_of(cube)}}, "physicsMaterial", smooth), {1, 0, 0}));
  scene.animate(gate, {0, 3, 5}, {-9, 0.6f, 0, -6, 0.6f, 0, 6, 0.6f, 0});
  const Played played(scene, 5);
  EXPECT_EQ(told(played.scene, played.summary), (Lines{"+gate pair", "-gate pair"}));
  // At 6 m/s from three seconds on: from 2 m before the middle to 2 m behind it.
  EXPECT_NEAR(played.summary.triggers.at(0).time, 3 + 4.0 / 6, 1.5 * frame);
  EXPECT_NEAR(played.summary.triggers.at(1).time, 3 + 8.0 / 6, 1.5 * frame);
  EXPECT_TRUE(played.at("pair", 3).asleep);
  EXPECT_TRUE(played.end("pair").asleep);
}

/// What leaves one part of a body for another between two frames has been inside all the time.
TEST(TriggerScenes, AJumpFromPartToPartIsNoEvent) {
  PhysicsScene scene;
  const auto cube = scene.box(1, 1, 1);
  const auto gate = scene.node("gate", {{"trigger", geometry_of(scene.box(0.5, 0.5, 0.5))}}, {-2, 0, 0});
  const auto pair = scene.node("pair", {{"motion", {{"mass", 2}, {"gravityFactor", 0}}}});
  const auto smooth = scene.material({{"dynamicFriction", 0.1}});
  scene.put_below(pair, scene.node("left", {{"collider", geometry_of(cube)}}, {-2, 0, 0}));
  scene.put_below(pair,
                  scene.node("right", with({{"collider", geometry_of(cube)}}, "physicsMaterial", smooth), {2, 0, 0}));
  scene.animate(gate, {0, 1, 1.001f}, {-2, 0, 0, -2, 0, 0, 2, 0, 0});
  const Played played(scene, 2);
  EXPECT_EQ(told(played.scene, played.summary), (Lines{"+gate pair"}));
}

PlaneScene drawn(const std::string& bodies) {
  return load_plane_json("{\"dimension\": 2, \"bodies\": [" + bodies + "]}", "t.json");
}
SimulateSummary played(const PlaneScene& scene, double seconds) {
  return simulate(scene, {.seconds = seconds}, [](const PlaneSimulationFrame&) {});
}

/// In the plane a zone that stands, one that moves by itself, and a feeler of a falling crate.
TEST(TriggerScenes, OfThePlane) {
  const std::string square = R"("shape": {"type": "box", "box": {"size": [1, 1]}})";
  const PlaneScene standing = drawn(R"({"name": "zone", "trigger": true, )" + square + R"(, "translation": [0, 5]},
      {"name": "stone", "motion": "dynamic", )" +
                                    square + R"(, "translation": [0, 10]})");
  const SimulateSummary past = played(standing, 2);
  ASSERT_EQ(told(standing, past), (Lines{"+zone stone", "-zone stone"}));
  EXPECT_NEAR(past.triggers[0].time, std::sqrt(2 * 4 / fall), frame);
  EXPECT_NEAR(past.triggers[1].time, std::sqrt(2 * 6 / fall), frame);

  const PlaneScene sweeping = drawn(R"({"name": "post", )" + square + R"(}, {"name": "beam", "trigger": true,
      "motion": "kinematic", "linear": [4, 0], "translation": [-5, 0], )" +
                                    square + "}");
  const SimulateSummary swept = played(sweeping, 2);
  EXPECT_EQ(told(sweeping, swept), (Lines{"+beam post", "-beam post"}));
  EXPECT_NEAR(swept.triggers.at(0).time, 1, frame);
  EXPECT_NEAR(swept.triggers.at(1).time, 1.5, frame);

  const PlaneScene feeling = drawn(R"({"name": "floor", "shape": {"type": "plane"}},
      {"name": "crate", "body": "crate", "motion": "dynamic", "translation": [0, 5], )" +
                                   square + R"(},
      {"name": "feeler", "body": "crate", "motion": "dynamic", "trigger": true, "translation": [0, 4],
       "shape": {"type": "box", "box": {"size": [0.1, 3]}}})");
  const SimulateSummary felt = played(feeling, 2);
  ASSERT_EQ(told(feeling, felt), (Lines{"+feeler floor"}));
  EXPECT_NEAR(felt.triggers[0].time, std::sqrt(2 * 2.5 / fall), frame);
}

}  // namespace
}  // namespace graze::io::trigger_scenes_test
