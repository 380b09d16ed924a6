// Triggers in simulations: they tell what is inside, push nothing, hold nothing back and wake nobody.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "graze/plane/simulation.hpp"
#include "graze/simulation.hpp"

namespace graze::testing {
namespace {

constexpr double trigger_step = 1.0 / 64;

/// A ball of radius 1/2 that falls from a height of 10, through a trigger from 4 to 6 or past where it would be.
template <class T, class Space>
struct FallThroughTrigger {
  explicit FallThroughTrigger(bool with_trigger) : simulation(make_settings()) {
    Body<T, Space> body{ball_shape()};
    body.pose.translation.y = T(10);
    ball = simulation.add(body);
    if (!with_trigger) return;
    Body<T, Space> box{box_shape()};
    box.pose.translation.y = T(5);
    box.trigger = true;
    trigger = simulation.add(box);
  }
  static SimulationSettings<T, Space> make_settings() {
    SimulationSettings<T, Space> settings;
    settings.gravity = {T(0), T(-10)};
    return settings;
  }
  static typename Space::Shape ball_shape();
  static typename Space::Shape box_shape();

  Simulation<T, Space> simulation;
  BodyId ball;
  std::optional<BodyId> trigger;
};
template <>
Shape<double> FallThroughTrigger<double, Space<double>>::ball_shape() {
  return Sphere<double>(0.5);
}
template <>
Shape<double> FallThroughTrigger<double, Space<double>>::box_shape() {
  return Box<double>({4, 2, 4});
}
template <>
plane::Shape<double> FallThroughTrigger<double, plane::Space<double>>::ball_shape() {
  return plane::Circle<double>(0.5);
}
template <>
plane::Shape<double> FallThroughTrigger<double, plane::Space<double>>::box_shape() {
  return plane::Box<double>({4, 2});
}

/// The steps in which the ball is inside are those that the closed form says, and its fall is bit for bit that without.
template <class Space>
void expect_to_fall_through() {
  FallThroughTrigger<double, Space> with(true), without(false);
  std::optional<int> begun, ended;
  for (int i = 0; i < 100; ++i) {
    with.simulation.step(trigger_step);
    without.simulation.step(trigger_step);
    EXPECT_EQ(with.simulation.poses()[with.ball.index].translation,
              without.simulation.poses()[without.ball.index].translation);
    for (const ContactEvent& event : with.simulation.world().events()) {
      EXPECT_TRUE(event.trigger);
      if (event.kind == EventKind::begin) begun = i;
      if (event.kind == EventKind::end) ended = i;
    }
  }
  // A step finds what touches where bodies are when it begins: inside from 6.5 down to 3.5.
  ASSERT_TRUE(begun && ended);
  EXPECT_EQ(*begun, static_cast<int>(std::ceil(std::sqrt(2 * 3.5 / 10) / trigger_step)));
  EXPECT_EQ(*ended, static_cast<int>(std::ceil(std::sqrt(2 * 6.5 / 10) / trigger_step)));
}

TEST(Triggers, TellWhatIsInsideAndPushNothing) { expect_to_fall_through<Space<double>>(); }
TEST(Triggers, TellWhatIsInsideInThePlaneToo) { expect_to_fall_through<plane::Space<double>>(); }

/// One that moves keeps its velocity, and what rests in one sleeps.
TEST(Triggers, MoveByTheirVelocityAndLetSleep) {
  Simulation<double> s({.gravity = {0, -10, 0}});
  Body<double> floor{HalfSpace<double>()};
  floor.fixed = true;
  s.add(floor);
  const BodyId crate = s.add({Box<double>({1, 1, 1}), {{0, 0.5, 0}, {}}});
  Body<double> door{Box<double>({3, 3, 3})};
  door.trigger = true;
  const BodyId resting = s.add(door);
  door.linear = {0, 0, 1};
  const BodyId passing = s.add(door);
  for (int i = 0; i < 3 * 64; ++i) s.step(trigger_step);
  EXPECT_TRUE(s.asleep(crate));
  EXPECT_EQ(s.poses()[resting.index].translation, (Vec3<double>{}));
  EXPECT_NEAR(s.poses()[passing.index].translation.z, 3, 1e-12);
  EXPECT_EQ(s.mass(passing), std::numeric_limits<double>::infinity());
}

/// One with a mass falls through what it meets, by the closed form of positions that are exact under gravity, and a
/// joint holds it at what it belongs to.
TEST(Triggers, MoveByTheirMass) {
  Simulation<double> s({.gravity = {0, -10, 0}});
  Body<double> floor{HalfSpace<double>()};
  floor.fixed = true;
  s.add(floor);
  Body<double> sensor{Box<double>({1, 1, 1}), {{5, 3, 0}, {}}};
  sensor.trigger = true;
  Dynamics<double> heavy;
  heavy.mass = 2;
  const BodyId falling = s.add(sensor, heavy);
  sensor.pose.translation = {0, 1.5, 0};
  const BodyId held = s.add(sensor, heavy), crate = s.add({Box<double>({1, 1, 1}), {{0, 0.5, 0}, {}}});
  s.add(fixed_joint<double>(crate, {{0, 1, 0}, {}}, held, {}));
  EXPECT_EQ(s.mass(falling), 2);
  for (int i = 0; i < 64; ++i) s.step(trigger_step);
  EXPECT_NEAR(s.poses()[falling.index].translation.y, 3 - 5, 1e-12);
  EXPECT_NEAR(s.poses()[held.index].translation.y, 1.5, 1e-3);
  EXPECT_EQ(s.report().stopped, 0u);
}

/// What sleeps in one goes on sleeping where the trigger is put elsewhere or removed.
TEST(Triggers, WakeNobodyWhenTheyAreMovedByHand) {
  Simulation<double> s({.gravity = {0, -10, 0}});
  Body<double> floor{HalfSpace<double>()};
  floor.fixed = true;
  s.add(floor);
  const BodyId crate = s.add({Box<double>({1, 1, 1}), {{0, 0.5, 0}, {}}});
  Body<double> door{Box<double>({3, 3, 3})};
  door.trigger = true;
  const BodyId trigger = s.add(door);
  for (int i = 0; i < 2 * 64; ++i) s.step(trigger_step);
  ASSERT_TRUE(s.asleep(crate));
  s.set_pose(trigger, {{0.5, 0, 0}, {}});
  EXPECT_TRUE(s.asleep(crate));
  s.step(trigger_step);
  s.remove(trigger);
  EXPECT_TRUE(s.asleep(crate));
}

/// What is fast enough to pass one within a step is not held back by it.
TEST(Triggers, HoldNothingBack) {
  Simulation<double> s({.gravity = {}});
  Body<double> wall{Box<double>({0.01, 4, 4}), {{1, 0, 0}, {}}};
  wall.trigger = true;
  s.add(wall);
  const BodyId bullet = s.add({Sphere<double>(0.1), {}, {300, 0, 0}});
  s.step(trigger_step);
  EXPECT_NEAR(s.poses()[bullet.index].translation.x, 300 * trigger_step, 1e-12);
  EXPECT_EQ(s.report().stopped, 0u);
}

}  // namespace
}  // namespace graze::testing
