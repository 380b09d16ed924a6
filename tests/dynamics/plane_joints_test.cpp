// Joints between bodies of the plane against closed forms: a pendulum, a spring, a slider, a rope, a beam.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/plane/simulation.hpp"

namespace graze::plane {
namespace {

using At = Pose2<double>;

constexpr double joint_step = 1.0 / 120;

/// A world with a hook that does not move.
struct Hooked {
  Simulation<double> simulation;
  BodyId hook;

  explicit Hooked(double gravity = 10) : simulation(without_sleep(gravity)) {
    Body<double> body{Box<double>({0.2, 0.2})};
    body.fixed = true;
    hook = simulation.add(body);
  }
  static SimulationSettings<double> without_sleep(double gravity) {
    SimulationSettings<double> s;
    s.gravity = {0, -gravity};
    s.sleep = false;
    return s;
  }
  Pose2<double> pose(BodyId id) const { return simulation.poses()[id.index]; }
  void run(double seconds) {
    for (int i = 0; i < std::lround(seconds / joint_step); ++i) simulation.step(joint_step);
  }
};

/// A rod of length l that hangs from its end swings, from a small angle, with the period 2 pi sqrt(2 l / 3 g).
TEST(PlaneJoints, AHingedRodSwingsAsAPendulum) {
  Hooked h;
  const double length = 1.5, angle = 0.05;
  const Rot2<double> lean = Rot2<double>::from_angle(angle);
  const Vec2d end{0, length / 2};
  const BodyId rod = h.simulation.add({Box<double>({0.01, length}), {-rotate(lean, end), lean}});
  h.simulation.add(hinge_joint(h.hook, At{}, rod, At{end, {}}));
  const double period = 2 * std::numbers::pi * std::sqrt(2 * length / 30);
  int crossings = 0;
  double last = angle, first_time = 0, last_time = 0;
  for (int i = 1; i <= 1200; ++i) {
    h.simulation.step(joint_step);
    const double now = h.pose(rod).rotation.sine;
    if (last > 0 && now <= 0) {
      last_time = (i - 1 + last / (last - now)) * joint_step;
      if (crossings++ == 0) first_time = last_time;
    }
    last = now;
    ASSERT_LT(graze::plane::length(transform(h.pose(rod), end)), 1e-4 * length) << i;
  }
  ASSERT_GE(crossings, 4);
  EXPECT_NEAR((last_time - first_time) / (crossings - 1), period, 2e-3 * period);
}

/// A drive is a spring: what it bears rests m g / k below.
TEST(PlaneJoints, ADriveRestsWhereItsSpringBearsTheWeight) {
  Hooked h;
  const BodyId weight = h.simulation.add({Circle<double>(0.25), {}});
  const At down{{}, Rot2<double>::from_angle(-std::numbers::pi / 2)};
  Joint<double> joint = slider_joint(h.hook, down, weight, down);
  const double mass = 1000 * std::numbers::pi / 16, stiffness = 40 * mass, damping = 10 * mass;
  joint.drives.push_back({JointSpace::linear, DriveMode::force, 0, 0, 0, stiffness, damping});
  h.simulation.add(joint);
  h.run(6);
  EXPECT_NEAR(h.pose(weight).translation.y, -10.0 / 40, 1e-6);
  EXPECT_NEAR(h.pose(weight).translation.x, 0, 1e-9);
}

TEST(PlaneJoints, ASliderStopsAtItsEnd) {
  Hooked h;
  const Rot2<double> slope = Rot2<double>::from_angle(-0.5);
  const BodyId car = h.simulation.add({Box<double>({0.4, 0.2}), {{}, slope}});
  h.simulation.add(slider_joint(h.hook, At{{}, slope}, car, At{}, -1.0, 2.0));
  h.run(0.5);
  const Vec2d along = rotate(slope, Vec2d{1, 0});
  EXPECT_NEAR(dot(h.pose(car).translation, along), 0.5 * 10 * std::sin(0.5) * 0.25, 0.02);  // g sin t^2 / 2
  h.run(3);
  EXPECT_NEAR(dot(h.pose(car).translation, along), 2, 1e-3);
  EXPECT_NEAR(dot(h.pose(car).translation, left(along)), 0, 1e-4);
  EXPECT_NEAR(h.pose(car).rotation.sine, slope.sine, 1e-4);
}

TEST(PlaneJoints, ARopeIsNeverLonger) {
  Hooked h;
  const BodyId ball = h.simulation.add({Circle<double>(0.1), {{0.5, 0}, {}}});
  h.simulation.add(distance_joint(h.hook, At{}, ball, At{}, 0.0, 1.0));
  double longest = 0;
  for (int i = 0; i < 600; ++i) {
    h.simulation.step(joint_step);
    longest = std::max(longest, graze::plane::length(h.pose(ball).translation));
  }
  EXPECT_LT(longest, 1.01);
  EXPECT_GT(longest, 0.99);
}

/// Five blocks in a row on a wall.
TEST(PlaneJoints, FixedJointsHoldABeam) {
  Hooked h;
  BodyId last = h.hook;
  for (int i = 0; i < 5; ++i) {
    const BodyId block = h.simulation.add({Box<double>({0.2, 0.2}), {{0.2 * (i + 1), 0}, {}}});
    h.simulation.add(fixed_joint(last, At{{0.1, 0}, {}}, block, At{{-0.1, 0}, {}}));
    last = block;
  }
  h.run(5);
  EXPECT_NEAR(h.pose(last).translation.x, 1, 1e-4);
  EXPECT_NEAR(h.pose(last).translation.y, 0, 1e-4);
}

/// Two bodies that only a joint moves keep their momentum and angular momentum.
TEST(PlaneJoints, MomentumStays) {
  Hooked h(0);
  const BodyId a = h.simulation.add({Box<double>({1, 0.5}), {{-0.5, 3}, {}}, {1, 2}, 3.0});
  const BodyId b = h.simulation.add({Box<double>({1, 1}), {{0.5, 3}, {}}, {-0.5, 0}, -1.0});
  h.simulation.add(hinge_joint(a, At{{0.5, 0}, {}}, b, At{{-0.5, 0}, {}}));
  const auto before = h.simulation.report();
  h.run(4);
  const auto after = h.simulation.report();
  EXPECT_LT(graze::plane::length(after.momentum - before.momentum), 1e-9 * graze::plane::length(before.momentum));
  EXPECT_NEAR(after.angular_momentum, before.angular_momentum, 1e-3 * std::abs(before.angular_momentum) + 1e-3);
}

TEST(PlaneJoints, WhatThePlaneDoesNotHaveIsRefused) {
  Hooked h;
  const BodyId ball = h.simulation.add({Circle<double>(0.1), {{0.5, 0}, {}}});
  Joint<double> joint = hinge_joint(h.hook, At{}, ball, At{});
  joint.limits[0].axes = {true, true, true};
  EXPECT_THROW(h.simulation.add(joint), std::invalid_argument);
  joint.limits[0] = {JointSpace::angular, {true, false, false}};
  EXPECT_THROW(h.simulation.add(joint), std::invalid_argument);
  EXPECT_NO_THROW(h.simulation.add(hinge_joint(h.hook, At{}, ball, At{})));
}

}  // namespace
}  // namespace graze::plane
