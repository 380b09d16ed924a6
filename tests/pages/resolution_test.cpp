// docs/resolution.md: its crate comes to rest on the floor.
#include "resolution_includes.inc"

#include <gtest/gtest.h>

#include "graze/graze.hpp"

TEST(Pages, ACrateFallsToTheFloor) {
#include "resolution_1.inc"
  EXPECT_NEAR(simulation.poses()[crate.index].translation.y, 0.5, 0.005);
}
