// What an animation must be to be read: every fault of a file is refused and named.
#include "io/gltf_animation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <functional>

#include "animated_file.hpp"
#include "graze/io/collide_frames.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

/// The ball's translation over two keys: accessors 0 (times) and 1 (values).
AnimatedFile moving(const std::vector<float>& times = {0, 2}, const std::vector<float>& values = {-3, 0, 0, 3, 0, 0},
                    const char* interpolation = "LINEAR", const char* path = "translation") {
  AnimatedFile file;
  file.move(1, path, times, values, interpolation);
  return file;
}

std::string with(const std::function<void(Json& file, Json& animation)>& change) {
  AnimatedFile file = moving();
  change(file.json, file.json["animations"][0]);
  return file.refusal();
}

const std::string here = "test.gltf: animations[0].";

TEST(GltfAnimation, FaultsOfChannelsAreNamed) {
  EXPECT_EQ(with([](Json&, Json&) {}), "loaded");
  EXPECT_EQ(with([](Json&, Json& a) { a["channels"][0]["sampler"] = 1; }),
            here + "channels[0].sampler: expected an index below 1, got 1");
  EXPECT_EQ(with([](Json&, Json& a) { a["channels"][0]["sampler"] = -1; }),
            here + "channels[0].sampler: expected a whole number >= 0, got -1");
  EXPECT_EQ(with([](Json&, Json& a) { a["channels"][0]["target"]["node"] = 2; }),
            here + "channels[0].target.node: expected an index below 2, got 2");
  EXPECT_EQ(with([](Json&, Json& a) { a["channels"][0]["target"].erase("path"); }),
            here + "channels[0].target.path: expected a value, got nothing");
  EXPECT_EQ(with([](Json&, Json& a) { a["channels"][0].erase("target"); }),
            here + "channels[0].target: expected a value, got nothing");
  EXPECT_EQ(with([](Json&, Json& a) { a["channels"].push_back(a["channels"][0]); }),
            here + "channels[1].target.path: expected a property of its node that no other channel moves, got "
                   "\"translation\"");
  EXPECT_EQ(with([](Json& f, Json&) { f["nodes"][1]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }),
            here + "channels[0].target.node: expected a node without a matrix, which no channel can move, got 1");
  EXPECT_EQ(with([](Json&, Json& a) { a.erase("channels"); }), here + "channels: expected a value, got nothing");
  EXPECT_EQ(with([](Json&, Json& a) { a["channels"] = 3; }), here + "channels: expected an array, got 3");
}

TEST(GltfAnimation, FaultsOfSamplersAreNamed) {
  EXPECT_EQ(with([](Json&, Json& a) { a["samplers"][0]["input"] = 9; }),
            here + "samplers[0].input: expected an index below 2, got 9");
  EXPECT_EQ(with([](Json&, Json& a) { a["samplers"][0].erase("output"); }),
            here + "samplers[0].output: expected a value, got nothing");
  EXPECT_EQ(with([](Json&, Json& a) { a["samplers"][0]["interpolation"] = "linear"; }),
            here + "samplers[0].interpolation: expected one of STEP, LINEAR, CUBICSPLINE, got \"linear\"");
  EXPECT_EQ(with([](Json&, Json& a) { a["samplers"][0]["output"] = 0; }),
            "test.gltf: accessors[0].type: expected \"VEC3\", got another");
  EXPECT_EQ(with([](Json& f, Json&) { f["accessors"][1]["componentType"] = 5123; }),
            "test.gltf: accessors[1].componentType: expected floats, got 5123");
  EXPECT_EQ(with([](Json& f, Json&) { f["accessors"][0]["count"] = 1; }),
            here + "samplers[0].output: expected 1 values, one for each of 1 times, got 2");
  EXPECT_EQ(with([](Json& f, Json&) { f["accessors"][0]["count"] = 0; }),
            here + "samplers[0].input: expected at least 1 keyframes, got 0");
  EXPECT_EQ(with([](Json&, Json& a) { a["samplers"][0]["interpolation"] = "CUBICSPLINE"; }),
            here + "samplers[0].output: expected 6 values, three for each of 2 times, got 2");
  EXPECT_EQ(moving({1}, {0, 0, 0, 0, 0, 0, 0, 0, 0}, "CUBICSPLINE").refusal(),
            here + "samplers[0].input: expected at least 2 keyframes, got 1");
  // A claim of gigabytes, and one that no byte of the file pays for.
  EXPECT_NE(with([](Json& f, Json&) { f["accessors"][1]["count"] = 4000000000u; }).find("accessors[1].count"),
            std::string::npos);
  EXPECT_NE(with([](Json& f, Json&) {
              f["accessors"][0].erase("bufferView");
              f["accessors"][0]["count"] = 2000000;
              f["accessors"][0]["sparse"] = {{"count", 1},
                                             {"indices", {{"bufferView", 0}, {"componentType", 5125}}},
                                             {"values", {{"bufferView", 1}}}};
            }).find("accessors[0].count: expected at most 1048576 without a buffer view"),
            std::string::npos);
}

TEST(GltfAnimation, FaultsOfNumbersAreNamed) {
  EXPECT_EQ(moving({-1, 2}).refusal(), "test.gltf: accessors[0][0]: expected a time of at least 0, got -1");
  EXPECT_EQ(moving({1, 1}).refusal(),
            "test.gltf: accessors[0][1]: expected a time later than the one before, 1, got 1");
  EXPECT_EQ(moving({2, 1}).refusal(),
            "test.gltf: accessors[0][1]: expected a time later than the one before, 2, got 1");
  EXPECT_EQ(moving({0, NAN}).refusal(), "test.gltf: accessors[0][1]: expected finite numbers, got nan");
  EXPECT_EQ(moving({0, INFINITY}).refusal(), "test.gltf: accessors[0][1]: expected finite numbers, got inf");
  EXPECT_EQ(moving({0, 2}, {-3, 0, 0, 3, NAN, 0}).refusal(),
            "test.gltf: accessors[1][1]: expected finite numbers, got nan");
  const std::string zero = "test.gltf: accessors[1][1]: expected a quaternion that is not zero, got [0,0,0,0]";
  EXPECT_EQ(moving({0, 2}, {0, 0, 0, 1, 0, 0, 0, 0}, "LINEAR", "rotation").refusal(), zero);
  // Of a spline the tangents may be zero, the keys may not.
  EXPECT_EQ(moving({0, 1}, {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, "CUBICSPLINE",
                   "rotation")
                .refusal(),
            "loaded");
  EXPECT_EQ(moving({0, 1}, std::vector<float>(24, 0), "CUBICSPLINE", "rotation").refusal(), zero);
}

// A hundred accessors over the same million bytes: more than a file may ask for.
TEST(GltfAnimation, OverlappingAccessorsAreBounded) {
  std::vector<float> times(1 << 20);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<float>(i);
  AnimatedFile file;
  file.move(1, "translation", times, {0, 0, 0});
  Json& animation = file.json["animations"][0];
  file.json["accessors"][1] = file.json["accessors"][0];
  file.json["accessors"][1]["type"] = "VEC3";
  file.json["accessors"][1]["count"] = times.size() / 3;
  file.json["accessors"][0]["count"] = times.size() / 3;
  EXPECT_EQ(file.refusal(), "loaded");
  for (std::size_t i = 0; i < 70; ++i) {
    const std::size_t node = file.json["nodes"].size();
    file.json["nodes"].push_back(Json::object());
    file.json["accessors"].push_back(file.json["accessors"][1]);
    animation["samplers"].push_back({{"input", 0}, {"output", file.json["accessors"].size() - 1}});
    animation["channels"].push_back({{"sampler", i + 1}, {"target", {{"node", node}, {"path", "scale"}}}});
  }
  EXPECT_NE(file.refusal().find("at most 67108864 numbers in all keyframes of a file"), std::string::npos);
}

// Bytes stand for fractions, and the least for -1 as well (section 3.6.2.2). The ball hangs on a node that turns.
TEST(GltfAnimation, RotationsOfNormalizedIntegers) {
  const auto packed = [](std::int8_t x, std::int8_t y, std::int8_t z, std::int8_t w) {
    return std::bit_cast<float>(std::array<std::int8_t, 4>{x, y, z, w});
  };
  // No turn, a quarter about z, a half about x.
  AnimatedFile file =
      moving({0, 1, 2}, {packed(0, 0, 0, 127), packed(0, 0, 90, 90), packed(-128, 0, 0, 0), 0}, "STEP", "rotation");
  Json& accessor = file.json["accessors"][1];
  accessor["componentType"] = 5120;
  accessor["count"] = 3;
  EXPECT_EQ(file.refusal(),
            "test.gltf: accessors[1].componentType: expected floats, or normalized bytes or shorts, for "
            "rotations, got 5120");
  accessor["normalized"] = true;
  const Scene scene = file.load();
  const Keyframes& keys = scene.animations[0].tracks->channels[0].keys;
  EXPECT_EQ(keys.rotation(0), (Quatd{0, 0, 0, 1}));
  EXPECT_EQ(keys.rotation(2), (Quatd{-1, 0, 0, 0}));
  EXPECT_LE(length(rotate(keys.rotation(1), Vec3d{1, 0, 0}) - Vec3d{0, 1, 0}), 1e-12);
  EXPECT_EQ((*keys.values)[6], 90 / 127.0F);
}

TEST(GltfAnimation, WhatIsNotPlayedIsSaid) {
  AnimatedFile file = moving();
  Json& animation = file.json["animations"][0];
  animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}});
  animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", "pointer"}}}});
  animation["channels"].push_back({{"sampler", 0}, {"target", {{"path", "translation"}}}});  // to be ignored
  const Scene scene = file.load();
  ASSERT_EQ(scene.notices.size(), 2u);
  EXPECT_EQ(scene.notices[0], "1 channels of weights are skipped: meshes keep their points");
  EXPECT_EQ(scene.notices[1], "1 channels of unknown paths are skipped");
  EXPECT_EQ(animated_colliders(scene, 0), std::vector<std::uint32_t>{1});
  EXPECT_TRUE(load_gltf(file.text(), "test.gltf").animations.empty());  // not asked for
}

// Maps multiply from node to node, and so a time may come at which a collider is out of bounds.
TEST(GltfAnimation, MagnitudesAreBoundedAtEveryTime) {
  AnimatedFile file = moving({0, 1}, {0, 0, 0, 1e38F, 0, 0});
  file.json["nodes"].push_back({{"children", {1}}, {"scale", {1e20, 1e20, 1e20}}});
  file.json["nodes"][1]["scale"] = {1e-20, 1e-20, 1e-20};
  file.json["scenes"][0]["nodes"] = {0, 2};
  const auto played = [&](const Scene& scene) -> std::string {
    try {
      collide_frames(scene, {}, [](const Frame&) {});
    } catch (const InvalidValue& e) {
      return e.what();
    }
    return "played";
  };
  EXPECT_NE(played(file.load())
                .find("nodes[1] (in the world, at 0.03333333333333333 s).translation[0]: expected a "
                      "magnitude of at most 1e48"),
            std::string::npos)
      << played(file.load());
  FrameOptions single;
  single.precision = Precision::single_precision;
  EXPECT_THROW(collide_frames(moving({0, 1}, {0, 0, 0, 1e38F, 0, 0}).load(), single, [](const Frame&) {}),
               InvalidValue);
}

}  // namespace
}  // namespace graze::io
