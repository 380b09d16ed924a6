// Captures of C, and captures of C++ replayed through the C interface.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

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
  const char* name = nullptr;
  EXPECT_EQ(world ? graze_world_name_d(world, {0, 0}, &name) : graze_plane_world_name_d(plane_world, {0, 0}, &name),
            GRAZE_OK);
  EXPECT_STREQ(name, world ? "falling" : "");
}

std::string captured_fall() {
  std::ostringstream out;
  CapturedSimulation<double> simulation(&out);
  simulation.set_name(simulation.add({Box<double>({1, 1, 1}), {{0, 2, 0}, {}}}), "falling");
  for (int i = 0; i < 5; ++i) simulation.step(0.01);
  return out.str();
}

TEST(CReplay, HandsOutTheWorldAfterEachFrame) {
  const std::string file = captured_fall();
  Seen seen;
  GrazeReplayReport report;
  ASSERT_EQ(graze_replay_d(file.data(), file.size(), &count, &seen, &report, nullptr), GRAZE_OK);
  EXPECT_TRUE(report.simulation && !report.plane && !report.cut && !report.differs);
  EXPECT_EQ(report.frames, 5u);
  EXPECT_EQ(report.calls, 8u);
  EXPECT_EQ(seen.frames, 5u);
  EXPECT_EQ(seen.bodies, 1u);
  ASSERT_EQ(graze_replay_d(file.data(), file.size(), nullptr, nullptr, &report, nullptr), GRAZE_OK);
  EXPECT_EQ(report.frames, 5u);
}

/// The last frame of a replayed simulation, as far as it is asked for.
struct SeenSimulation {
  bool there = false, asleep = true;
  double energy = 0;
  GrazeStatus saved = GRAZE_INVALID_VALUE, changed = GRAZE_OK, renamed = GRAZE_OK;
};

void ask(void* user, size_t, const GrazeWorldd* world, const GrazePlaneWorldd* plane_world) {
  SeenSimulation& seen = *static_cast<SeenSimulation*>(user);
  const GrazeSimulationd* simulation = nullptr;
  if (plane_world != nullptr || graze_world_simulation_d(world, &simulation) != GRAZE_OK || simulation == nullptr)
    return;
  GrazeStepReportd report;
  GrazeStated* state = nullptr;
  seen.there = graze_simulation_asleep_d(simulation, {0, 0}, &seen.asleep) == GRAZE_OK;
  if (graze_simulation_report_d(simulation, &report) == GRAZE_OK) seen.energy = report.kinetic_energy;
  seen.saved = graze_simulation_save_d(simulation, &state);
  graze_state_destroy_d(state);
  // Nobody who keeps to `const` comes here; other languages have none.
  auto* changeable = const_cast<GrazeSimulationd*>(simulation);
  seen.changed = graze_simulation_step_d(changeable, 0.01);
  seen.renamed = graze_simulation_set_name_d(changeable, {0, 0}, "other");
}

TEST(CReplay, AWorldLeadsToItsSimulationWhichIsNotChanged) {
  const std::string file = captured_fall();
  SeenSimulation seen;
  GrazeReplayReport report;
  ASSERT_EQ(graze_replay_d(file.data(), file.size(), &ask, &seen, &report, nullptr), GRAZE_OK);
  EXPECT_FALSE(report.differs);
  EXPECT_TRUE(seen.there && !seen.asleep);
  EXPECT_GT(seen.energy, 0);
  EXPECT_EQ(seen.saved, GRAZE_OK);
  for (const GrazeStatus status : {seen.changed, seen.renamed}) EXPECT_EQ(status, GRAZE_INVALID_VALUE);
  EXPECT_NE(std::string(graze_last_error()).find("one that is played again"), std::string::npos);
}

TEST(CReplay, AWorldOfItsOwnHasNoSimulation) {
  GrazeWorldd* world = nullptr;
  GrazeSimulationd* made = nullptr;
  const GrazeSimulationd* simulation = nullptr;
  const GrazeWorldd* inner = nullptr;
  ASSERT_EQ(graze_world_create_d(nullptr, nullptr, &world), GRAZE_OK);
  ASSERT_EQ(graze_simulation_create_d(nullptr, nullptr, &made), GRAZE_OK);
  simulation = made;
  EXPECT_EQ(graze_world_simulation_d(world, &simulation), GRAZE_OK);
  EXPECT_EQ(simulation, nullptr);
  ASSERT_EQ(graze_simulation_world_d(made, &inner), GRAZE_OK);
  EXPECT_EQ(graze_world_simulation_d(inner, &simulation), GRAZE_OK);
  EXPECT_EQ(simulation, made);
  EXPECT_EQ(graze_world_simulation_d(nullptr, &simulation), GRAZE_INVALID_VALUE);
  graze_simulation_destroy_d(made);
  graze_world_destroy_d(world);
}

TEST(CReplay, OfThePlaneToo) {
  std::ostringstream out;
  plane::CapturedWorld<double> world(&out);
  world.add({plane::Circle<double>(1)});
  world.add({plane::Circle<double>(1), {{1, 0}, {}}});
  world.update();
  Seen seen;
  GrazeReplayReport report;
  ASSERT_EQ(graze_replay_d(out.str().data(), out.str().size(), &count, &seen, &report, nullptr), GRAZE_OK);
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

/// A program of C's that keeps what it is handed.
bool keep(void* user, const void* bytes, std::size_t size) {
  static_cast<std::string*>(user)->append(static_cast<const char*>(bytes), size);
  return true;
}
bool refuse(void*, const void*, std::size_t) { return false; }

TEST(CCapture, ASimulationWithItsStatesRunsAgainToTheSameBits) {
  GrazeShaped* ball = nullptr;
  ASSERT_EQ(graze_shape_sphere_d(0.5, {0, 0, 0}, &ball), GRAZE_OK);
  std::string file;
  GrazeSimulationd* simulation = nullptr;
  ASSERT_EQ(graze_simulation_create_captured_d(nullptr, nullptr, &keep, &file, &simulation), GRAZE_OK);
  GrazeBodyd body = graze_body_default_d(ball);
  GrazeBodyId id;
  ASSERT_EQ(graze_simulation_add_d(simulation, &body, nullptr, nullptr, &id), GRAZE_OK);
  GrazeStated *first = nullptr, *second = nullptr;
  ASSERT_EQ(graze_simulation_step_d(simulation, 0.1), GRAZE_OK);
  ASSERT_EQ(graze_simulation_save_d(simulation, &first), GRAZE_OK);
  GrazePosed kept, again;
  ASSERT_EQ(graze_simulation_pose_d(simulation, id, &kept), GRAZE_OK);
  ASSERT_EQ(graze_simulation_step_d(simulation, 0.1), GRAZE_OK);
  ASSERT_EQ(graze_simulation_save_d(simulation, &second), GRAZE_OK);
  ASSERT_EQ(graze_simulation_restore_d(simulation, first), GRAZE_OK);
  ASSERT_EQ(graze_simulation_pose_d(simulation, id, &again), GRAZE_OK);
  EXPECT_EQ(again.translation.y, kept.translation.y);
  ASSERT_EQ(graze_simulation_step_d(simulation, 0.2), GRAZE_OK);
  // A state that is gone leaves its place to another one.
  std::vector<GrazeStated*> states;
  for (int i = 0; i < 14; ++i) ASSERT_EQ(graze_simulation_save_d(simulation, &states.emplace_back()), GRAZE_OK);
  GrazeStated* more = nullptr;
  EXPECT_EQ(graze_simulation_save_d(simulation, &more), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(),
               "simulation: expected at most 16 states of a captured simulation at a time, got one more");
  graze_state_destroy_d(first);
  ASSERT_EQ(graze_simulation_save_d(simulation, &more), GRAZE_OK);
  states.push_back(more);
  // Of this simulation alone.
  GrazeSimulationd* plain = nullptr;
  ASSERT_EQ(graze_simulation_create_d(nullptr, nullptr, &plain), GRAZE_OK);
  EXPECT_EQ(graze_simulation_restore_d(plain, second), GRAZE_INVALID_VALUE);
  EXPECT_EQ(graze_simulation_set_name_d(plain, {0, 0}, "nobody"), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "id: expected a body of the world, got 0 of generation 0, which is not there");
  graze_simulation_destroy_d(plain);
  graze_simulation_destroy_d(simulation);
  for (GrazeStated* state : states) graze_state_destroy_d(state);
  graze_state_destroy_d(second);
  graze_shape_release_d(ball);

  GrazeReplayReport report;
  ASSERT_EQ(graze_replay_d(file.data(), file.size(), nullptr, nullptr, &report, nullptr), GRAZE_OK);
  EXPECT_TRUE(report.simulation && !report.differs && !report.cut);
  EXPECT_EQ(report.calls,
            2u + 3u + 3u + 15u);  // a shape and a body, steps, two saves and a restore, and the saves after
}

TEST(CCapture, AWorldRunsAgainAndRefusesWhatNoFileHolds) {
  std::string file;
  GrazePlaneShapef* disc = nullptr;
  ASSERT_EQ(graze_plane_shape_circle_f(1, &disc), GRAZE_OK);
  GrazePlaneWorldf* world = nullptr;
  ASSERT_EQ(graze_plane_world_create_captured_f(nullptr, nullptr, &keep, &file, &world), GRAZE_OK);
  GrazePlaneBodyf body = graze_plane_body_default_f(disc);
  GrazeBodyId ids[2];
  for (GrazeBodyId& id : ids) ASSERT_EQ(graze_plane_world_add_f(world, &body, &id), GRAZE_OK);
  ASSERT_EQ(graze_plane_world_update_f(world, 0), GRAZE_OK);
  EXPECT_EQ(graze_plane_world_reduce_f(world, 1), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "world: expected a world of its own that is not captured, got a captured one");
  EXPECT_EQ(graze_plane_world_set_name_f(world, ids[1], nullptr), GRAZE_INVALID_VALUE);
  ASSERT_EQ(graze_plane_world_set_name_f(world, ids[1], "disc"), GRAZE_OK);
  const GrazePose2f poses[2] = {{{0, 0}, {1, 0}}, {{1, 0}, {1, 0}}};
  ASSERT_EQ(graze_plane_world_move_batch_f(world, ids, 0, poses, 0, nullptr, 0, 2), GRAZE_OK);
  ASSERT_EQ(graze_plane_world_update_f(world, 0), GRAZE_OK);
  graze_plane_world_destroy_f(world);
  graze_plane_shape_release_f(disc);

  GrazeReplayReport report;
  const auto name_of_last = [](void* user, size_t, const GrazeWorldf*, const GrazePlaneWorldf* played) {
    const char* name = nullptr;
    ASSERT_EQ(graze_plane_world_name_f(played, {1, 0}, &name), GRAZE_OK);
    *static_cast<std::string*>(user) = name;
  };
  std::string name;
  ASSERT_EQ(graze_replay_f(file.data(), file.size(), name_of_last, &name, &report, nullptr), GRAZE_OK);
  EXPECT_EQ(name, "disc");
  EXPECT_TRUE(report.plane && !report.simulation && !report.differs && !report.cut);
  EXPECT_EQ(report.frames, 2u);

  GrazeWorldSettingsd settings = graze_world_settings_default_d();
  settings.allow = [](void*, GrazeBodyId, GrazeBodyId) { return true; };
  GrazeWorldd* refused = nullptr;
  EXPECT_EQ(graze_world_create_captured_d(&settings, nullptr, &keep, &file, &refused), GRAZE_INVALID_VALUE);
  EXPECT_EQ(graze_world_create_captured_d(nullptr, nullptr, &refuse, nullptr, &refused), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "capture: the stream takes no more bytes");
  EXPECT_EQ(graze_world_create_captured_d(nullptr, nullptr, nullptr, nullptr, &refused), GRAZE_INVALID_VALUE);
  EXPECT_EQ(refused, nullptr);
}

TEST(CReplay, RefusesWhatIsNoCaptureOfItsScalar) {
  const std::string file = captured_fall();
  GrazeReplayReport report;
  EXPECT_EQ(graze_replay_f(file.data(), file.size(), nullptr, nullptr, &report, nullptr), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "bytes: expected a capture of the function's scalar, got one in double");
  EXPECT_EQ(graze_replay_d("hello", 5, nullptr, nullptr, &report, nullptr), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "bytes: expected a capture, got something else");
  EXPECT_EQ(graze_replay_d(nullptr, 5, nullptr, nullptr, &report, nullptr), GRAZE_INVALID_VALUE);
  EXPECT_EQ(graze_replay_d(file.data(), file.size(), nullptr, nullptr, nullptr, nullptr), GRAZE_INVALID_VALUE);
}

}  // namespace
}  // namespace graze::testing
