// docs/capture.md: the file that a captured simulation leaves is one that plays again, and a state goes on from bytes.
#include "capture_includes.inc"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "graze/capture.hpp"
#include "graze/shape/box.hpp"
#include "graze/state_bytes.hpp"

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

TEST(Pages, AStateGoesOnFromItsBytes) {
  graze::Simulation<double> simulation, again;
  for (graze::Simulation<double>* s : {&simulation, &again}) s->add({graze::Box<double>({1, 1, 1}), {}});
  simulation.step(1.0 / 60);
#include "capture_2.inc"
  EXPECT_EQ(again.state_hash(), simulation.state_hash());
}
