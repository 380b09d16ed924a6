// Captures of C++ replayed through the C interface.
#include <gtest/gtest.h>

#include <sstream>

#include "graze/graze.h"
#include "graze/plane/capture.hpp"

namespace graze::testing {
namespace {

/// What C's function was told.
struct Seen {
  std::size_t frames = 0, bodies = 0, of_plane = 0;
};
void count(void* user, std::size_t frame, const GrazeWorldd* world, const GrazePlaneWorldd* plane_world) {
  auto& seen = *static_cast<Seen*>(user);
  EXPECT_EQ(frame, ++seen.frames);
  EXPECT_NE(world == nullptr, plane_world == nullptr);
  std::size_t pairs = 0;
  EXPECT_EQ(world ? graze_world_counts_d(world, &seen.bodies, &pairs)
                  : graze_plane_world_counts_d(plane_world, &seen.bodies, &pairs),
            GRAZE_OK);
  seen.of_plane += plane_world != nullptr;
}

std::string captured_fall() {
  std::ostringstream out;
  CapturedSimulation<double> simulation(&out);
  simulation.add({Box<double>({1, 1, 1}), {{0, 2, 0}, {}}});
  for (int i = 0; i < 5; ++i) simulation.step(0.01);
  return out.str();
}

TEST(CReplay, HandsOutTheWorldAfterEachFrame) {
  const std::string file = captured_fall();
  Seen seen;
  GrazeReplayReport report;
  ASSERT_EQ(graze_replay_d(file.data(), file.size(), &count, &seen, &report), GRAZE_OK);
  EXPECT_TRUE(report.simulation && !report.plane && !report.cut && !report.differs);
  EXPECT_EQ(report.frames, 5u);
  EXPECT_EQ(report.calls, 7u);
  EXPECT_EQ(seen.frames, 5u);
  EXPECT_EQ(seen.bodies, 1u);
  ASSERT_EQ(graze_replay_d(file.data(), file.size(), nullptr, nullptr, &report), GRAZE_OK);
  EXPECT_EQ(report.frames, 5u);
}

TEST(CReplay, OfThePlaneToo) {
  std::ostringstream out;
  plane::CapturedWorld<double> world(&out);
  world.add({plane::Circle<double>(1)});
  world.add({plane::Circle<double>(1), {{1, 0}, {}}});
  world.update();
  Seen seen;
  GrazeReplayReport report;
  ASSERT_EQ(graze_replay_d(out.str().data(), out.str().size(), &count, &seen, &report), GRAZE_OK);
  EXPECT_TRUE(report.plane && !report.simulation);
  EXPECT_EQ(seen.of_plane, 1u);
  EXPECT_EQ(seen.bodies, 2u);
}

TEST(CReplay, AHeadTellsWhatACaptureIsOf) {
  const std::string file = captured_fall();
  std::ostringstream flat;
  plane::CapturedWorld<float> world(&flat);
  GrazeCaptureHead head;
  ASSERT_EQ(graze_capture_head(file.data(), file.size(), &head), GRAZE_OK);
  EXPECT_TRUE(head.simulation && !head.plane && !head.single);
  ASSERT_EQ(graze_capture_head(flat.str().data(), flat.str().size(), &head), GRAZE_OK);
  EXPECT_TRUE(!head.simulation && head.plane && head.single);
  EXPECT_EQ(graze_capture_head("graze capture", 13, &head), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "bytes: expected a capture, got something else");
  EXPECT_EQ(graze_capture_head(file.data(), file.size(), nullptr), GRAZE_INVALID_VALUE);
}

TEST(CReplay, RefusesWhatIsNoCaptureOfItsScalar) {
  const std::string file = captured_fall();
  GrazeReplayReport report;
  EXPECT_EQ(graze_replay_f(file.data(), file.size(), nullptr, nullptr, &report), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "bytes: expected a capture of the function's scalar, got one in double");
  EXPECT_EQ(graze_replay_d("hello", 5, nullptr, nullptr, &report), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "bytes: expected a capture, got something else");
  EXPECT_EQ(graze_replay_d(nullptr, 5, nullptr, nullptr, &report), GRAZE_INVALID_VALUE);
  EXPECT_EQ(graze_replay_d(file.data(), file.size(), nullptr, nullptr, nullptr), GRAZE_INVALID_VALUE);
}

}  // namespace
}  // namespace graze::testing
