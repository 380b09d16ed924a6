// A character's ways in the plane: along walls, into corners, down slopes, over chains, and never into anything.
#include <gtest/gtest.h>

#include "graze/plane/slide.hpp"
#include "plane/figures.hpp"

namespace graze::plane {
namespace {

Body<double> standing(Shaped shape, const Pose2d& pose = {}) {
  Body<double> body{std::move(shape), pose};
  body.fixed = true;
  return body;
}

const Shaped walker(Circle<double>(0.5));

TEST(PlaneCharacter, GoesItsWayWhereNothingIs) {
  World<double> world;
  world.add(standing(Box<double>({1, 1}), {{0, 10}, {}}));
  const auto result = slide(walker, {}, {3, 1}, world);
  EXPECT_EQ(result.pose.translation, (Vec2d{3, 1}));
  EXPECT_EQ(result.left, Vec2d{});
  EXPECT_TRUE(result.touched.empty());
}

TEST(PlaneCharacter, TurnsAlongAWallAndStopsInACorner) {
  World<double> world;
  const BodyId wall = world.add(standing(Box<double>({1, 20}), {{2, 0}, {}}));
  const auto along = slide(walker, {}, {3, 2}, world);
  EXPECT_NEAR(length(along.pose.translation - Vec2d{1, 2}), 0, 1e-6);
  ASSERT_EQ(along.touched.size(), 1u);
  EXPECT_EQ(along.touched[0].body, wall);
  EXPECT_NEAR(along.touched[0].hit.t, 1.0 / 3, 1e-6);
  world.add(standing(Box<double>({20, 1}), {{0, 2}, {}}));
  const auto corner = slide(walker, {}, {3, 3}, world);
  EXPECT_NEAR(length(corner.pose.translation - Vec2d{1, 1}), 0, 1e-6);
  EXPECT_EQ(corner.left, Vec2d{});
}

TEST(PlaneCharacter, WalksOverTheSeamsOfAChainThatItIsPressedAgainst) {
  World<double> world;
  std::vector<Vec2d> floor;
  for (int i = 0; i <= 40; ++i) floor.push_back({20 - i * 1.0, 0});
  world.add(standing(Chain<double>(floor)));
  const auto result = slide(walker, {{0, 0.5}, {}}, {7.3, -1}, world);
  EXPECT_NEAR(length(result.pose.translation - Vec2d{7.3, 0.5}), 0, 1e-6);
}

TEST(PlaneCharacter, NeverEntersAnything) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-4, 4);
  const auto vector = [&] {
    const double x = uniform(random), y = uniform(random);
    return Vec2d{x, y};
  };
  int walked = 0;
  for (int scene = 0; scene < 20; ++scene) {
    World<double> world;
    world.add(standing(HalfPlane<double>(), {{0, -3}, {}}));
    for (int i = 0; i < 20; ++i) {
      Shaped shape = random_figure<double>(i % figure_kinds, 0.6, random).shape;
      world.add(standing(std::move(shape), random_pose<double>(2, random)));
    }
    const Shaped body(Capsule<double>(0.4, 0.15));
    for (int i = 0; i < 20; ++i) {
      const Pose2d start{vector(), {}};
      const Vec2d motion = vector();
      if (world.overlaps_any(body, start)) continue;
      const auto result = slide(body, start, motion, world);
      const auto nearest = world.closest(body, result.pose);
      ASSERT_TRUE(nearest.has_value());
      EXPECT_GE(nearest->distance.distance, -1e-5);
      EXPECT_LE(length(result.pose.translation - start.translation), length(motion) * (1 + 1e-9));
      ++walked;
    }
  }
  EXPECT_GT(walked, 50);
}

TEST(AlongLines, LeavesTheNearestMotionThatIsAllowed) {
  const Vec2d up{0, 1}, back{-1, 0};
  const auto along = [](const Vec2d& motion, std::vector<Vec2d> normals) {
    return along_lines<double>(motion, normals);
  };
  EXPECT_EQ(along({1, 2}, {}), (Vec2d{1, 2}));
  EXPECT_EQ(along({1, 2}, {up}), (Vec2d{1, 2}));
  EXPECT_EQ(along({1, -2}, {up}), (Vec2d{1, 0}));
  EXPECT_EQ(along({1, -2}, {up, back}), Vec2d{});
  EXPECT_EQ(along({-1, -2}, {up, back}), (Vec2d{-1, 0}));
}

}  // namespace
}  // namespace graze::plane
