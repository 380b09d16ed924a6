// Bodies that fall and turn freely: against closed forms, and against Euler's equations in tiny steps.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "graze/free_motion.hpp"

namespace graze::testing {
namespace {

template <class T>
class FreeMotion : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(FreeMotion, Scalars);

/// The book of the benchmark: spins about its middle axis, a thousandth beside it.
template <class T>
FreeBody<T> book(T rate) {
  FreeBody<T> body;
  body.inverse_inertia = {T(1) / T(0.417), T(1) / T(0.337), T(1) / T(0.087)};
  set_angular_velocity(body, Vec3<T>{rate / T(1000), rate, T(0)});
  return body;
}

TYPED_TEST(FreeMotion, AFallIsTheParabola) {
  using T = TypeParam;
  FreeBody<T> body;
  body.linear = {3, 4, 0};
  for (int i = 0; i < 120; ++i) advance(body, Vec3<T>{0, -10, 0}, T(1) / T(60));
  const T rounding = T(120) * std::numeric_limits<T>::epsilon() * T(20);
  EXPECT_NEAR(body.center.x, 6, rounding);
  EXPECT_NEAR(body.center.y, 8 - 20, rounding);
  EXPECT_NEAR(body.linear.y, 4 - 20, rounding);
}

TYPED_TEST(FreeMotion, AngularMomentumStaysBitForBitAndEnergyNearly) {
  using T = TypeParam;
  for (const T rate : {T(10), T(30)}) {
    FreeBody<T> body = book(rate);
    const Vec3<T> momentum = body.angular_momentum;
    const T energy = rotational_energy(body);
    double worst = 0;
    for (int i = 0; i < 1200; ++i) {
      advance(body, Vec3<T>{}, T(1) / T(60));
      worst = std::max(worst, std::abs(static_cast<double>(rotational_energy(body) / energy) - 1));
    }
    EXPECT_EQ(body.angular_momentum, momentum);
    EXPECT_LE(worst, sizeof(T) == sizeof(float) ? 1e-5 : 1e-7) << rate;
  }
}

/// Euler's equations I w' = I w × w in the body's frame, by tiny steps: the velocity about the middle axis after each
/// sixtieth of a second.
std::vector<double> middle_rates(double rate) {
  const Vec3d inertia{0.417, 0.337, 0.087};
  const auto slope = [&](const Vec3d& w) {
    const Vec3d torque = cross(scaled(inertia, w), w);
    return Vec3d{torque.x / inertia.x, torque.y / inertia.y, torque.z / inertia.z};
  };
  Vec3d w{rate / 1000, rate, 0};
  std::vector<double> rates;
  const double h = 1.0 / 60 / 100;
  for (int i = 0; i < 120000; ++i) {
    const Vec3d k1 = slope(w), k2 = slope(w + k1 * (h / 2)), k3 = slope(w + k2 * (h / 2)), k4 = slope(w + k3 * h);
    w += (k1 + (k2 + k3) * 2.0 + k4) * (h / 6);
    if (i % 100 == 99) rates.push_back(w.y);
  }
  return rates;
}

int flips(const std::vector<double>& rates) {
  int count = 0;
  for (std::size_t i = 1; i < rates.size(); ++i) count += (rates[i] > 0) != (rates[i - 1] > 0);
  return count;
}

TEST(FreeMotion, ABookFlipsAsOftenAsEulersEquationsSay) {
  const std::vector<double> right = middle_rates(10);
  FreeBody<double> body = book(10.0);
  std::vector<double> rates;
  for (int i = 0; i < 1200; ++i) {
    advance(body, Vec3d{}, 1.0 / 60);
    rates.push_back(rotate(conjugate(body.rotation), angular_velocity(body)).y);
  }
  EXPECT_GT(flips(right), 3);
  EXPECT_EQ(flips(rates), flips(right));
  // Each flip begins near where it could go either way, and makes the difference in time a little larger.
  for (std::size_t i = 0; i < 300; ++i) EXPECT_NEAR(rates[i], right[i], 0.05) << i;
}

// A symmetric top of inertias A, A, C: its axis goes round the angular momentum at |L| / A.
TEST(FreeMotion, ASymmetricTopPrecesses) {
  const double across = 2, along = 3;
  FreeBody<double> top;
  top.inverse_inertia = {1 / across, 1 / across, 1 / along};
  top.angular_momentum = {0, 4, 3};
  const double rate = 5 / across;
  const auto error_after = [&](int steps) {
    FreeBody<double> body = top;
    for (int i = 0; i < steps; ++i) advance(body, Vec3d{}, 2.0 / steps);
    const Quatd round = Quatd::from_axis_angle({0, 0.8, 0.6}, 2 * rate);
    return length(rotate(body.rotation, Vec3d{0, 0, 1}) - rotate(round, Vec3d{0, 0, 1}));
  };
  EXPECT_LT(error_after(120), 1e-7);
  // Of fourth order: half the step has a sixteenth of the error.
  EXPECT_NEAR(error_after(60) / error_after(120), 16, 2);
}

TEST(FreeMotion, ABodyThatDoesNotTurnStays) {
  FreeBody<double> body;
  set_angular_velocity(body, Vec3d{1, 2, 3});
  EXPECT_EQ(body.angular_momentum, Vec3d{});
  body.angular_momentum = {1, 2, 3};
  advance(body, Vec3d{}, 1.0);
  EXPECT_EQ(body.rotation, Quatd{});
}

TEST(FreeMotion, WhatTurnsTooFastStaysAUnitQuaternion) {
  FreeBody<double> body = book(1e9);
  const Vec3d momentum = body.angular_momentum;
  for (int i = 0; i < 100; ++i) advance(body, Vec3d{}, 1.0 / 60);
  const Quatd& q = body.rotation;
  EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1, 1e-15);
  EXPECT_EQ(body.angular_momentum, momentum);
}

}  // namespace
}  // namespace graze::testing
