// Scenes in parts: tiles where their nodes stand, and what is no tile.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <numbers>

#include <nlohmann/json.hpp>

#include "graze/error.hpp"
#include "graze/io/file.hpp"
#include "graze/io/tiles.hpp"

namespace graze::io {
namespace {

using TileJson = nlohmann::json;

/// A ball that moves, of a system of its own.
TileJson ball_tile(const std::string& system) {
  return {{"asset", {{"version", "2.0"}}},
          {"scenes", {{{"nodes", {0}}}}},
          {"nodes",
           {{{"name", "ball"},
             {"translation", {1, 0, 0}},
             {"extensions",
              {{"KHR_physics_rigid_bodies",
                {{"motion", {{"mass", 1}, {"linearVelocity", {0, 0, 1}}}},
                 {"collider", {{"geometry", {{"shape", 0}}}, {"collisionFilter", 0}}}}}}}}}},
          {"extensions",
           {{"KHR_implicit_shapes", {{"shapes", {{{"type", "sphere"}, {"sphere", {{"radius", 0.5}}}}}}}},
            {"KHR_physics_rigid_bodies", {{"collisionFilters", {{{"collisionSystems", {system}}}}}}}}}};
}

/// Two tiles, the second turned by a right angle about Y.
class Tiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_ / "tiles");
    write_file(folder_ / "tiles/a.gltf", ball_tile("a").dump());
    write_file(folder_ / "tiles/b.gltf", ball_tile("b").dump());
    const double half = std::numbers::sqrt2 / 2;
    whole_ = {{"asset", {{"version", "2.0"}}},
              {"scenes", {{{"nodes", {0, 1}}}}},
              {"nodes",
               {{{"extras", {{"grazeTile", "tiles/a.gltf"}}}},
                {{"translation", {10, 0, 0}},
                 {"rotation", {0, half, 0, half}},
                 {"extras", {{"grazeTile", "tiles/b.gltf"}}}}}}};
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write() {
    write_file(folder_ / "whole.gltf", whole_.dump());
    return folder_ / "whole.gltf";
  }
  std::string fault() {
    try {
      load_scene(write());
    } catch (const InvalidValue& e) {
      return e.what();
    }
    return "";
  }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ("graze_tiles_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
                                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
  TileJson whole_;
};

TEST_F(Tiles, StandWhereTheirNodesDo) {
  const Scene scene = load_scene(write());
  EXPECT_EQ(scene.source, "whole.gltf");
  ASSERT_EQ(scene.colliders.size(), 2u);
  EXPECT_EQ(scene.colliders[0].pose.translation, (Vec3d{1, 0, 0}));
  EXPECT_NEAR(scene.colliders[1].pose.translation.x, 10, 1e-15);
  EXPECT_NEAR(scene.colliders[1].pose.translation.z, -1, 1e-15);
  ASSERT_TRUE(scene.bodies[1].motion);
  EXPECT_NEAR(scene.bodies[1].motion->linear_velocity.x, 1, 1e-15);
  EXPECT_EQ(scene.collision_systems, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(scene.colliders[1].filter.category, 2u);
}

TEST_F(Tiles, ReadPartByPartAreTheWhole) {
  const std::vector<ScenePart> parts = scene_parts(write());
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_TRUE(load_part(parts[0]).colliders.empty());
  const Scene whole = load_scene(write());
  EXPECT_EQ(load_part(parts[2]).colliders.at(0).pose, whole.colliders[1].pose);
}

TEST_F(Tiles, WhatIsNoTileIsRefused) {
  const auto refused = [&](const std::function<void()>& change, const std::string& words) {
    const TileJson kept = whole_;
    change();
    EXPECT_NE(fault().find(words), std::string::npos) << fault();
    whole_ = kept;
  };
  const auto node = [&]() -> TileJson& { return whole_["nodes"][1]; };
  refused([&] { node()["scale"] = {1, 1, 2}; }, "nodes[1]: expected a tile without scale");
  refused([&] { node()["children"] = {0}; }, "nodes[1]: expected a tile without children");
  refused([&] { node()["rotation"] = {0, 0, 0, 3}; }, "nodes[1].rotation: expected a unit quaternion");
  refused([&] { node()["extras"]["grazeTile"] = 3; }, "nodes[1].extras.grazeTile");
  refused([&] { node()["extras"]["grazeTile"] = "../whole.gltf"; }, "a file below the folder of the scene");
  refused([&] { node()["extras"]["grazeTile"] = "/etc/passwd"; }, "a file below the folder of the scene");
  refused([&] { node()["extras"]["grazeTile"] = "whole.gltf"; }, "a tile, which references no tiles");
  refused([&] { node()["extras"]["grazeTile"] = "tiles/c.gltf"; }, "c.gltf");
  refused(
      [&] {
        whole_["nodes"].push_back({{"children", {0}}});
      },
      "nodes[2].children[0]: expected a node that is no tile");
  EXPECT_EQ(fault(), "");
}

}  // namespace
}  // namespace graze::io
