// Scenes of the plane that are played: against closed forms, what is written of them, and what is refused.
#include "graze/io/plane_simulate.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "common/executors.hpp"
#include "graze/capture.hpp"
#include "graze/error.hpp"

namespace graze::io {
namespace {

PlaneScene drawn(const std::string& inside, const std::string& root = "") {
  return load_plane_svg("<svg xmlns=\"http://www.w3.org/2000/svg\" " + root + ">" + inside + "</svg>", "t.svg");
}
PlaneScene told(const std::string& bodies) {
  return load_plane_json("{\"dimension\": 2, \"bodies\": [" + bodies + "]}", "t.json");
}

std::vector<PlaneSimulationFrame> played(const PlaneScene& scene, SimulateOptions options = {}) {
  std::vector<PlaneSimulationFrame> frames;
  if (scene.gravity) options.gravity = {scene.gravity->x, scene.gravity->y, 0};
  simulate(scene, options, [&](const PlaneSimulationFrame& frame) { frames.push_back(frame); });
  return frames;
}

std::string refusal(const PlaneScene& scene) {
  try {
    played(scene, {.seconds = 0.1});
  } catch (const InvalidValue& e) {
    return e.what();
  }
  return "nothing";
}

/// The drawing's y points down, and a turn as that of `rotate` is clockwise there.
TEST(PlaySvg, WhatIsThrownFliesAParabola) {
  const PlaneScene scene = drawn(
      R"x(<g class="dynamic" transform="translate(10 20) scale(2)" data-velocity="3 -4" data-angular="0.5">
            <rect id="stone" x="-1" y="-1" width="2" height="2"/></g>)x",
      "data-gravity=\"0 10\"");
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    const double rounding = precision == Precision::double_precision ? 1e-10 : 1e-3;
    const auto frames = played(scene, {.seconds = 2, .precision = precision});
    ASSERT_EQ(frames.size(), 121u);
    for (const PlaneSimulationFrame& frame : frames) {
      const double t = frame.time;
      const PlaneBodyState& stone = frame.bodies.at(0);
      EXPECT_NEAR(stone.translation.x, 10 + 6 * t, rounding);
      EXPECT_NEAR(stone.translation.y, -20 + 8 * t - 5 * t * t, rounding);
      EXPECT_NEAR(stone.rotation, -0.5 * t, rounding);
      EXPECT_NEAR(stone.linear.y, 8 - 10 * t, rounding);
      EXPECT_NEAR(stone.angular, -0.5, rounding);
    }
  }
}

TEST(PlayJson, WhatSlidesStopsByItsFriction) {
  const auto frames = played(told(R"x({"name": "floor", "shape": {"type": "plane"}, "friction": 0.5},
      {"name": "plate", "motion": "dynamic", "shape": {"type": "box", "box": {"size": [2, 0.1]}},
       "translation": [0, 0.05], "linear": [6, 0], "friction": 0.5, "mass": 7})x"),
                             {.seconds = 3, .gravity = {0, -10, 0}});
  EXPECT_NEAR(frames.back().bodies[0].translation.x, 36 / (2 * 0.5 * 10), 0.01);
  EXPECT_NEAR(frames.front().kinetic_energy, 7 * 36 / 2.0, 1e-9);
  ASSERT_EQ(frames.back().contacts.size(), 1u);
  EXPECT_NEAR(frames.back().contacts[0].impulse, 7 * 10 / 60.0, 1e-3);
}

TEST(PlayJson, KinematicBodiesKeepTheirVelocityAndGravityItsFactor) {
  const auto frames = played(told(R"x(
      {"name": "lift", "motion": "kinematic", "shape": {"type": "box", "box": {"size": [2, 1]}}, "linear": [0, 0.5]},
      {"name": "balloon", "motion": "dynamic", "shape": {"type": "circle", "circle": {"radius": 1}},
       "translation": [9, 0], "gravityFactor": -0.5, "restitution": 0.3})x"),
                             {.seconds = 1, .gravity = {0, -8, 0}});
  EXPECT_NEAR(frames.back().bodies[0].translation.y, 0.5, 1e-12);
  EXPECT_NEAR(frames.back().bodies[1].translation.y, 2, 1e-12);
}

/// A hammer turns about the centre of mass of both its parts, not about that of the first.
TEST(PlaySvg, ShapesOfABodyMoveAsOne) {
  const auto frames = played(drawn(R"x(<g class="dynamic" data-body="hammer" data-angular="-1">
      <rect x="-1" y="-1" width="2" height="2"/><rect x="3" y="-1" width="2" height="2"/></g>)x",
                                   "data-gravity=\"0 0\""),
                             {.seconds = 1});
  ASSERT_EQ(frames.back().bodies.size(), 1u);
  const double x = frames.back().bodies[0].translation.x, y = frames.back().bodies[0].translation.y;
  // The velocity that is given is that of the first part's origin, which the centre of mass, 2 beside it, goes round:
  // it moves up at 2 itself.
  EXPECT_NEAR(x, 2 - 2 * std::cos(1.0), 1e-9);
  EXPECT_NEAR(y, 2 - 2 * std::sin(1.0), 1e-9);
}

TEST(PlaySvg, WhatCannotBePlayedIsNamed) {
  EXPECT_EQ(refusal(drawn(R"x(<line id="wire" class="dynamic" x2="4"/>)x")),
            "t.svg: wire.shape: expected a shape with an area, or a mass and an inertia, got segment");
  EXPECT_EQ(refusal(drawn(R"x(<line class="dynamic" x2="4" data-mass="1" data-inertia="2"/>)x")), "nothing");
  EXPECT_EQ(refusal(drawn(R"x(<circle id="ball" class="dynamic" r="1" data-restitution="1.5"/>)x")),
            "t.svg: ball.restitution: expected a number from 0 to 1, got 1.5");
  EXPECT_EQ(refusal(drawn(R"x(<g class="dynamic" data-body="two"><circle r="1" data-systems="a"/>
                              <circle id="other" cx="2" r="1"/></g>)x")),
            "t.svg: two.other: expected the collision systems of the body's other shapes, to be played, got others");
  EXPECT_THROW(drawn(R"x(<g class="dynamic" data-body="two"><circle r="1" data-mass="2"/><circle r="1"/></g>)x"),
               InvalidValue);
  EXPECT_THROW(drawn("", "data-gravity=\"10\""), InvalidValue);
  EXPECT_THROW(drawn(R"x(<circle r="1" data-velocity="1,2,3"/>)x"), InvalidValue);
  EXPECT_THROW(told(R"x({"shape": {"type": "plane"}, "mass": "much"})x"), InvalidValue);
}

TEST(PlaySvg, ACaptureRunsAgainToTheSameBits) {
  const PlaneScene scene = drawn(R"x(<rect y="2" width="9" height="1"/><g class="dynamic" data-body="two">
      <circle r="1"/><circle cx="1" r="1"/></g><polygon class="dynamic" points="0,-5 2,-5 2,-3 1,-4"/>)x");
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    std::stringstream file;
    const SimulateSummary summary =
        simulate(scene, {.seconds = 1, .precision = precision, .capture = &file}, [](const PlaneSimulationFrame&) {});
    const ReplayReport report = replay(file, "scene.capture");
    EXPECT_TRUE(report.plane && report.simulation);
    EXPECT_EQ(report.single, precision == Precision::single_precision);
    EXPECT_EQ(report.frames, summary.steps);
    EXPECT_FALSE(report.difference);
  }
}

TEST(PlaySvg, SameFramesOnAnyThreads) {
  std::string balls;
  for (int i = 0; i < 40; ++i)
    balls += "<circle class=\"dynamic\" cx=\"" + std::to_string(i % 7) + "\" cy=\"" + std::to_string(-2 * i) +
             "\" r=\"0.6\"/>";
  const PlaneScene scene = drawn("<rect class=\"static\" x=\"-9\" y=\"1\" width=\"30\" height=\"1\"/>" + balls);
  const auto serial = played(scene, {.seconds = 2});
  testing::ThreadExecutor threads(3);
  const auto parallel = played(scene, {.seconds = 2, .executor = &threads});
  for (std::size_t i = 0; i < serial.size(); ++i)
    for (std::size_t k = 0; k < serial[i].bodies.size(); ++k) {
      EXPECT_EQ(serial[i].bodies[k].translation, parallel[i].bodies[k].translation);
      EXPECT_EQ(serial[i].bodies[k].rotation, parallel[i].bodies[k].rotation);
    }
}

/// What a recording of a scene wrote.
std::string recorded(const PlaneScene& scene, const char* ending) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("graze_plane_recording_" + std::to_string(getpid()) + ending);
  const auto recording = record(file, scene);
  for (const PlaneSimulationFrame& frame : played(scene, {.seconds = 0.5, .rate = 10})) recording->add(frame);
  recording->close();
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(file);
  return text;
}

TEST(PlaneRecording, LinesAreThoseOfTheProtocol) {
  std::istringstream lines(recorded(
      drawn(R"x(<rect id="floor" y="1" x="-5" width="10" height="1"/><circle id="ball" class="dynamic" r="1"/>)x"),
      ".jsonl"));
  std::string line;
  int count = 0;
  for (; std::getline(lines, line); ++count) {
    const auto frame = nlohmann::json::parse(line);
    EXPECT_EQ(frame["time"], count / 10.0);
    ASSERT_EQ(frame["bodies"].size(), 1u);
    EXPECT_EQ(frame["bodies"][0]["body"], "ball");
    EXPECT_EQ(frame["bodies"][0]["translation"].size(), 2u);
    EXPECT_TRUE(frame["bodies"][0]["rotation"].is_number());
    if (count > 0) {
      ASSERT_EQ(frame["contacts"].size(), 1u);
      EXPECT_EQ(frame["contacts"][0]["a"], "floor");
      EXPECT_EQ(frame["contacts"][0]["b"], "ball");
      EXPECT_GT(frame["contacts"][0]["impulse"], 0);
    }
  }
  EXPECT_EQ(count, 6);
}

/// Each moving body has a way and a turn with a value a frame; what stays has none.
TEST(PlaneRecording, PicturesMove) {
  const PlaneScene scene = drawn(R"x(<rect id="floor" y="9" x="-5" width="10" height="1"/>
      <circle class="dynamic" r="1" data-angular="1"/><circle class="dynamic" cx="3" r="1"/>)x",
                                 "data-gravity=\"0 10\"");
  const std::string picture = recorded(scene, ".svg");
  std::vector<std::string> values;
  for (std::size_t at = picture.find("values=\""); at != std::string::npos; at = picture.find("values=\"", at + 1))
    values.push_back(picture.substr(at + 8, picture.find('"', at + 8) - at - 8));
  ASSERT_EQ(values.size(), 4u);
  for (const std::string& list : values) EXPECT_EQ(std::count(list.begin(), list.end(), ';'), 5);
  EXPECT_EQ(values[0].rfind("0.00 0.00;", 0), 0u);
  // Down in the picture, by 1.25 units at the end, and as far as the scale says: 600 pixels less margins for 11 units.
  double x = 1, y = 0;
  std::istringstream(values[0].substr(values[0].rfind(';') + 1)) >> x >> y;
  EXPECT_NEAR(x, 0, 0.01);
  EXPECT_GT(y, 30);
  double angle = 0;
  std::istringstream(values[1].substr(values[1].rfind(';') + 1)) >> angle;
  EXPECT_NEAR(angle, 0.5 * 180 / std::acos(-1.0), 0.001);
  EXPECT_EQ(picture.substr(picture.size() - 7), "</svg>\n");
}

}  // namespace
}  // namespace graze::io
