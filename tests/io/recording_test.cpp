// Frames written to a file and read back: the animation puts every body where its frame had it.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "gltf_text.hpp"
#include "graze/io/collide_frames.hpp"
#include "graze/io/recording.hpp"
#include "io/collider_motion.hpp"

namespace graze::io::recording_test {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// A folder of its own for each test, removed at its end.
class RecordingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::temp_directory_path() / ("graze_recording_" + std::to_string(getpid()) + "_" + test->name());
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string put(const Json& json) const {
    const fs::path file = folder / "scene.gltf";
    std::ofstream(file) << json.dump();
    return file.string();
  }
  static std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder;
};

Json rigid(const Json& motion) {
  Json physics{{"collider", {{"geometry", {{"shape", 0}}}}}};
  if (!motion.is_null()) physics["motion"] = motion;
  return {{"KHR_physics_rigid_bodies", physics}};
}

/// Bodies under turned, evenly scaled, unevenly scaled and mirrored ancestors, one with a matrix, and one below another
/// that moves by itself. The nodes stand in another order than the tree.
Json family() {
  Json json = Json::parse(R"({
    "asset": {"version": "2.0"},
    "extensions": {"KHR_implicit_shapes": {"shapes": [{"type": "box", "box": {"size": [1, 2, 3]}}]}},
    "extras": {"kept": "as it was"},
    "nodes": [
      {"name": "child", "translation": [0, 1, 0], "rotation": [0, 0.6, 0, 0.8]},
      {"name": "parent", "translation": [1, 0, 0], "scale": [2, 2, 2], "children": [0]},
      {"name": "turned", "translation": [5, 0, 1], "rotation": [0.6, 0, 0, 0.8], "children": [1, 3]},
      {"translation": [0, 3, 0], "scale": [1, 2, 1]},
      {"name": "stretched", "scale": [1, 3, 1], "children": [5]},
      {"name": "sheared", "translation": [2, 1, 0], "rotation": [0, 0, 0.6, 0.8]},
      {"name": "mirror", "scale": [-1, 1, 1], "children": [7]},
      {"name": "mirrored", "translation": [1, 2, 3], "rotation": [0, 0.6, 0, 0.8]},
      {"name": "by a matrix", "matrix": [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 1, 2, 3, 1]},
      {"name": "floor", "translation": [0, -5, 0]}]})");
  for (const std::size_t n : {0, 1, 3, 5, 7, 8}) json["nodes"][n]["extensions"] = rigid(Json::object());
  json["nodes"][9]["extensions"] = rigid(nullptr);
  return json;
}

/// A frame that turns and shifts every body in its own way; at time 0 they stand as in the scene.
SimulationFrame frame_at(const Scene& scene, double t) {
  SimulationFrame frame;
  frame.time = t;
  for (const std::uint32_t b : moving_bodies(scene)) {
    const double k = 1 + scene.bodies[b].node;
    BodyState state;
    state.pose.translation = scene.bodies[b].pose.translation + Vec3d{t * k, std::sin(t * k), -t};
    state.pose.rotation =
        Quatd::from_axis_angle(normalized(Vec3d{1, k, -1}), 0.7 * t * k) * scene.bodies[b].pose.rotation;
    state.linear = {k, 0.1, 0};
    state.angular = {0, 0, -0.0};
    state.asleep = b == 0;
    frame.bodies.push_back(state);
  }
  return frame;
}

void record_all(const fs::path& file, const Scene& scene, const fs::path& source, int frames = 7) {
  const auto recording = record(file, scene, source);
  for (int i = 0; i < frames; ++i) recording->add(frame_at(scene, i / 4.0));
  recording->close();
}

/// Whether two colliders fill the same space: points at the same places of a box of 1 x 2 x 3 under its pose.
void expect_same_place(const Posed& a, const Posed& b, const std::string& name) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p{corner & 1 ? 1.0 : -1.0, corner & 2 ? 2.0 : -2.0, corner & 4 ? 3.0 : -3.0};
    EXPECT_LE(length(transform(a, p) - transform(b, p)), 1e-5) << name;
  }
}

/// What is read back and played stands where the frames had it, whatever it hangs on.
TEST_F(RecordingTest, BodiesMoveAsTheFramesHaveThem) {
  const std::string source = put(family());
  const Scene scene = load_scene(source);
  ASSERT_EQ(moving_bodies(scene).size(), 6u);
  for (const char* ending : {".gltf", ".glb"}) {
    const fs::path file = folder / ("moved" + std::string(ending));
    record_all(file, scene, source);
    LoadOptions options;
    options.animations = true;
    const Scene moved = load_scene(file, options);
    ASSERT_EQ(moved.animations.size(), 1u);
    EXPECT_EQ(moved.animations[0].name, "simulation");
    EXPECT_EQ(moved.animations[0].duration, 1.5);
    ASSERT_EQ(moved.colliders.size(), scene.colliders.size());
    ColliderMotion motion(moved, moved.animations[0]);
    ASSERT_EQ(motion.colliders().size(), 6u);
    for (int i = 0; i < 7; ++i) {
      const SimulationFrame frame = frame_at(scene, i / 4.0);
      motion.go_to(frame.time);
      for (const MovedCollider& m : motion.colliders()) {
        const std::string& name = moved.colliders[m.index].name;
        EXPECT_FALSE(m.reshaped) << name;
        std::size_t k = 0, c = 0;
        const auto moving = moving_bodies(scene);
        while (scene.bodies[moving[k]].name != moved.bodies[moved.colliders[m.index].body].name) ++k;
        while (scene.colliders[c].name != name) ++c;
        const Collider& rest = scene.colliders[c];
        const Posed wanted = compose(frame.bodies[k].pose, relative(scene.bodies[rest.body].pose, rest.pose));
        expect_same_place(m.pose, wanted, name + " at " + std::to_string(frame.time));
      }
    }
  }
}

/// At rest, with the animation left alone, the scene is the one that it was.
TEST_F(RecordingTest, TheSceneStaysAsItWas) {
  const std::string source = put(family());
  const Scene scene = load_scene(source);
  const fs::path file = folder / "moved.gltf";
  record_all(file, scene, source);
  const Scene moved = load_scene(file);
  ASSERT_EQ(moved.colliders.size(), scene.colliders.size());
  for (const Collider& c : scene.colliders)
    for (const Collider& m : moved.colliders)
      if (m.name == c.name) {
        EXPECT_EQ(m.node, c.node);
        expect_same_place(m.pose, c.pose, c.name);
        const Aabbd a = bounds(c.shape, c.pose), b = bounds(m.shape, m.pose);
        EXPECT_LE(length(a.lower - b.lower) + length(a.upper - b.upper), 1e-5) << c.name;
      }
  const Json json = Json::parse(text_of(file));
  EXPECT_EQ(json["extras"], family()["extras"]);
  EXPECT_EQ(json["nodes"][9]["translation"], family()["nodes"][9]["translation"]);
  EXPECT_TRUE(json["buffers"][0]["uri"].get<std::string>().starts_with("data:"));
  // Where a node's own translation and rotation can say it, they do.
  std::vector<int> targets;
  for (const Json& channel : json["animations"][0]["channels"]) targets.push_back(channel["target"]["node"]);
  for (const int node : {0, 1, 3, 8}) EXPECT_EQ(std::count(targets.begin(), targets.end(), node), 2) << node;
}

TEST_F(RecordingTest, SameFramesSameBytes) {
  const std::string source = put(family());
  const Scene scene = load_scene(source);
  for (const char* name : {"a.gltf", "a.glb", "a.jsonl"}) {
    record_all(folder / name, scene, source);
    const std::string once = text_of(folder / name);
    record_all(folder / name, scene, source);
    EXPECT_EQ(text_of(folder / name), once);
    EXPECT_FALSE(once.empty());
  }
}

/// Without a glTF file to draw into, every body is a node of its own.
TEST_F(RecordingTest, ASceneOfSeveralFilesIsDrawnAlone) {
  const std::string source = put(family());
  Scene scene = load_scene(source);
  append(scene, load_scene(source));
  record_all(folder / "moved.glb", scene, {});
  LoadOptions options;
  options.animations = true;
  const Scene moved = load_scene(folder / "moved.glb", options);  // whose meshes collide, as it has no physics
  EXPECT_EQ(moved.colliders.size(), scene.colliders.size());
  ASSERT_EQ(moved.animations.size(), 1u);
  ColliderMotion motion(moved, moved.animations[0]);
  EXPECT_EQ(motion.colliders().size(), 12u);
  motion.go_to(1);
  const SimulationFrame frame = frame_at(scene, 1);
  const auto moving = moving_bodies(scene);
  for (std::size_t k = 0; k < moving.size(); ++k)
    for (const Collider& c : scene.colliders) {
      if (c.body != moving[k]) continue;
      const Posed wanted = compose(frame.bodies[k].pose, relative(scene.bodies[c.body].pose, c.pose));
      const Aabbd box = bounds(c.shape, wanted);
      const bool found = std::any_of(motion.colliders().begin(), motion.colliders().end(), [&](const MovedCollider& m) {
        const Aabbd b = bounds(m.shape, m.pose);
        return length(b.lower - box.lower) + length(b.upper - box.upper) < 1e-4;
      });
      EXPECT_TRUE(found) << c.name;
    }
}

TEST_F(RecordingTest, LinesHaveWhatTheContractSays) {
  const std::string source = put(family());
  const Scene scene = load_scene(source);
  SimulationFrame frame = frame_at(scene, 0.5);
  std::uint32_t floor = 0;
  while (scene.bodies[floor].name != "floor") ++floor;
  frame.contacts.push_back({moving_bodies(scene)[1], floor, 4, 16.3, 0.0001});
  frame.kinetic_energy = 2.5;
  frame.potential_energy = -0.1;
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    const auto recording = record(folder / "a.jsonl", scene, source, precision);
    recording->add(frame_at(scene, 0));
    recording->add(frame);
    recording->close();
    std::ifstream in(folder / "a.jsonl");
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(Json::parse(line)["time"], 0);
    EXPECT_EQ(Json::parse(line)["contacts"], Json::array());
    std::getline(in, line);
    const auto whole = nlohmann::ordered_json::parse(line);
    std::vector<std::string> keys;
    for (const auto& [key, value] : whole.items()) keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"time", "bodies", "contacts", "energy"}));
    EXPECT_EQ(whole["time"], 0.5);
    std::vector<std::string> names;
    for (const auto& body : whole["bodies"]) names.push_back(body["body"]);
    EXPECT_EQ(names, (std::vector<std::string>{"child", "parent", "node 3", "sheared", "mirrored", "by a matrix"}));
    keys.clear();
    for (const auto& [key, value] : whole["bodies"][0].items()) keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"body", "translation", "rotation", "linear", "angular", "asleep"}));
    EXPECT_EQ(whole["bodies"][1]["linear"].dump(), "[2,0.1,0]");
    EXPECT_EQ(whole["bodies"][1]["angular"].dump(), "[0,0,0]");
    EXPECT_EQ(whole["bodies"][1]["asleep"], scene.bodies[0].name == "parent");
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(whole["bodies"][i]["translation"][k].get<double>(), frame.bodies[i].pose.translation[k], 1e-6);
    EXPECT_EQ(whole["contacts"].dump(), R"([{"a":"parent","b":"floor","points":4,"impulse":16.3,"depth":0.0001}])");
    EXPECT_EQ(whole["energy"].dump(), R"({"kinetic":2.5,"potential":-0.1})");
    EXPECT_FALSE(std::getline(in, line));
  }
}

TEST_F(RecordingTest, WhatCannotBeWrittenIsSaid) {
  const std::string source = put(family());
  const Scene scene = load_scene(source);
  const auto refusal = [&](const fs::path& file) -> std::string {
    try {
      record_all(file, scene, source, 2000);
    } catch (const InvalidValue& e) {
      return e.what();
    }
    return "written";
  };
  EXPECT_EQ(refusal("moved.avi"), "moved.avi: expected a file name that ends in .gltf, .glb or .jsonl, got \".avi\"");
  for (const char* ending : {".gltf", ".glb", ".jsonl"}) {
    const fs::path missing = folder / "none" / ("a" + std::string(ending));
    EXPECT_EQ(refusal(missing), missing.string() + ": cannot be written: no such folder");
    if (!fs::exists("/dev/full")) continue;
    const fs::path full = folder / ("full" + std::string(ending));
    fs::create_symlink("/dev/full", full);
    EXPECT_EQ(refusal(full), full.string() + ": cannot be written: no space left on device");
  }
  const auto recording = record(folder / "a.glb", scene, source);
  EXPECT_THROW(recording->add({}), InvalidValue);
}

}  // namespace
}  // namespace graze::io::recording_test
