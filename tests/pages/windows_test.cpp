// docs/windows.md: its first program prints what the page shows.
#include "windows_includes.inc"

#include <gtest/gtest.h>

namespace {
#define main first_program_for_windows
#include "windows_1.inc"
#undef main
}  // namespace

TEST(Pages, TheFirstProgramForWindowsPrintsWhatIsShown) {
  const std::string shown =
#include "windows_1_shown.inc"
      ;
  testing::internal::CaptureStdout();
  EXPECT_EQ(first_program_for_windows(), 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), shown);
}
