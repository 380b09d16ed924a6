// Joints and filters that are set while a simulation runs.
#include <gtest/gtest.h>

#include <string>

#include "dynamics/simulated.hpp"
#include "graze/plane/simulation.hpp"

namespace graze::testing {
namespace {

/// A wheel on a motor beside a post, without gravity.
template <class T>
struct Motor {
  Simulation<T> s{settings<T>(T(0))};
  BodyId post, wheel;
  JointId joint;

  Motor() {
    Body<T> fixed{Box<T>({T(1), T(1), T(1)}), {{T(-2), T(0), T(0)}, {}}};
    fixed.fixed = true;
    post = s.add(fixed);
    wheel = s.add({Cylinder<T>(T(0.2), T(0.5)), {}});
    joint = s.add(turning_at(T(1)));
  }
  Joint<T> turning_at(T speed) const {
    Joint<T> hinge = hinge_joint<T>(post, {{T(2), T(0), T(0)}, {}}, wheel, {});
    hinge.drives.push_back({JointSpace::angular, DriveMode::acceleration, 0, T(0), speed, T(0), T(50)});
    return hinge;
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) s.step(static_cast<T>(dt));
  }
  double speed() const { return static_cast<double>(s.motion(wheel).angular.x); }
};

template <class T>
class ChangedJoints : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ChangedJoints, Scalars);

TYPED_TEST(ChangedJoints, AMotorFollowsItsTarget) {
  using T = TypeParam;
  Motor<T> m;
  m.run(60);
  EXPECT_NEAR(m.speed(), 1, 1e-3);
  m.s.set_joint(m.joint, m.turning_at(T(-2)));
  EXPECT_EQ(m.s.joint(m.joint), m.turning_at(T(-2)));
  m.run(60);
  EXPECT_NEAR(m.speed(), -2, 1e-3);
}

TYPED_TEST(ChangedJoints, SleepersWake) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(10), true));
  Body<T> ground{HalfSpace<T>()};
  ground.fixed = true;
  const BodyId floor = s.add(ground);
  const BodyId box = s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(0.5), T(0)}, {}}});
  const JointId slider = s.add(slider_joint<T>(floor, {{T(0), T(0.5), T(0)}, {}}, box, {}, T(0), T(0)));
  for (int i = 0; i < 300; ++i) s.step(static_cast<T>(dt));
  ASSERT_TRUE(s.asleep(box));
  Joint<T> moved = slider_joint<T>(floor, {{T(0), T(0.5), T(0)}, {}}, box, {}, T(0), T(2));
  moved.drives.push_back({JointSpace::linear, DriveMode::acceleration, 0, T(1), T(0), T(100), T(20)});
  s.set_joint(slider, moved);
  EXPECT_FALSE(s.asleep(box));
  for (int i = 0; i < 300; ++i) s.step(static_cast<T>(dt));
  EXPECT_NEAR(static_cast<double>(s.poses()[box.index].translation.x), 1, 0.08);  // friction holds a part
}

/// A state holds what joints were; a run from it has the same bits, whatever they are set to in between.
TYPED_TEST(ChangedJoints, GoBackWithTheState) {
  using T = TypeParam;
  Motor<T> m;
  m.run(10);
  const State<T> before = m.s.save();
  const std::uint64_t at = m.s.state_hash();
  m.run(30);
  const std::uint64_t end = m.s.state_hash();
  Joint<T> other = m.turning_at(T(-2));
  other.enable_collision = true;
  m.s.set_joint(m.joint, other);
  EXPECT_NE(m.s.state_hash(), end);
  m.run(30);
  m.s.restore(before);
  EXPECT_EQ(m.s.state_hash(), at);
  EXPECT_EQ(m.s.joint(m.joint), m.turning_at(T(1)));
  m.run(30);
  EXPECT_EQ(m.s.state_hash(), end);
}

TYPED_TEST(ChangedJoints, KeepTheirBodies) {
  using T = TypeParam;
  Motor<T> m;
  const BodyId other = m.s.add({Sphere<T>(T(1)), {{T(9), T(0), T(0)}, {}}});
  const std::uint64_t before = m.s.state_hash();
  const auto refused = [&](const Joint<T>& joint) -> std::string {
    try {
      m.s.set_joint(m.joint, joint);
    } catch (const InvalidValue& e) {
      return e.what();
    }
    return "taken";
  };
  Joint<T> joint = m.turning_at(T(1));
  joint.b = other;
  EXPECT_EQ(refused(joint), "b: expected body 1, which the joint has, got 2");
  joint = m.turning_at(T(1));
  joint.drives[0].damping = T(-1);
  EXPECT_NE(refused(joint).find("damping"), std::string::npos);
  m.s.remove(m.joint);
  EXPECT_NE(refused(m.turning_at(T(1))).find("joint"), std::string::npos);
  EXPECT_NE(m.s.state_hash(), before);
}

/// Two bodies that a joint kept from touching touch once it lets them.
TYPED_TEST(ChangedJoints, LetBodiesCollide) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(0)));
  const BodyId a = s.add({Sphere<T>(T(1)), {}}), b = s.add({Sphere<T>(T(1)), {{T(1), T(0), T(0)}, {}}});
  Joint<T> rope = distance_joint<T>(a, {}, b, {}, T(0), T(5));
  const JointId id = s.add(rope);
  s.step(static_cast<T>(dt));
  EXPECT_EQ(s.world().contacts().pairs.size(), 0u);
  rope.enable_collision = true;
  s.set_joint(id, rope);
  s.step(static_cast<T>(dt));
  EXPECT_EQ(s.world().contacts().pairs.size(), 1u);
}

TYPED_TEST(ChangedJoints, AFilterLetsSleepersFall) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(10), true));
  Body<T> ground{Box<T>({T(9), T(1), T(9)}), {{T(0), T(-0.5), T(0)}, {}}};
  ground.fixed = true;
  s.add(ground);
  const BodyId box = s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(0.5), T(0)}, {}}});
  for (int i = 0; i < 300; ++i) s.step(static_cast<T>(dt));
  ASSERT_TRUE(s.asleep(box));
  s.set_filter(box, {.category = 2, .mask = 2});
  for (int i = 0; i < 60; ++i) s.step(static_cast<T>(dt));
  EXPECT_LT(s.poses()[box.index].translation.y, T(-3));
}

/// The plane's simulation is the same class.
TEST(ChangedJointsOfThePlane, AMotorFollowsItsTarget) {
  plane::SimulationSettings<double> free;
  free.gravity = {};
  plane::Simulation<double> s(free);
  plane::Body<double> fixed{plane::Box<double>({1, 1}), {{-2, 0}, {}}};
  fixed.fixed = true;
  const BodyId post = s.add(fixed), wheel = s.add({plane::Circle<double>(0.5), {}});
  const auto turning_at = [&](double speed) {
    plane::Joint<double> hinge = plane::hinge_joint<double>(post, {{2, 0}, {}}, wheel, {});
    hinge.drives.push_back({JointSpace::angular, DriveMode::acceleration, 2, 0, speed, 0, 50});
    return hinge;
  };
  const JointId joint = s.add(turning_at(1));
  for (int i = 0; i < 60; ++i) s.step(dt);
  EXPECT_NEAR(s.motion(wheel).angular, 1, 1e-3);
  s.set_joint(joint, turning_at(-2));
  for (int i = 0; i < 60; ++i) s.step(dt);
  EXPECT_NEAR(s.motion(wheel).angular, -2, 1e-3);
}

}  // namespace
}  // namespace graze::testing
