// Joints in a whole simulation: what swings keeps its energy and its frames together.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/simulation.hpp"

namespace graze {
namespace {

constexpr double gravity = 9.81;

/// A box of 1 m that swings on a fixed one, held 1 m above its centre by a joint that turns about `axis`, or about all
/// three, from the horizontal.
struct Swing {
  Simulation<double> simulation{SimulationSettings<double>{{0, -gravity, 0}}};
  Pose<double> frame_a, frame_b;
  BodyId bob;

  explicit Swing(std::optional<std::size_t> axis) {
    Body<double> hook{Shape<double>(Box<double>({0.2, 0.2, 0.2})), {}};
    hook.fixed = true;
    const BodyId a = simulation.add(hook);
    // Hinges turn about the x axis of their frames.
    const double s = std::sqrt(0.5);
    const Quatd turn = !axis || *axis == 0 ? Quatd{} : *axis == 1 ? Quatd{0, 0, s, s} : Quatd{0, -s, 0, s};
    const Vec3d arm = axis && *axis == 0 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
    frame_a = {{0, 0, 0}, turn};
    frame_b = {-arm, turn};
    bob = simulation.add(Body<double>{Shape<double>(Box<double>({1, 1, 1})), {arm, {}}});
    simulation.add(axis ? hinge_joint(a, frame_a, bob, frame_b) : ball_joint(a, frame_a, bob, frame_b));
  }
  double energy() const {
    const Motion<double> m = simulation.motion(bob);
    // Of a cube of 1 m with a density of 1000: m / 6.
    return 0.5 * 1000 * length_squared(m.linear) + 0.5 * (1000.0 / 6) * length_squared(m.angular) +
           1000 * gravity * simulation.poses()[1].translation.y;
  }
  /// How far the frames are apart.
  double gap() const { return length(transform(simulation.poses()[1], frame_b.translation) - frame_a.translation); }
};

/// Within a hundredth of what it has at the lowest point, for ten seconds.
void expect_to_swing(std::optional<std::size_t> axis) {
  Swing swing(axis);
  double lowest = 0;
  for (int i = 0; i < 600; ++i) {
    swing.simulation.step(1.0 / 60);
    ASSERT_NEAR(swing.energy(), 0, 0.01 * 1000 * gravity) << i;
    ASSERT_LT(swing.gap(), 1e-3) << i;
    lowest = std::min(lowest, swing.simulation.poses()[1].translation.y);
  }
  EXPECT_LT(lowest, -0.99);
}

TEST(JoinedBodies, ABallJointSwings) { expect_to_swing(std::nullopt); }
TEST(JoinedBodies, AHingeAboutXSwings) { expect_to_swing(0); }
TEST(JoinedBodies, AHingeAboutZSwings) { expect_to_swing(2); }

/// A drive goes to a target within the bounds of its axis the way that the bounds leave, though it be the longer one.
TEST(JoinedBodies, ADriveStaysWithinTheBounds) {
  Simulation<double> s(SimulationSettings<double>{});
  Body<double> post{Sphere<double>(0.1), {}};
  post.fixed = true;
  post.filter = Filter{0, 0, 0};
  const BodyId a = s.add(post);
  Dynamics<double> light;
  light.gravity_factor = 0;
  Body<double> arm{Box<double>({1, 0.1, 0.1}), {{}, Quatd::from_axis_angle({1, 0, 0}, -3)}};
  arm.filter = post.filter;
  const BodyId b = s.add(arm, light);
  Joint<double> hinge = hinge_joint<double>(a, {}, b, {});
  hinge.limits.push_back({JointSpace::angular, {true, false, false}, -3.05, 3.05, {}, 0});
  hinge.drives.push_back({JointSpace::angular, DriveMode::acceleration, 0, 3, 0, 20, 9});
  s.add(hinge);
  for (int i = 0; i < 600; ++i) s.step(1.0 / 60);
  const Quatd at = s.poses()[b.index].rotation;
  EXPECT_NEAR(2 * std::atan2(at.x, at.w), 3, 0.01);
}

/// Two thin links on a hinge that fold at `rate`, in free space or onto a floor: energy never grows. A joint that
/// pushed by the inertia of the step's beginning, or along rows of frames that agree, took its own error for more.
void expect_links_to_gain_nothing(double rate, bool falls) {
  Simulation<double> s(SimulationSettings<double>{{0, falls ? -gravity : 0, 0}});
  Body<double> floor{HalfSpace<double>()};
  floor.fixed = true;
  if (falls) s.add(floor);
  const Vec3d size{0.04, 0.24, 0.04}, up{0, size.y / 2, 0}, spin_a{rate / 2, 0, 0}, spin_b{-rate / 2, 0.1, 0.1};
  const Quatd tilt = falls ? normalized(Quatd{0.3, 0.4, 0.2, 0.8}) : Quatd{};
  const Vec3d low{0, falls ? 6.0 : 0.0, 0}, arm = rotate(tilt, up);
  Body<double> links[2] = {{Box<double>(size), {low, tilt}}, {Box<double>(size), {low + arm * 2, tilt}}};
  links[0].angular = rotate(tilt, spin_a);
  links[1].angular = rotate(tilt, spin_b);
  links[1].linear = cross(links[0].angular, arm) + cross(links[1].angular, arm);
  const BodyId a = s.add(links[0]), b = s.add(links[1]);
  s.add(hinge_joint<double>(a, {up, {}}, b, {-up, {}}));
  const double mass = 1000 * size.x * size.y * size.z, along = mass / 6 * size.x * size.x,
               across = mass / 12 * (size.x * size.x + size.y * size.y);
  const auto energy = [&] {
    double sum = 0;
    for (const BodyId id : {a, b}) {
      const Motion<double> m = s.motion(id);
      const Pose<double> pose = s.poses()[id.index];
      const Vec3d own = rotate(conjugate(pose.rotation), m.angular);
      sum += mass / 2 * length_squared(m.linear) + (falls ? mass * gravity * pose.translation.y : 0);
      sum += (across * own.x * own.x + along * own.y * own.y + across * own.z * own.z) / 2;
    }
    return sum;
  };
  const double first = energy();
  for (int i = 0; i < 600; ++i) {
    s.step(1.0 / 60);
    ASSERT_LT(energy(), first * 1.001) << i;
    const Vec3d hinge_a = rotate(s.poses()[a.index].rotation, Vec3d{1, 0, 0}),
                hinge_b = rotate(s.poses()[b.index].rotation, Vec3d{1, 0, 0});
    ASSERT_LT(length(hinge_a - hinge_b), falls ? 0.1 : 0.001) << i;
  }
  EXPECT_GT(energy(), falls ? 0 : first * 0.7);
}

TEST(JoinedBodies, LinksThatFoldGainNothing) {
  for (const double rate : {20.0, 50.0, 60.0, 100.0}) expect_links_to_gain_nothing(rate, false);
  for (const double rate : {0.0, 10.0}) expect_links_to_gain_nothing(rate, true);
}

/// A door with a range of 270 degrees stays where it is within it, and stops at its end.
TEST(JoinedBodies, ADoorOpensByMoreThanHalfATurn) {
  for (const double most : {3.2, 4.0, 4.7, 6.0}) {
    SimulationSettings<double> settings;
    settings.gravity = {};
    Simulation<double> s(settings);
    Body<double> wall{Shape<double>(Box<double>({0.2, 0.2, 0.2})), {{0, -10, 0}, {}}};
    wall.fixed = true;
    const BodyId a = s.add(wall), b = s.add(Body<double>{Shape<double>(Box<double>({1, 1, 1})), {}});
    Joint<double> joint = hinge_joint(a, Pose<double>{{0, 10, 0}, {}}, b, Pose<double>{});
    joint.limits.push_back({JointSpace::angular, {true, false, false}, 0, most, {}, 0});
    s.add(joint);
    for (int i = 0; i < 10; ++i) s.step(1.0 / 60);
    EXPECT_EQ(length(s.motion(b).angular), 0) << most;
    s.set_velocity(b, {{}, {2, 0, 0}});
    double turned = 0, furthest = 0;
    for (int i = 0; i < 300; ++i) {
      s.step(1.0 / 60);
      furthest = std::max(furthest, turned += s.motion(b).angular.x / 60);
    }
    EXPECT_NEAR(furthest, most, 0.05) << most;
  }
}

/// What holds a hanging body up in a step is its weight, in however many sub-steps.
TEST(JoinedBodies, ImpulsesAreThoseOfAWholeStep) {
  for (const int sub_steps : {1, 4, 16}) {
    SimulationSettings<double> settings{{0, -gravity, 0}};
    settings.sub_steps = sub_steps;
    Simulation<double> s(settings);
    Body<double> hook{Shape<double>(Box<double>({0.2, 0.2, 0.2})), {{0, -10, 0}, {}}};
    hook.fixed = true;
    const BodyId a = s.add(hook), b = s.add(Body<double>{Shape<double>(Box<double>({1, 1, 1})), {}});
    const JointId joint = s.add(ball_joint(a, Pose<double>{{0, 10, 0}, {}}, b, Pose<double>{}));
    for (int i = 0; i < 60; ++i) s.step(1.0 / 60);
    EXPECT_NEAR(s.joint_impulses(joint)[1], s.mass(b) * gravity / 60, 1e-6 * s.mass(b)) << sub_steps;
  }
}

}  // namespace
}  // namespace graze
