// Materials: the rules by which two become one, and those that are refused.
#include "graze/material.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "graze/detail/validate.hpp"
#include "graze/plane/vec2.hpp"

namespace graze::testing {
namespace {

constexpr Combine all[] = {Combine::unset, Combine::average, Combine::minimum, Combine::maximum, Combine::multiply};

TEST(Material, TheFirstRuleOfTheListCountsAndUnsetIsNone) {
  for (const Combine a : all)
    for (const Combine b : all) {
      EXPECT_EQ(combined(a, b), combined(b, a));
      EXPECT_NE(combined(a, b), Combine::unset);
    }
  EXPECT_EQ(combined(Combine::unset, Combine::unset), Combine::average);
  EXPECT_EQ(combined(Combine::unset, Combine::multiply), Combine::multiply);
  EXPECT_EQ(combined(Combine::maximum, Combine::unset), Combine::maximum);
  EXPECT_EQ(combined(Combine::multiply, Combine::maximum), Combine::maximum);
  EXPECT_EQ(combined(Combine::minimum, Combine::maximum), Combine::minimum);
  EXPECT_EQ(combined(Combine::minimum, Combine::average), Combine::average);
}

// A floor of restitution 0.5 under a ball of 0: what the conformance scene of combine modes shows.
TEST(Material, NumbersAreCombinedEachByItsOwnRule) {
  Material<double> floor, ball;
  floor.restitution = 0.5;
  ball.static_friction = 1;
  ball.dynamic_friction = 0.2;
  ball.rolling_friction = 0.01;
  EXPECT_EQ(combined(floor, ball).restitution, 0.25);
  floor.restitution_combine = Combine::minimum;
  EXPECT_EQ(combined(floor, ball).restitution, 0.0);
  floor.restitution_combine = Combine::maximum;
  EXPECT_EQ(combined(floor, ball).restitution, 0.5);
  ball.friction_combine = Combine::multiply;
  const ContactMaterial<double> both = combined(ball, floor);
  EXPECT_EQ(both.restitution, 0.5);
  EXPECT_EQ(both.static_friction, 0.6);
  EXPECT_EQ(both.dynamic_friction, 0.6 * 0.2);
  EXPECT_EQ(both.rolling_friction, 0.01);
}

/// The border of what is accepted, in the plane as in space.
TEST(Material, NumbersThatMakeNoSenseAreRefused) {
  const auto refuses = [](const auto& material, const char* path) {
    try {
      check(material);
      ADD_FAILURE() << path;
    } catch (const InvalidValue& e) {
      EXPECT_NE(std::string(e.what()).find(path), std::string::npos) << e.what();
    }
  };
  Material<float> good;
  good.static_friction = good.rolling_friction = 0;
  good.restitution = 1;
  EXPECT_NO_THROW(check(good));
  Material<float> bouncing = good;
  bouncing.restitution = 1.0000001f;
  refuses(bouncing, "restitution");
  Material<double, plane::Vec2<double>> pulling;
  EXPECT_NO_THROW(check(pulling));
  pulling.dynamic_friction = -1e-300;
  refuses(pulling, "dynamic_friction");
  pulling.dynamic_friction = 0;
  pulling.surface_velocity.x = std::numeric_limits<double>::infinity();
  refuses(pulling, "surface_velocity");
}

}  // namespace
}  // namespace graze::testing
