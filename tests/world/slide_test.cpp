// A character's ways: along walls, into corners, down slopes, and never into anything.
#include "graze/slide.hpp"

#include <gtest/gtest.h>

#include "common/specimen.hpp"

namespace graze {
namespace {

using testing::Random;

Body<double> fixed_box(const Vec3d& size, const Posed& pose) {
  Body<double> body{Shaped(Box<double>(size)), pose};
  body.fixed = true;
  return body;
}

const Shaped ball(Sphere<double>(0.5));

TEST(Slide, GoesItsWayWhereNothingIs) {
  Worldd world;
  world.add(fixed_box({1, 1, 1}, {{0, 10, 0}, {}}));
  const auto result = slide(ball, {}, {3, 0, 1}, world);
  EXPECT_EQ(result.pose.translation, (Vec3d{3, 0, 1}));
  EXPECT_EQ(result.left, Vec3d{});
  EXPECT_TRUE(result.touched.empty());
}

TEST(Slide, TurnsAlongAWall) {
  Worldd world;
  const BodyId wall = world.add(fixed_box({1, 4, 20}, {{2, 0, 0}, {}}));
  const auto result = slide(ball, {}, {3, 0, 2}, world);
  EXPECT_NEAR(length(result.pose.translation - Vec3d{1, 0, 2}), 0, 1e-6);
  ASSERT_EQ(result.touched.size(), 1u);
  EXPECT_EQ(result.touched[0].body, wall);
  EXPECT_NEAR(result.touched[0].hit.t, 1.0 / 3, 1e-6);
}

TEST(Slide, StopsInACornerAndSlidesAlongACrease) {
  Worldd world;
  world.add(fixed_box({1, 20, 20}, {{2, 0, 0}, {}}));
  world.add(fixed_box({20, 20, 1}, {{0, 0, 2}, {}}));
  const auto flat = slide(ball, {}, {3, 0, 3}, world);
  EXPECT_NEAR(length(flat.pose.translation - Vec3d{1, 0, 1}), 0, 1e-6);
  EXPECT_EQ(flat.left, Vec3d{});
  const auto rising = slide(ball, {}, {3, 2, 3}, world);
  EXPECT_NEAR(length(rising.pose.translation - Vec3d{1, 2, 1}), 0, 1e-6);
}

TEST(Slide, MovesOverAFloorThatItRestsOn) {
  Worldd world;
  world.add({Shaped(HalfSpace<double>())});
  const auto result = slide(ball, {{0, 0.5, 0}, {}}, {4, 0, 0}, world);
  EXPECT_NEAR(length(result.pose.translation - Vec3d{4, 0.5, 0}), 0, 1e-6);
  // Down a floor that it is pressed against, too.
  const auto pressed = slide(ball, {{0, 0.5, 0}, {}}, {4, -1, 0}, world);
  EXPECT_NEAR(length(pressed.pose.translation - Vec3d{4, 0.5, 0}), 0, 1e-6);
}

TEST(Slide, NeverEntersAnything) {
  Random random(3);
  for (int scene = 0; scene < 20; ++scene) {
    Worldd world;
    world.add({Shaped(HalfSpace<double>()), {{0, -3, 0}, {}}});
    for (int i = 0; i < 40; ++i) {
      const auto kind = static_cast<testing::Kind>(random() % testing::bounded_kinds);
      world.add({testing::build<double>(testing::random_specimen(kind, 1, random)),
                 {converted<double>(testing::random_vector(random, 4)),
                  converted<double>(testing::random_rotation(random))}});
    }
    const Shaped body(Capsule<double>(0.6, 0.2, 0.2));
    for (int i = 0; i < 20; ++i) {
      const Posed start{converted<double>(testing::random_vector(random, 4)), {}};
      if (world.overlaps_any(body, start)) continue;
      const Vec3d motion = converted<double>(testing::random_vector(random, 5));
      const auto result = slide(body, start, motion, world);
      const auto nearest = world.closest(body, result.pose);
      ASSERT_TRUE(nearest.has_value());
      EXPECT_GE(nearest->distance.distance, -1e-5);
      EXPECT_LE(length(result.pose.translation - start.translation), length(motion) * (1 + 1e-9));
    }
  }
}

TEST(AlongPlanes, LeavesTheNearestMotionThatIsAllowed) {
  const Vec3d up{0, 1, 0}, back{-1, 0, 0}, left{0, 0, 1};
  const auto along = [](const Vec3d& motion, std::vector<Vec3d> normals) {
    return along_planes<double>(motion, normals);
  };
  EXPECT_EQ(along({1, 2, 3}, {}), (Vec3d{1, 2, 3}));
  EXPECT_EQ(along({1, 2, 3}, {up}), (Vec3d{1, 2, 3}));
  EXPECT_EQ(along({1, -2, 3}, {up}), (Vec3d{1, 0, 3}));
  EXPECT_EQ(along({1, -2, 3}, {up, back}), (Vec3d{0, 0, 3}));
  EXPECT_EQ(along({1, -2, -3}, {up, back, left}), Vec3d{});
}

}  // namespace
}  // namespace graze
