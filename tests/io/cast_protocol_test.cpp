// Casts in the query protocol, and bodies of a scene moved through it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "graze/io/cast_scene.hpp"
#include "graze/query.hpp"
#include "protocol_answer.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

/// A box of size 2 at the origin, and what is thrown at it.
std::string at_box(const std::string& b, const std::string& more = "") {
  return R"({"query": "cast", "a": {"shape": {"type": "box", "box": {"size": [2, 2, 2]}}}, "b": )" + b + more + "}";
}
const std::string ball = R"("shape": {"type": "sphere", "sphere": {"radius": 0.5}})";

void expect_vector(const Json& v, const std::vector<double>& expected, double tolerance = 1e-6) {
  ASSERT_EQ(v.size(), expected.size()) << v;
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(v[i].get<double>(), expected[i], tolerance) << v;
}

TEST(CastProtocol, GivesTimePointAndNormal) {
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    const Json answer = ask(
        at_box("{" + ball + R"(, "translation": [5.5, 0.25, 0], "linear": [-8, 0, 0]})", R"(, "id": 3)"), precision);
    EXPECT_EQ(answer["id"], 3);
    EXPECT_EQ(answer["hit"], true);
    EXPECT_NEAR(answer["t"].get<double>(), 0.5, 1e-6);
    expect_vector(answer["point"], {1, 0.25, 0}, 1e-5);
    expect_vector(answer["normal"], {1, 0, 0});
  }
}

TEST(CastProtocol, OfBothBodiesThatMove) {
  const Json answer = ask(R"({"query": "cast", "a": {)" + ball + R"(, "translation": [10, 0, 0], "linear": [2, 0, 0]},
    "b": {)" + ball + R"(, "translation": [14, 0, 0], "linear": [-4, 0, 0]}})");
  EXPECT_NEAR(answer["t"].get<double>(), 0.5, 1e-8);
  expect_vector(answer["point"], {11.5, 0, 0});
}

TEST(CastProtocol, TurnsAboutTheTranslation) {
  // A bar 4 long swings a quarter turn up to a ball above its middle.
  const Json answer = ask(R"({"query": "cast",
    "a": {"shape": {"type": "box", "box": {"size": [4, 0, 0]}}, "angular": [0, 0, 3.141592653589793]},
    "b": {"shape": {"type": "sphere", "sphere": {"radius": 0}}, "translation": [0, 1.5, 0]}})");
  EXPECT_NEAR(answer["t"].get<double>(), 0.5, 1e-8);
  expect_vector(answer["normal"], {-1, 0, 0});
}

TEST(CastProtocol, AMissHasNothingElse) {
  const std::string near = "{" + ball + R"(, "translation": [5.5, 0, 0], "linear": [-3, 0, 0]})";
  EXPECT_EQ(ask(at_box(near)), Json::parse(R"({"hit": false})"));
  EXPECT_EQ(ask(at_box(near, R"(, "duration": 2)"))["hit"], true);
  EXPECT_EQ(ask(at_box(near, R"(, "duration": 0)"))["hit"], false);
  EXPECT_EQ(ask(at_box("{" + ball + R"(, "translation": [1.6, 0, 0], "linear": [9, 0, 0]})"))["hit"], false);
}

TEST(CastProtocol, WhatOverlapsOrTouchesAtTheStartHitsAtOnce) {
  for (const char* x : {"1.5", "1.25", "0"})
    for (const char* v : {"[0, 0, 0]", "[9, 0, 0]", "[-9, 0, 0]", "[0, 9, 0]"})
      for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
        const Json answer =
            ask(at_box("{" + ball + R"(, "translation": [)" + x + R"(, 0, 0], "linear": )" + v + "}"), precision);
        EXPECT_EQ(answer["hit"], true) << x << v;
        EXPECT_EQ(answer["t"], 0) << x << v;
      }
}

// Whatever `overlap` says of the start decides, to the last bit, in both precisions.
TEST(CastProtocol, AgreesWithOverlapAtTheStart) {
  unsigned state = 5;
  const auto next = [&](double scale) {
    state = state * 1664525u + 1013904223u;
    return (static_cast<double>(state >> 8) / (1 << 23) - 1) * scale;
  };
  const std::string shapes[] = {R"({"type": "plane"})", R"({"type": "box"})", R"({"type": "sphere"})",
                                R"({"type": "capsule"})",
                                R"({"type": "mesh", "mesh": {"points": [[0, 0, 0], [1, 0, 0], [0, 0, 1]],
                                    "triangles": [[0, 1, 2]]}})"};
  int touching = 0;
  for (int i = 0; i < 600; ++i) {
    const std::string& shape = shapes[i % 5];
    // Resting on A's top within the rounding of float, far along it.
    const double far = i % 2 == 0 ? 0.3 : 3e4, up = 0.5 + next(1e-6);
    const Json position = {i % 5 == 0 ? next(far) : next(0.3), i % 5 == 0 ? up : up + (i % 5 == 4 ? 0 : 0.5), 0.2};
    const Json turned = i % 3 == 0 ? Json{0, next(1), 0, 1} : Json{0, 0, 0, 1};
    const std::string bodies = R"(, "a": {"shape": )" + shape +
                               R"(}, "b": {"shape": {"type": "box"}, "translation": )" + position.dump() +
                               R"(, "rotation": )" + turned.dump();
    for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
      if (ask(R"({"query": "overlap")" + bodies + "}}", precision)["overlap"] != true) continue;
      ++touching;
      const Json answer = ask(R"({"query": "cast")" + bodies + R"(, "linear": [0, 5, 0]}})", precision);
      EXPECT_EQ(answer["t"], 0) << bodies << answer;
    }
  }
  EXPECT_GT(touching, 300);
}

TEST(CastProtocol, HalfSpacesMoveButDoNotTurn) {
  const auto onto = [&](const std::string& plane) {
    return ask(R"({"query": "cast", "a": {"shape": {"type": "plane"})" + plane + R"(}, "b": {)" + ball +
               R"(, "translation": [0, 3, 0], "angular": [1, 2, 3]}})");
  };
  EXPECT_NEAR(onto(R"(, "linear": [1, 5, 0])")["t"].get<double>(), 0.5, 1e-8);
  EXPECT_EQ(onto("")["hit"], false);
  EXPECT_EQ(onto(R"(, "angular": [0, 0, 0])")["hit"], false);
  EXPECT_EQ(onto(R"(, "angular": [0, 1, 0])")["error"],
            "a.angular: expected no angular velocity of a half-space, got [0,1,0]");
}

TEST(CastProtocol, HalfSpacesMeet) {
  const auto planes = [&](const std::string& b, Precision precision) {
    return ask(R"({"query": "cast", "a": {"shape": {"type": "plane"}}, "b": {"shape": {"type": "plane"})" + b + "}}",
               precision);
  };
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    // They overlap and do not turn: at once, whichever way they go.
    for (const std::string motion : {"", R"(, "linear": [0, 5, 0])", R"(, "linear": [0, -5, 0])"}) {
      for (const std::string turn : {"", R"(, "rotation": [0, 0, 1, 1])", R"(, "translation": [0, 7, 0])",
                                     R"(, "rotation": [1, 0, 0, 0], "translation": [0, -1, 0])"}) {
        const Json answer = planes(turn + motion, precision);
        EXPECT_EQ(answer["hit"], true) << answer;
        EXPECT_EQ(answer["t"], 0) << answer;
        EXPECT_EQ(answer["normal"].size(), 3u) << answer;
        EXPECT_TRUE(answer["point"][1].is_number()) << answer;
      }
    }
    const std::string above = R"(, "rotation": [1, 0, 0, 0], "translation": [0, 2, 0])";
    const Json answer = planes(above + R"(, "linear": [3, -4, 0])", precision);
    EXPECT_NEAR(answer["t"].get<double>(), 0.5, 1e-6);
    expect_vector(answer["normal"], {0, 1, 0});
    EXPECT_NEAR(answer["point"][1].get<double>(), 0, 1e-5);
    EXPECT_EQ(planes(above + R"(, "linear": [3, 4, 0])", precision)["hit"], false);
    EXPECT_EQ(planes(above, precision)["hit"], false);
  }
}

TEST(CastProtocol, WhatHasNoEndInATraceIsSaidInWords) {
  const Json answer = ask(R"({"query": "cast", "a": {"shape": {"type": "plane"}},
    "b": {"shape": {"type": "plane"}, "translation": [0, 1, 0]}, "explain": true})");
  const Json& axis = answer["trace"]["axes"][0];
  EXPECT_EQ(axis["a"], Json::parse(R"(["-infinity", 0])"));
  EXPECT_EQ(axis["overlap"], "infinity");
}

TEST(CastProtocol, NamesWhatIsWrong) {
  EXPECT_EQ(ask(at_box("{" + ball + "}", R"(, "duration": -1)"))["error"],
            "duration: expected a finite number >= 0, got -1");
  EXPECT_EQ(ask(at_box("{" + ball + R"(, "linear": [1, 2]})"))["error"], "b.linear: expected an array of 3, got [1,2]");
}

TEST(CastProtocol, Composites) {
  const std::string floor = R"({"type": "mesh", "mesh": {"points": [[-5, 0, -5], [5, 0, -5], [5, 0, 5], [-5, 0, 5]],
                                "triangles": [[0, 2, 1], [0, 3, 2]]}})";
  const std::string pair = R"({"type": "compound", "compound": {"children": [
    {"shape": {"type": "sphere"}, "translation": [-2, 0, 0]}, {"shape": {"type": "sphere"}, "translation": [2, 1, 0]}]}})";
  const Json answer = ask(R"({"query": "cast", "a": {"shape": )" + floor + R"(}, "b": {"shape": )" + pair +
                          R"(, "translation": [0, 3, 0], "linear": [0, -5, 0]}})");
  EXPECT_NEAR(answer["t"].get<double>(), 0.5, 1e-8);
  expect_vector(answer["point"], {-2, 0, 0});
  expect_vector(answer["normal"], {0, 1, 0});
}

TEST(CastProtocol, TwoDimensions) {
  const auto plane = [](const std::string& a, const std::string& b) {
    return ask(R"({"dimension": 2, "query": "cast", "a": {"shape": )" + a + R"(}, "b": {"shape": )" + b + "}}");
  };
  const std::string box = R"({"type": "box", "box": {"size": [2, 2]}})";
  const std::string circle = R"({"type": "circle", "circle": {"radius": 0.5}})";
  Json answer = plane(box, circle + R"(, "translation": [5.5, 0.5], "linear": [-8, 0])");
  EXPECT_NEAR(answer["t"].get<double>(), 0.5, 1e-7);
  expect_vector(answer["normal"], {1, 0});
  expect_vector(answer["point"], {1, 0.5});
  // A square stands on its corner after an eighth of a turn, and then reaches sqrt(2) up.
  answer = plane(box + R"(, "angular": 0.7853981633974483)",
                 R"({"type": "plane"}, "rotation": 3.141592653589793, "translation": [0, 1.414213562])");
  EXPECT_EQ(answer["hit"], true);
  EXPECT_NEAR(answer["t"].get<double>(), 1, 1e-3);
  expect_vector(answer["normal"], {0, 1}, 1e-6);
  answer = plane(box, box + R"(, "translation": [0.5, 1.9], "linear": [0, 4])");
  EXPECT_EQ(answer["t"], 0);
  expect_vector(answer["normal"], {0, 1});
  EXPECT_EQ(plane(box, circle + R"(, "translation": [5.5, 1.6], "linear": [-9, 0])")["hit"], false);
  EXPECT_TRUE(plane(R"({"type": "plane"}, "angular": 1)", circle).contains("error"));
}

// Two bars that turn through each other's ways thousands of times and never meet: what could not be told says so, and
// the first contact is no earlier than its time and, if there is one, within the rest of the duration.
TEST(CastProtocol, WhatIsNotProvenIsBounded) {
  const std::string bar = R"("shape": {"type": "box", "box": {"size": [2, 0.02, 0.1]}}, "angular": [0, 0, 5000])";
  const Json answer = ask(R"({"query": "cast", "duration": 10, "a": {)" + bar + R"(}, "b": {)" + bar +
                          R"(, "translation": [1.5, 0, 0], "rotation": [0, 0, 1, 1]}})");
  ASSERT_TRUE(answer.contains("bounded")) << answer;
  EXPECT_EQ(answer["hit"], true);
  EXPECT_GT(answer["t"], 0);
  EXPECT_NEAR(answer["t"].get<double>() + answer["bounded"].get<double>(), 10, 1e-12);
  const Json proven = ask(R"({"query": "cast", "duration": 10, "a": {)" + bar + R"(}, "b": {)" + bar +
                          R"(, "translation": [0.5, 0, 0], "rotation": [0, 0, 1, 1]}})");
  EXPECT_FALSE(proven.contains("bounded")) << proven;
}

TEST(CastProtocol, CanBeExplained) {
  const Json answer =
      ask(at_box("{" + ball + R"(, "translation": [5.5, 0, 0], "linear": [-8, 0, 0]})", R"(, "explain": true)"));
  EXPECT_EQ(answer["trace"]["method"], "conservative advancement");
}

// ------------------------------------------------------------------------- scenes

/// A floor, a crate on it, a wall, a gate that is a trigger, a ghost that the crate may not hit, and a dumbbell.
Scene room() {
  Scene scene;
  scene.source = "room";
  const auto add = [&](const std::string& name, const Shaped& shape, const Vec3d& at, int body = -1) {
    if (body < 0) {
      scene.bodies.push_back({name, -1, MotionType::dynamic, {}});
      body = static_cast<int>(scene.bodies.size()) - 1;
    }
    scene.colliders.push_back({name, -1, static_cast<std::uint32_t>(body), shape, {at, {}}, {}, false, {}});
  };
  const Shaped unit{Box<double>({1, 1, 1})};
  add("floor", HalfSpace<double>(), {});
  add("crate", unit, {0, 0.5, 0});
  add("wall", Box<double>({1, 4, 9}), {6.5, 2, 0});
  add("gate", unit, {2, 0.5, 0});
  scene.colliders.back().trigger = true;
  add("ghost", unit, {3, 0.5, 0});
  scene.colliders.back().filter = {2, 2, 0};
  add("dumbbell", Sphere<double>(0.5), {-1, 3, 0});
  add("weight", Sphere<double>(0.5), {1, 3, 0}, 5);
  return scene;
}

SceneCast cast_of(const std::string& from, const Vec3d& motion, const Vec3d& spin = {}) {
  SceneCast question;
  question.from = from;
  question.velocity = {motion, spin};
  question.options.separating = Separating::ignored;
  return question;
}

TEST(CastScene, SlidesToTheWall) {
  const Scene scene = room();
  SceneCast question = cast_of("crate", {11, 0, 0});
  const auto hits = cast_scene(scene, question);
  ASSERT_EQ(hits.size(), 1u);  // not the floor it slides on, not the trigger, not the ghost
  EXPECT_EQ(scene.colliders[hits[0].other].name, "wall");
  EXPECT_NEAR(hits[0].t, 0.5, 1e-7);
  EXPECT_NEAR(hits[0].normal.x, 1, 1e-9);
  question.options.separating = Separating::hit;
  EXPECT_EQ(cast_scene(scene, question).front().t, 0);
  question.precision = Precision::single_precision;
  EXPECT_EQ(cast_scene(scene, question).front().t, 0);
}

TEST(CastScene, ABodyOfTwoTurnsAsAWhole) {
  const Scene scene = room();
  SceneCast question = cast_of("dumbbell", {}, {0, 0, 3.141592653589793});
  question.about = Vec3d{0, 3, 0};
  question.duration = 10;
  EXPECT_TRUE(cast_scene(scene, question).empty());
  question.about = Vec3d{0, 2, 0};  // now the balls come down to 2 - sqrt(2) - 0.5, and before that to the crate
  const auto hits = cast_scene(scene, question);
  ASSERT_FALSE(hits.empty());
  const Mover mover = find_mover(scene, question);
  const SceneHit& hit = hits.front();
  const Collider& own = scene.colliders[hit.collider];
  const Posed there = mover.pose_at(own.pose, question.velocity, hit.t);
  EXPECT_NEAR(distance(own.shape, there, scene.colliders[hit.other].shape, scene.colliders[hit.other].pose).distance, 0,
              1e-7);
  EXPECT_EQ(scene.colliders[hit.other].name, "crate");
}

/// A drawing's body flies to the wall, and turns about a point beside it.
TEST(CastScene, InThePlane) {
  const PlaneScene scene = load_plane_json(
      R"x({"dimension": 2, "bodies": [
        {"name": "ball", "motion": "dynamic", "shape": {"type": "circle", "circle": {"radius": 0.5}}},
        {"name": "wall", "translation": [4, 0], "shape": {"type": "box", "box": {"size": [1, 10]}}}]})x",
      "test");
  const auto hits = cast_scene(scene, cast_of("ball", {2, 0, 0}));
  ASSERT_EQ(hits.size(), 0u);  // 1 unit of time: it comes as far as 2.5
  SceneCast question = cast_of("ball", {4, 0, 0});
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    question.precision = precision;
    const auto met = cast_scene(scene, question);
    ASSERT_EQ(met.size(), 1u);
    EXPECT_NEAR(met[0].t, 0.75, 1e-6);
    EXPECT_NEAR(met[0].normal.x, 1, 1e-6);
    EXPECT_EQ(met[0].point.z, 0);
    EXPECT_EQ(scene.bodies[scene.colliders[met[0].other].body].name, "wall");
  }
  SceneCast around = cast_of("ball", {}, {0, 0, -1});
  around.about = Vec3d{2, 2.25, 0};
  around.duration = 6;
  ASSERT_EQ(cast_scene(scene, around).size(), 1u);  // on a circle of radius 3.01 about a point 1.5 before the wall
  EXPECT_THROW(cast_scene(scene, cast_of("ball", {1, 0, 1})), InvalidValue);
  EXPECT_THROW(cast_scene(scene, cast_of("ball", {}, {1, 0, 0})), InvalidValue);
  around.about = Vec3d{2, 2.25, 1};
  EXPECT_THROW(cast_scene(scene, around), InvalidValue);
  EXPECT_THROW(cast_scene(scene, cast_of("nobody", {1, 0, 0})), InvalidValue);
}

TEST(CastScene, RefusesWhatItCannotDo) {
  Scene scene = room();
  EXPECT_THROW(cast_scene(scene, cast_of("nobody", {1, 0, 0})), InvalidValue);
  EXPECT_THROW(cast_scene(scene, cast_of("gate", {1, 0, 0})), InvalidValue);
  EXPECT_THROW(cast_scene(scene, cast_of("floor", {}, {0, 0, 1})), InvalidValue);
  EXPECT_THROW(cast_scene(scene, cast_of("crate", {std::nan(""), 0, 0})), InvalidValue);
  EXPECT_EQ(cast_scene(scene, cast_of("weight", {0, 0, 1})).size(), 0u);  // one collider of a body, by its own name
  scene.bodies[3].name = "crate";
  EXPECT_THROW(cast_scene(scene, cast_of("crate", {1, 0, 0})), InvalidValue);
}

TEST(CastScene, IsDrawn) {
  const auto file = std::filesystem::temp_directory_path() / "graze_cast_scene_test.glb";
  const Scene scene = room();
  const SceneCast question = cast_of("crate", {11, 0, 0}, {0, 1, 0});
  write_cast(file, scene, question, cast_scene(scene, question));
  const Scene drawn = load_scene(file);
  const auto count = [&](const std::string& name) {
    return std::count_if(drawn.colliders.begin(), drawn.colliders.end(), [&](const auto& c) { return c.name == name; });
  };
  EXPECT_EQ(count("impact"), 1);
  EXPECT_EQ(count("ghost"), 1 + 3);  // the scene has a body of that name
  EXPECT_EQ(count("path"), 1);
  EXPECT_EQ(count("contact"), 1);
  EXPECT_EQ(count("normal"), 1);
  EXPECT_EQ(count("wall"), 1);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace graze::io
