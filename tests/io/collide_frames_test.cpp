// Events over time, against scans that do not use the world; where an animation takes a collider; and what is refused.
#include "graze/io/collide_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "animated_file.hpp"
#include "graze/query.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

struct Seen {
  double time;
  FrameEvent event;
};

std::vector<Seen> events(const Scene& scene, const FrameOptions& options = {}) {
  std::vector<Seen> seen;
  collide_frames(scene, options, [&](const Frame& f) {
    for (const FrameEvent& e : f.events) seen.push_back({f.time, e});
  });
  return seen;
}

/// The ball flies past the box from x = -3 to 3 in two seconds.
AnimatedFile passing() {
  AnimatedFile file;
  file.move(1, "translation", {0, 2}, {-3, 0, 0, 3, 0, 0});
  return file;
}

// The ball touches where |x| <= 1, and x = 3 t - 3.
TEST(CollideFrames, ABallPassesABox) {
  const Scene scene = passing().load();
  ASSERT_EQ(scene.animations.size(), 1u);
  EXPECT_EQ(scene.animations[0].name, "animation 0");
  EXPECT_EQ(scene.animations[0].duration, 2);
  EXPECT_EQ(animated_colliders(scene, 0), std::vector<std::uint32_t>{1});
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    FrameOptions options;
    options.fps = 50;
    options.margin = 0;
    options.precision = precision;
    std::optional<double> begin, end;
    for (int i = 0; i <= 100; ++i) {
      const double t = i / 50.0, gap = std::abs(3 * t - 3) - 1;
      if (std::abs(gap) < 1e-6) continue;  // decided by rounding
      if (gap < 0 && !begin) begin = t;
      if (gap > 0 && begin && !end) end = t;
    }
    const auto seen = events(scene, options);
    ASSERT_EQ(seen.size(), 2u);
    EXPECT_TRUE(seen[0].event.begin);
    EXPECT_EQ(seen[0].event.a, 0u);
    EXPECT_EQ(seen[0].event.b, 1u);
    EXPECT_FALSE(seen[0].event.trigger);
    EXPECT_EQ(seen[0].time, *begin);
    EXPECT_NEAR(seen[0].event.depth.value(), 1 - std::abs(3 * *begin - 3), 1e-6);
    EXPECT_FALSE(seen[1].event.begin);
    EXPECT_EQ(seen[1].time, *end);
    EXPECT_FALSE(seen[1].event.depth);
  }
}

TEST(CollideFrames, FramesAndPairsAreCounted) {
  const Scene scene = passing().load();
  FrameOptions options;
  options.fps = 10;
  std::vector<std::size_t> pairs;
  collide_frames(scene, options, [&](const Frame& f) {
    EXPECT_EQ(f.index, pairs.size());
    EXPECT_EQ(f.count, 21u);
    EXPECT_DOUBLE_EQ(f.time, static_cast<double>(f.index) / 10);
    pairs.push_back(f.pairs);
  });
  ASSERT_EQ(pairs.size(), 21u);
  for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_EQ(pairs[i], i >= 7 && i <= 13) << i;
  options.duration = 1;
  EXPECT_EQ(frame_count(scene, options), 11u);
  options.duration = 3;  // stays where it is
  EXPECT_EQ(frame_count(scene, options), 31u);
  options.duration = 0;
  EXPECT_EQ(frame_count(scene, options), 1u);
}

// Times in files are floats: 0.7 is a little less.
TEST(CollideFrames, TheLastFrameIsNotLostToRounding) {
  AnimatedFile file;
  file.move(1, "translation", {0, 0.7F}, {-3, 0, 0, 3, 0, 0});
  FrameOptions options;
  EXPECT_EQ(frame_count(file.load(), options), 22u);
}

TEST(CollideFrames, TriggersAndFiltersHold) {
  AnimatedFile file = passing();
  Json& physics = file.json["nodes"][0]["extensions"]["KHR_physics_rigid_bodies"];
  physics = {{"trigger", physics["collider"]}};
  const auto seen = events(file.load());
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_TRUE(seen[0].event.trigger);
  EXPECT_FALSE(seen[0].event.depth);
  EXPECT_TRUE(seen[1].event.trigger);

  file = passing();
  file.json["extensions"]["KHR_physics_rigid_bodies"]["collisionFilters"] = {
      {{"collisionSystems", {"a"}}, {"notCollideWithSystems", {"a"}}}};
  for (auto& node : file.json["nodes"])
    node["extensions"]["KHR_physics_rigid_bodies"]["collider"]["collisionFilter"] = 0;
  EXPECT_TRUE(events(file.load()).empty());
}

// Two that cannot move are no pair, though they overlap; one that is moved meets both.
TEST(CollideFrames, WhatIsMovedIsNotFixed) {
  AnimatedFile file = passing();
  file.json["nodes"].push_back(file.json["nodes"][0]);
  file.json["nodes"][2]["name"] = "second box";
  file.json["scenes"][0]["nodes"] = {0, 1, 2};
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const Seen& s : events(file.load())) pairs.insert({s.event.a, s.event.b});
  EXPECT_EQ(pairs, (std::set<std::pair<std::uint32_t, std::uint32_t>>{{0, 1}, {1, 2}}));
}

/// A box on an arm on a turning, scaled node: what stands in each frame, by maps multiplied here.
TEST(CollideFrames, AHierarchyAgainstAScan) {
  AnimatedFile file;
  file.json["nodes"][0]["translation"] = {2, 0, 0};
  file.json["nodes"].push_back({{"name", "hub"}, {"children", {0}}, {"scale", {1.5, 1.5, 1.5}}});
  file.json["nodes"][1]["translation"] = {0, 3.2, 0};
  file.json["scenes"][0]["nodes"] = {1, 2};
  const auto h = static_cast<float>(std::sqrt(0.5));
  file.move(2, "rotation", {0, 1, 2}, {0, 0, 0, 1, 0, 0, h, h, 0, 0, 1, 0});
  const Scene scene = file.load();
  FrameOptions options;
  options.fps = 97;
  options.margin = 0;
  const auto seen = events(scene, options);
  // The scan: a box of size 1.5, 3 away from the hub, turned by 90 degrees a second; `distance` of the two shapes.
  std::vector<std::pair<double, bool>> expected;
  const std::size_t ball = scene.colliders[0].name == "ball" ? 0 : 1;
  bool touching = false;
  for (int i = 0; i <= 194; ++i) {
    const double t = i / 97.0, angle = t * M_PI / 2;
    const Posed box{{3 * std::cos(angle), 3 * std::sin(angle), 0}, Quatd::from_axis_angle({0, 0, 1}, angle)};
    const bool now = overlap(Shaped(Box<double>({1.5, 1.5, 1.5})), box, Shaped(Sphere<double>(0.5)), {{0, 3.2, 0}, {}});
    if (now != touching) expected.push_back({t, now});
    touching = now;
  }
  ASSERT_EQ(seen.size(), expected.size());
  ASSERT_EQ(seen.size(), 2u);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(seen[i].time, expected[i].first);
    EXPECT_EQ(seen[i].event.begin, expected[i].second);
  }
  EXPECT_EQ(animated_colliders(scene, 0), std::vector<std::uint32_t>{static_cast<std::uint32_t>(1 - ball)});
}

// The ball stays 1.5 from the box's middle and grows: as a ball it touches from radius 1 on, stretched along y never.
TEST(CollideFrames, AnimatedScaleMakesNewShapes) {
  AnimatedFile file;
  file.json["nodes"][1]["translation"] = {-1.5, 0, 0};
  file.move(1, "scale", {0, 2}, {1, 1, 1, 3, 3, 3});
  FrameOptions options;
  options.fps = 100;
  options.margin = 0;
  const auto grows = events(file.load(), options);
  ASSERT_EQ(grows.size(), 1u);
  EXPECT_NEAR(grows[0].time, 1, 0.0101);  // radius 0.5 (1 + t) reaches 1 at one second
  AnimatedFile stretched;
  stretched.json["nodes"][1]["translation"] = {-1.5, 0, 0};
  stretched.move(1, "scale", {0, 2}, {1, 1, 1, 1, 3, 1});
  EXPECT_TRUE(events(stretched.load(), options).empty());
}

// glTF hides things by a scale of zero.
TEST(CollideFrames, WhatIsScaledToNothingTouchesNothing) {
  AnimatedFile file;
  file.json["nodes"][1]["translation"] = {-0.5, 0, 0};
  file.move(1, "scale", {0, 1, 2}, {1, 1, 1, 0, 0, 0, 2, 2, 2}, "STEP");
  const auto seen = events(file.load());
  ASSERT_EQ(seen.size(), 3u);
  EXPECT_EQ(seen[0].time, 0);
  EXPECT_FALSE(seen[1].event.begin);
  EXPECT_DOUBLE_EQ(seen[1].time, 1);
  EXPECT_TRUE(seen[2].event.begin);
  EXPECT_DOUBLE_EQ(seen[2].time, 2);
  EXPECT_NEAR(seen[2].event.depth.value(), 1, 1e-9);  // now a ball of radius 1 at the box's side
}

TEST(CollideFrames, AnimationsAreFoundByNameOrIndex) {
  AnimatedFile file = passing();
  file.move(0, "translation", {0, 1}, {0, 0, 0, 0, 5, 0}, "LINEAR", 1);
  file.json["animations"][1]["name"] = "rise";
  Scene scene = file.load();
  EXPECT_EQ(find_animation(scene, "rise"), 1u);
  EXPECT_EQ(find_animation(scene, "1"), 1u);
  EXPECT_EQ(find_animation(scene, "animation 0"), 0u);
  EXPECT_THROW(find_animation(scene, "2"), InvalidValue);
  EXPECT_THROW(find_animation(scene, "fall"), InvalidValue);
  // Behind another scene its colliders have other indices.
  Scene both = AnimatedFile().load();
  append(both, scene);
  EXPECT_EQ(animated_colliders(both, 0), std::vector<std::uint32_t>{3});
  EXPECT_EQ(animated_colliders(both, 1), std::vector<std::uint32_t>{2});
  both.colliders.pop_back();
  EXPECT_THROW(animated_colliders(both, 0), InvalidValue);
}

TEST(CollideFrames, OptionsAreChecked) {
  const auto refusal = [](const Scene& scene, const std::function<void(FrameOptions&)>& change) -> std::string {
    FrameOptions options;
    change(options);
    try {
      collide_frames(scene, options, [](const Frame&) {});
    } catch (const InvalidValue& e) {
      return e.what();
    }
    return "played";
  };
  const Scene scene = passing().load();
  EXPECT_EQ(refusal(AnimatedFile().load(), [](FrameOptions&) {}),
            "test.gltf: expected at least one animation, got no animation");
  EXPECT_EQ(refusal(scene, [](FrameOptions& o) { o.animation = 7; }), "animation: expected an index below 1, got 7");
  for (const double bad : {0.0, -1.0, double(NAN), double(INFINITY)}) {
    EXPECT_NE(refusal(scene, [&](FrameOptions& o) { o.fps = bad; }).find("fps: expected a finite number above 0"),
              std::string::npos);
    if (bad != 0.0) {
      EXPECT_NE(refusal(scene, [&](FrameOptions& o) { o.duration = bad; }).find("duration: expected a finite number"),
                std::string::npos);
      EXPECT_NE(refusal(scene, [&](FrameOptions& o) { o.margin = bad; }).find("margin: expected a finite"),
                std::string::npos);
    }
  }
  EXPECT_NE(refusal(scene, [](FrameOptions& o) { o.fps = 1e9; }).find("frames in all"), std::string::npos);
}

}  // namespace
}  // namespace graze::io
