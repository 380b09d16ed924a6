// docs/capture.md: the file that a captured simulation leaves is one that plays again.
#include "capture_includes.inc"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "graze/capture.hpp"
#include "graze/shape/box.hpp"

TEST(Pages, ACapturedSimulationLeavesAFileThatPlaysAgain) {
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(testing::TempDir());
  {
    const graze::Body<float> body{graze::Box<float>({1, 1, 1}), {}};
    const float dt = 1.0f / 60;
#include "capture_1.inc"
  }
  std::ifstream written("game.capture", std::ios::binary);
  const graze::ReplayReport report = graze::replay(written, "game.capture");
  written.close();
  std::filesystem::remove("game.capture");
  std::filesystem::current_path(before);
  EXPECT_FALSE(report.difference);
  EXPECT_EQ(report.frames, 1u);
}
