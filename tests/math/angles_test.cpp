// Cosines, sines and angles against those of the C++ library.
#include "graze/angles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace graze {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();

TEST(Angles, CosinesAndSinesAreThoseOfTheLibrary) {
  std::mt19937 random(4);
  for (int round = 0; round < 200000; ++round) {
    const double reach = std::pow(10.0, std::uniform_real_distribution<double>(-6, 6)(random));
    const double angle = std::uniform_real_distribution<double>(-reach, reach)(random);
    const auto [cosine, sine] = cosine_sine(angle);
    const double allowed = 2 * unit * std::max(1.0, std::abs(angle));
    ASSERT_NEAR(cosine, std::cos(angle), allowed) << angle;
    ASSERT_NEAR(sine, std::sin(angle), std::min(allowed, 2 * unit * std::abs(angle))) << angle;
    ASSERT_NEAR(cosine * cosine + sine * sine, 1, 4 * unit) << angle;
  }
  EXPECT_EQ(cosine_sine(0), CosineSine{});
  EXPECT_EQ(cosine_sine(std::numeric_limits<double>::infinity()), CosineSine{});
  EXPECT_EQ(cosine_sine(std::numeric_limits<double>::quiet_NaN()), CosineSine{});
}

template <class T>
void angles_are_those_of_the_library(unsigned seed) {
  constexpr T least = std::numeric_limits<T>::epsilon(), pi = std::numbers::pi_v<T>;
  std::mt19937 random(seed);
  for (int round = 0; round < 200000; ++round) {
    const double angle = std::uniform_real_distribution<double>(-std::numbers::pi, std::numbers::pi)(random) *
                         (round % 3 ? 1 : std::pow(10.0, -(round % 12)));
    const double length = std::pow(10.0, round % 7 - 3);
    const T x = static_cast<T>(length * std::cos(angle)), y = static_cast<T>(length * std::sin(angle));
    const T truth = static_cast<T>(std::atan2(static_cast<double>(y), static_cast<double>(x)));
    ASSERT_NEAR(angle_of(x, y), truth, 4 * least * std::abs(truth)) << angle;
  }
  EXPECT_EQ(angle_of(T(1), T(0)), 0);
  EXPECT_EQ(angle_of(T(0), T(0)), 0);
  EXPECT_NEAR(angle_of(T(-1), T(0)), pi, 4 * least);
  EXPECT_NEAR(angle_of(T(0), T(-1)), -pi / 2, 4 * least);
}

TEST(Angles, AnglesAreThoseOfTheLibraryInFloat) { angles_are_those_of_the_library<float>(5); }
TEST(Angles, AnglesAreThoseOfTheLibraryInDouble) { angles_are_those_of_the_library<double>(6); }

}  // namespace
}  // namespace graze
