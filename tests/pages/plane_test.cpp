// docs/plane.md: its first lines print how deep two boxes lie in each other.
#include "plane_includes.inc"

#include <gtest/gtest.h>

#include <cstdio>

TEST(Pages, ThePlanesFirstLinesPrintADepth) {
  testing::internal::CaptureStdout();
  {
#include "plane_1.inc"
  } EXPECT_EQ(testing::internal::GetCapturedStdout(), "0.10716 deep\n0.601024 deep\n");
}
