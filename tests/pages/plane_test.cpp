// docs/plane.md: its first program prints how deep two boxes lie in each other.
#include "plane_includes.inc"

#include <gtest/gtest.h>

namespace {
#define main first_program_of_the_plane
#include "plane_1.inc"
#undef main
}  // namespace

TEST(Pages, ThePlanesFirstProgramPrintsADepth) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(first_program_of_the_plane(), 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "0.10716 deep\n0.601024 deep\n");
}
