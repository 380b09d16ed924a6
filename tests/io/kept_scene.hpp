// Scenes that tests make, kept as files for who wants to see them: examples/scenes/conformance.
#pragma once

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "physics_scene.hpp"

namespace graze::io {

/// Whether two JSON texts say the same, numbers to 1e-12: those of sines differ from one mathematical library to the
/// next.
inline bool same_json(const std::string& one, const std::string& other) {
  const auto a = nlohmann::json::parse(one).flatten(), b = nlohmann::json::parse(other).flatten();
  if (a.size() != b.size()) return false;
  for (const auto& [path, value] : a.items()) {
    if (!b.contains(path)) return false;
    const auto& there = b[path];
    const bool numbers = value.is_number() && there.is_number();
    if (numbers ? std::abs(value.get<double>() - there.get<double>()) > 1e-12 : value != there) return false;
  }
  return true;
}

/// The scene, which is that of the kept file; `says` is what is to be seen in it. With GRAZE_KEEP_SCENES=folder in the
/// environment it is written there.
inline const PhysicsScene& kept(const PhysicsScene& scene, const std::string& name, const std::string& says) {
  auto json = nlohmann::json::parse(scene.text());
  json["asset"]["extras"] = {{"says", says}};
  const std::string text = json.dump(1) + "\n", file = name + ".gltf";
  if (const char* folder = std::getenv("GRAZE_KEEP_SCENES")) {
    std::ofstream(std::string(folder) + "/" + file, std::ios::binary) << text;
    return scene;
  }
  std::ostringstream there;
  there << std::ifstream(GRAZE_SOURCE_DIR "/examples/scenes/conformance/" + file, std::ios::binary).rdbuf();
  EXPECT_TRUE(!there.str().empty() && same_json(text, there.str()))
      << file << " is another scene: write them anew with GRAZE_KEEP_SCENES=examples/scenes/conformance";
  return scene;
}

}  // namespace graze::io
