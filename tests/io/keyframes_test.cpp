// Keyframes against values computed by hand from glTF 2.0, appendix C.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "graze/geometry.hpp"
#include "io/keyframes.hpp"

namespace graze::io {
namespace {

Keyframes keys(Interpolation interpolation, std::vector<float> times, std::vector<float> values) {
  return {interpolation, std::make_shared<const std::vector<float>>(std::move(times)),
          std::make_shared<const std::vector<float>>(std::move(values))};
}

void expect_near(const Vec3d& a, const Vec3d& b) { EXPECT_LE(length(a - b), 1e-12) << a.x << ' ' << a.y << ' ' << a.z; }

double turned_by(const Quatd& q) { return 2 * std::atan2(length(q.vector()), std::abs(q.w)); }

TEST(Keyframes, StepHoldsUntilTheNextKey) {
  const Keyframes k = keys(Interpolation::step, {1, 2, 4}, {0, 0, 0, 1, 2, 3, -1, 0, 0});
  EXPECT_EQ(k.vector(0), (Vec3d{0, 0, 0}));  // before the first as at the first
  EXPECT_EQ(k.vector(1.999), (Vec3d{0, 0, 0}));
  EXPECT_EQ(k.vector(2), (Vec3d{1, 2, 3}));
  EXPECT_EQ(k.vector(3.5), (Vec3d{1, 2, 3}));
  EXPECT_EQ(k.vector(4), (Vec3d{-1, 0, 0}));
  EXPECT_EQ(k.vector(1e300), (Vec3d{-1, 0, 0}));
  EXPECT_EQ(k.duration(), 4);
}

TEST(Keyframes, LinearGoesStraight) {
  const Keyframes k = keys(Interpolation::linear, {1, 2, 4}, {0, 0, 0, 1, 2, 3, -1, 0, 5});
  expect_near(k.vector(0.5), {0, 0, 0});
  expect_near(k.vector(1.25), {0.25, 0.5, 0.75});
  expect_near(k.vector(3), {0, 1, 4});
  expect_near(k.vector(3.5), {-0.5, 0.5, 4.5});
  expect_near(k.vector(9), {-1, 0, 5});
}

// At half of an interval of d seconds the spline is (a + b) / 2 + d (m - n) / 8, with m the tangent away from a and n
// that towards b; at a quarter 27/32 a + 5/32 b + d (9 m - 3 n) / 64.
TEST(Keyframes, CubicSplineByHand) {
  const Keyframes k =
      keys(Interpolation::cubic_spline, {1, 3}, {9, 9, 9, 1, 0, 2, 4, 0, 0, /* key 2: */ 8, 0, -4, 3, 0, 4, 9, 9, 9});
  expect_near(k.vector(1), {1, 0, 2});
  expect_near(k.vector(2), {2.0 + 2 * (4 - 8) / 8.0, 0, 3 + 2 * (0 + 4) / 8.0});
  expect_near(k.vector(1.5),
              {27 / 32.0 + 15 / 32.0 + 2 * (9 * 4 - 3 * 8) / 64.0, 0, 54 / 32.0 + 20 / 32.0 + 2 * 12 / 64.0});
  expect_near(k.vector(3), {3, 0, 4});
  expect_near(k.vector(7), {3, 0, 4});
}

// A spline through x = t^3 with its true tangents is t^3.
RC_GTEST_PROP(KeyframesProperties, CubicSplineIsExactForACubic, ()) {
  const double part = *rc::gen::inRange(0, 1001) / 1000.0, t = 1 + 2 * part;
  const Keyframes k =
      keys(Interpolation::cubic_spline, {1, 3}, {0, 0, 0, 1, -1, 2, 3, -3, 6, 27, -27, 54, 27, -27, 54, 0, 0, 0});
  const Vec3d v = k.vector(t);
  RC_ASSERT(std::abs(v.x - t * t * t) <= 1e-13 * 27);
  RC_ASSERT(std::abs(v.z - 2 * t * t * t) <= 1e-13 * 54);
}

TEST(Keyframes, RotationsTurnTheShorterWayAtConstantSpeed) {
  const auto h = static_cast<float>(std::sqrt(0.5));
  // A quarter turn about z, its end written with the other sign and twice as long.
  const Keyframes k = keys(Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, -2 * h, -2 * h});
  for (const double t : {0.0, 0.1, 1 / 3.0, 0.5, 0.9, 1.0}) {
    const Quatd q = k.rotation(t);
    expect_near(rotate(q, Vec3d{1, 0, 0}), {std::cos(t * M_PI / 2), std::sin(t * M_PI / 2), 0});
  }
}

// A turn of a micro-radian and one of next to half of the circle keep their digits.
RC_GTEST_PROP(KeyframesProperties, SlerpTurnsInProportion, ()) {
  const double angle = *rc::gen::element(1e-6, 1e-3, 0.5, 2.0, 3.1415), t = *rc::gen::inRange(0, 101) / 100.0;
  const auto s = static_cast<float>(std::sin(angle / 2)), c = static_cast<float>(std::cos(angle / 2));
  const double whole = 2 * std::atan2(static_cast<double>(s), static_cast<double>(c));
  const Keyframes k = keys(Interpolation::linear, {0, 1}, {0, 0, 0, 1, s, 0, 0, c});
  RC_ASSERT(std::abs(turned_by(k.rotation(t)) - t * whole) <= 1e-15 + 1e-14 * whole);
}

TEST(Keyframes, RotationsThatDoNotChangeOrStepOrSpline) {
  const Keyframes still = keys(Interpolation::linear, {0, 1}, {0, 1, 0, 0, 0, -1, 0, 0});
  EXPECT_EQ(still.rotation(0.5), (Quatd{0, 1, 0, 0}));
  const Keyframes step = keys(Interpolation::step, {0, 1}, {0, 1, 0, 0, 0, 0, 0, 3});
  EXPECT_EQ(step.rotation(0.9), (Quatd{0, 1, 0, 0}));
  EXPECT_EQ(step.rotation(1), (Quatd{0, 0, 0, 1}));
  // Without tangents the spline is the mean of its keys in the middle, turned to unit length: an eighth of a turn.
  const auto h = static_cast<float>(std::sqrt(0.5));
  const Keyframes spline = keys(Interpolation::cubic_spline, {0, 1},
                                {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, h, h, 0, 0, 0, 0});
  EXPECT_NEAR(turned_by(spline.rotation(0.5)), M_PI / 4, 1e-7);
  // Through zero: the nearer key.
  const Keyframes through = keys(Interpolation::cubic_spline, {0, 1},
                                 {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0});
  EXPECT_EQ(through.rotation(0.5), (Quatd{0, 0, 0, -1}));
}

}  // namespace
}  // namespace graze::io
