// Rotations and angles against those of the C++ library.
#include "plane/angles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace graze::plane {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();

TEST(PlaneAngles, RotationsAreThoseOfTheLibrary) {
  std::mt19937 random(4);
  for (int round = 0; round < 200000; ++round) {
    const double reach = std::pow(10.0, std::uniform_real_distribution<double>(-6, 6)(random));
    const double angle = std::uniform_real_distribution<double>(-reach, reach)(random);
    const Rot2d turn = rotation_of(angle);
    const double allowed = 2 * unit * std::max(1.0, std::abs(angle));
    ASSERT_NEAR(turn.cosine, std::cos(angle), allowed) << angle;
    ASSERT_NEAR(turn.sine, std::sin(angle), std::min(allowed, 2 * unit * std::abs(angle))) << angle;
    ASSERT_NEAR(turn.cosine * turn.cosine + turn.sine * turn.sine, 1, 4 * unit) << angle;
  }
  EXPECT_EQ(rotation_of(0), Rot2d{});
  EXPECT_EQ(rotation_of(std::numeric_limits<double>::infinity()), Rot2d{});
  EXPECT_EQ(rotation_of(std::numeric_limits<double>::quiet_NaN()), Rot2d{});
}

TEST(PlaneAngles, AnglesAreThoseOfTheLibrary) {
  std::mt19937 random(5);
  for (int round = 0; round < 200000; ++round) {
    const double angle = std::uniform_real_distribution<double>(-std::numbers::pi, std::numbers::pi)(random) *
                         (round % 3 ? 1 : std::pow(10.0, -(round % 12)));
    const Vec2d d = normalized(Vec2d{std::cos(angle), std::sin(angle)});
    ASSERT_NEAR(angle_of(d), std::atan2(d.y, d.x), 4 * unit * std::abs(angle)) << angle;
  }
  EXPECT_EQ(angle_of({1, 0}), 0);
  EXPECT_NEAR(angle_of({-1, 0}), std::numbers::pi, 4 * unit);
  EXPECT_NEAR(angle_of({0, -1}), -std::numbers::pi / 2, 4 * unit);
}

}  // namespace
}  // namespace graze::plane
