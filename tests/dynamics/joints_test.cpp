// Joints by themselves, in a loop of sub-steps without contacts: against closed forms and laws of conservation.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "dynamics/joint_system.hpp"
#include "graze/free_motion.hpp"

namespace graze::joints_test {
namespace {

constexpr double gravity = 9.81, infinity = std::numeric_limits<double>::infinity();

/// Bodies and joints, moved as an island moves them.
struct Chain {
  std::vector<SolverBody<double>> bodies;
  std::vector<FreeBody<double>> free;  ///< for what inertia does to the turning
  std::vector<double> masses;
  std::vector<JointInPlace<double>> joints;
  Vec3d acceleration{0, -gravity, 0};
  int sub_steps = 4;
  double dt = 1.0 / 60, time = 0;

  /// A mass of 0 is the world.
  std::size_t add(double mass, const Vec3d& inertia, const Pose<double>& pose) {
    SolverBody<double> body;
    body.center = pose.translation;
    body.rotation = pose.rotation;
    if (mass > 0) body.mass = inverse_mass(mass, inertia, pose.rotation);
    FreeBody<double> f;
    f.rotation = pose.rotation;
    f.inverse_inertia = mass > 0 ? Vec3d{1 / inertia.x, 1 / inertia.y, 1 / inertia.z} : Vec3d{};
    bodies.push_back(body);
    free.push_back(f);
    masses.push_back(mass);
    return bodies.size() - 1;
  }
  void join(std::size_t a, const Pose<double>& frame_a, std::size_t b, const Pose<double>& frame_b,
            Joint<double> joint) {
    check(joint);
    JointInPlace<double> in_place;
    in_place.joint = std::move(joint);
    in_place.a = static_cast<std::uint32_t>(a);
    in_place.b = static_cast<std::uint32_t>(b);
    in_place.frame_a = frame_a;
    in_place.frame_b = frame_b;
    joints.push_back(std::move(in_place));
  }

  void step() {
    const double h = dt / sub_steps;
    std::vector<JointRows<double>> rows(joints.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    for (const JointInPlace<double>& j : joints) ends.emplace_back(j.a, j.b);
    std::vector<std::uint8_t> movable;
    for (const double mass : masses) movable.push_back(mass > 0 ? 1 : 0);
    JointSystem<double, graze::Space<double>> system;
    for (std::size_t i = 0; i < joints.size(); ++i) rows[i].prepare(joints[i], {h, 1 / h, dt, true});
    system.prepare(rows, ends, movable);
    for (int s = 0; s < sub_steps; ++s) {
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        SolverBody<double>& b = bodies[i];
        b.linear_before = b.linear;
        b.angular_before = b.angular;
        if (masses[i] > 0) b.linear += acceleration * h;
      }
      const auto each = [&](const auto& f) {
        for (JointRows<double>& r : rows) f(r, bodies[r.a()], bodies[r.b()]);
      };
      each([](auto& r, auto& a, auto& b) { r.refresh(a, b); });
      each([](auto& r, auto& a, auto& b) { r.warm_start(a, b); });
      system.factor(rows, bodies);
      system.solve(rows, bodies, true);
      each([](auto& r, auto& a, auto& b) { r.solve_free(a, b, true); });
      for (std::size_t i = 0; i < bodies.size(); ++i) move(i, h);
      each([](auto& r, auto& a, auto& b) { r.arrive(a, b); });
      system.factor(rows, bodies);
      system.solve(rows, bodies, false);
      each([](auto& r, auto& a, auto& b) { r.solve_free(a, b, false); });
    }
    for (JointRows<double>& r : rows) r.store();
    time += dt;
  }
  void run(double seconds) {
    for (const double end = time + seconds - dt / 2; time < end;) step();
  }

  double energy() const {
    double sum = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!(masses[i] > 0)) continue;
      const Vec3d w = inverse_rotate(i, bodies[i].angular), j = free[i].inverse_inertia;
      sum += masses[i] * (length_squared(bodies[i].linear) / 2 - dot(acceleration, bodies[i].center));
      for (std::size_t k = 0; k < 3; ++k) sum += w[k] * w[k] / j[k] / 2;
    }
    return sum;
  }
  /// How far apart the origins of a joint's frames are.
  double gap(std::size_t joint) const {
    return length(frame(joint, true).translation - frame(joint, false).translation);
  }
  Pose<double> frame(std::size_t joint, bool first) const {
    const JointInPlace<double>& j = joints[joint];
    const SolverBody<double>& b = bodies[first ? j.a : j.b];
    return compose(Pose<double>{b.center, b.rotation}, first ? j.frame_a : j.frame_b);
  }
  /// The turn of the second frame seen from the first.
  Quatd turn(std::size_t joint) const { return conjugate(frame(joint, true).rotation) * frame(joint, false).rotation; }

 private:
  Vec3d inverse_rotate(std::size_t i, const Vec3d& v) const { return rotate(conjugate(bodies[i].rotation), v); }

  void move(std::size_t i, double h) {
    SolverBody<double>& b = bodies[i];
    b.center += (b.linear_before + b.linear) * (h / 2);
    FreeBody<double>& f = free[i];
    f.rotation = b.rotation;
    // The torque of the rows, half of it before the turn; freely from there with the momentum at the end.
    if (masses[i] > 0) {
      set_angular_velocity(f, (b.angular_before + b.angular) / 2.0);
      const Vec3d middle = f.angular_momentum;
      set_angular_velocity(f, b.angular);
      const Vec3d change = f.angular_momentum - middle;
      f.angular_momentum = middle;
      advance(f, Vec3d{}, h);
      f.angular_momentum += change;
      b.rotation = f.rotation;
      b.angular = angular_velocity(f);
      const Mat3d r = rotation_matrix(b.rotation);
      b.mass.inertia = r * Mat3d::diagonal(f.inverse_inertia) * transposed(r);
    }
  }
};

const Vec3d ball_inertia{0.4, 0.4, 0.4};

Joint<double> with_limits(std::vector<JointLimit<double>> limits, std::vector<JointDrive<double>> drives = {}) {
  Joint<double> joint;
  joint.limits = std::move(limits);
  joint.drives = std::move(drives);
  return joint;
}

const JointLimit<double> together{JointSpace::linear, {true, true, true}};

TEST(Joints, APendulumKeepsItsPeriodAndEnergy) {
  for (const double amplitude : {0.05, 1.5}) {
    Chain chain;
    const auto world = chain.add(0, {}, {});
    const Quatd start = Quatd::from_axis_angle({0, 0, 1}, amplitude);
    const auto bob = chain.add(2, Vec3d{0.1, 0.2, 0.3}, {rotate(start, Vec3d{0, -1, 0}), start});
    chain.join(world, {}, bob, {{0, 1, 0}, {}}, with_limits({together}));
    const double energy = chain.energy();
    double last = 1, crossings = 0, first = 0, latest = 0;
    while (chain.time < 10) {
      chain.step();
      const double x = chain.bodies[bob].center.x;
      if (last > 0 && x <= 0) {
        latest = chain.time - chain.dt * x / (x - last);
        if (crossings++ == 0) first = latest;
      }
      last = x;
      EXPECT_LE(chain.gap(0), 2e-4) << chain.time;
      EXPECT_NEAR(chain.energy(), energy, 0.01 * 2 * gravity * (1 - std::cos(amplitude)));
    }
    // The period of a compound pendulum, with the arithmetic-geometric mean for large swings.
    double a = 1, g = std::cos(amplitude / 2);
    for (int i = 0; i < 6; ++i) std::tie(a, g) = std::pair((a + g) / 2, std::sqrt(a * g));
    const double period = 2 * std::acos(-1) * std::sqrt((2 + 0.3) / (2 * gravity)) / a;
    EXPECT_NEAR((latest - first) / (crossings - 1), period, 1e-3 * period) << amplitude;
  }
}

/// A chain of links of unequal inertia thrown about: no closed form, but energy.
TEST(Joints, ADoublePendulumKeepsItsEnergy) {
  Chain chain;
  const auto world = chain.add(0, {}, {});
  const auto upper = chain.add(1, Vec3d{0.1, 0.05, 0.1}, {{0.5, 0, 0}, {}});
  const auto lower = chain.add(1, Vec3d{0.1, 0.05, 0.1}, {{1.5, 0, 0}, {}});
  chain.join(world, {}, upper, {{-0.5, 0, 0}, {}}, with_limits({together}));
  chain.join(upper, {{0.5, 0, 0}, {}}, lower, {{-0.5, 0, 0}, {}}, with_limits({together}));
  const double energy = chain.energy();
  for (int i = 0; i < 600; ++i) {
    chain.step();
    ASSERT_LE(chain.gap(0) + chain.gap(1), 2e-3);
  }
  EXPECT_NEAR(chain.energy(), energy, 0.02 * 4 * gravity);
}

/// About each axis: the others do not turn, however far the free one has.
TEST(Joints, AHingeTurnsAboutItsAxisAlone) {
  const Quatd turns[] = {
      {}, Quatd::from_axis_angle({0, 0, 1}, std::acos(-1) / 2), Quatd::from_axis_angle({0, 1, 0}, std::acos(-1) / 2)};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const Quatd& placed : turns) {
      Chain chain;
      const auto world = chain.add(0, {}, {});
      const auto door = chain.add(3, Vec3d{0.5, 0.4, 0.2}, {{0.3, 0.2, 0.1}, {}});
      std::array<bool, 3> held{true, true, true};
      held[axis] = false;
      chain.join(world, {{}, placed}, door, {{-0.3, -0.2, -0.1}, placed},
                 with_limits({together, {JointSpace::angular, held}}));
      Vec3d free_axis{};
      free_axis[axis] = 1;
      const Vec3d w = rotate(placed, free_axis) * 7.0;
      chain.bodies[door].angular = w;
      chain.bodies[door].linear = cross(w, Vec3d{0.3, 0.2, 0.1});
      double turned = 0;
      for (int i = 0; i < 300; ++i) {
        chain.step();
        EXPECT_LE(chain.gap(0), 1e-3);
        const Vec3d q = chain.turn(0).vector();
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(k == axis ? 0 : q[k], 0, 1e-3) << axis;
        turned += dot(chain.bodies[door].angular, rotate(placed, free_axis)) * chain.dt;
      }
      EXPECT_GT(std::abs(turned), 10);
    }
}

TEST(Joints, AFixedJointHoldsABeam) {
  Chain chain;
  const auto world = chain.add(0, {}, {});
  const auto beam = chain.add(10, Vec3d{1, 3, 3}, {{1, 0, 0}, {}});
  chain.join(world, {}, beam, {{-1, 0, 0}, {}}, with_limits({together, {JointSpace::angular, {true, true, true}}}));
  chain.run(5);
  EXPECT_LE(chain.gap(0), 1e-9);
  EXPECT_LE(length(chain.turn(0).vector()), 1e-9);
  EXPECT_LE(length(chain.bodies[beam].linear), 1e-9);
}

/// On a slope of 45 degrees: way g sin t² / 2 down to the stop, and rest there.
TEST(Joints, ASliderSlidesToItsStop) {
  Chain chain;
  const auto world = chain.add(0, {}, {});
  const Quatd slope = Quatd::from_axis_angle({0, 0, 1}, std::acos(-1) / 4);
  const auto block = chain.add(1, ball_inertia, {{}, slope});
  chain.join(world, {{}, slope}, block, {},
             with_limits({{JointSpace::linear, {false, true, true}},
                          {JointSpace::angular, {true, true, true}},
                          {JointSpace::linear, {true, false, false}, -2, 2, {}, 0}}));
  const auto along = [&] { return dot(chain.bodies[block].center, rotate(slope, Vec3d{1, 0, 0})); };
  chain.run(0.5);
  EXPECT_NEAR(along(), -gravity * std::sqrt(0.5) * 0.125, 1e-9);
  chain.run(5);
  EXPECT_NEAR(along(), -2, 1e-6);
  EXPECT_LE(length(chain.bodies[block].linear), 1e-6);
  EXPECT_LE(length(cross(chain.bodies[block].center, rotate(slope, Vec3d{1, 0, 0}))), 1e-6);
}

TEST(Joints, ALinearDriveRestsWhereItsSpringBearsTheWeight) {
  for (const DriveMode mode : {DriveMode::acceleration, DriveMode::force}) {
    Chain chain;
    const auto world = chain.add(0, {}, {});
    const auto lift = chain.add(4, ball_inertia, {});
    const double mass = mode == DriveMode::force ? 4 : 1;
    chain.join(world, {}, lift, {},
               with_limits({{JointSpace::linear, {true, false, true}}, {JointSpace::angular, {true, true, true}}},
                           {{JointSpace::linear, mode, 1, 2, 0, 100 * mass, 1 * mass}}));
    // x'' = 100 (2 - x) - x' - g from rest: frequency sqrt(100 - 1/4), decay 1/2.
    const double rest = 2 - gravity / 100, w = std::sqrt(99.75);
    while (chain.time < 3) {
      chain.step();
      const double t = chain.time;
      const double exact = rest - rest * std::exp(-t / 2) * (std::cos(w * t) + std::sin(w * t) / (2 * w));
      EXPECT_NEAR(chain.bodies[lift].center.y, exact, 5e-3) << t;
    }
    chain.run(30);
    EXPECT_NEAR(chain.bodies[lift].center.y, rest, 1e-5);
  }
}

/// The axis does not go through the centre of mass: acceleration is that of the whole motion that is left free.
TEST(Joints, AnAngularDriveReachesItsSpeed) {
  for (const double arm : {0.0, 2.0}) {
    Chain chain;
    chain.acceleration = {};
    const auto world = chain.add(0, {}, {});
    const auto wheel = chain.add(3, ball_inertia, {{0, arm, 0}, {}});
    const double target = std::acos(-1) / 2;
    chain.join(world, {}, wheel, {{0, -arm, 0}, {}},
               with_limits({together, {JointSpace::angular, {false, true, true}}},
                           {{JointSpace::angular, DriveMode::acceleration, 0, 0, target, 0, 1}}));
    while (chain.time < 5) {
      chain.step();
      EXPECT_NEAR(chain.bodies[wheel].angular.x, target * (1 - std::exp(-chain.time)), 1e-3) << arm;
      EXPECT_LE(chain.gap(0), 1e-3);
    }
  }
}

TEST(Joints, ADriveIsNoStrongerThanItsForce) {
  Chain chain;
  const auto world = chain.add(0, {}, {});
  const auto lift = chain.add(2, ball_inertia, {});
  JointDrive<double> drive{JointSpace::linear, DriveMode::force, 1, 5, 0, 1e9, 1e6};
  drive.max_force = 30;
  chain.join(world, {}, lift, {}, with_limits({{JointSpace::linear, {true, false, true}}}, {drive}));
  chain.run(0.5);
  EXPECT_NEAR(chain.bodies[lift].center.y, (30 / 2.0 - gravity) * 0.125, 1e-9);
}

TEST(Joints, ARopeIsNeverLonger) {
  Chain chain;
  const auto world = chain.add(0, {}, {});
  const auto stone = chain.add(1, ball_inertia, {{0.5, 0, 0}, {}});
  chain.join(world, {}, stone, {}, with_limits({{JointSpace::linear, {true, true, true}, 0, 1, {}, 0}}));
  bool slack = false, tight = false;
  for (int i = 0; i < 1200; ++i) {
    chain.step();
    const double l = length(chain.bodies[stone].center);
    EXPECT_LE(l, 1.001) << chain.time;
    slack |= l < 0.99;
    tight |= l > 0.999;
  }
  EXPECT_TRUE(slack && tight);
}

/// A soft limit is a spring beyond its bound: it bears the weight where k x = m g.
TEST(Joints, ASoftLimitGives) {
  Chain chain;
  const auto world = chain.add(0, {}, {});
  const auto stone = chain.add(2, ball_inertia, {{0, -0.9, 0}, {}});
  chain.join(world, {}, stone, {}, with_limits({{JointSpace::linear, {true, true, true}, 0, 1, 200.0, 30}}));
  chain.run(20);
  EXPECT_NEAR(chain.bodies[stone].center.y, -1 - 2 * gravity / 200, 1e-6);
}

/// Driven against its bound, each measure of an angle stops there.
TEST(Joints, AnglesStopAtTheirBounds) {
  struct Case {
    std::array<bool, 3> axes;
    Vec3d push;
    double min, max, end;
  };
  const double third = std::acos(-1) / 3;
  for (const Case& c :
       {Case{{true, false, false}, {1, 0, 0}, -0.5, 2.5, 2.5}, Case{{true, false, false}, {-1, 0, 0}, -0.5, 2.5, -0.5},
        Case{{false, true, true}, {0, 0.6, 0.8}, 0, third, third},
        Case{{true, true, true}, {0.6, 0.8, 0}, 0, third, third}}) {
    Chain chain;
    chain.acceleration = {};
    const auto world = chain.add(0, {}, {});
    const auto arm = chain.add(1, ball_inertia, {});
    chain.join(world, {}, arm, {}, with_limits({together, {JointSpace::angular, c.axes, c.min, c.max, {}, 0}}));
    chain.bodies[arm].angular = c.push * 2.0;
    double most = 0;
    for (int i = 0; i < 120; ++i) {
      chain.step();
      most = std::max(most, 2 * std::atan2(length(chain.turn(0).vector()), std::abs(chain.turn(0).w)));
    }
    EXPECT_NEAR(most, std::abs(c.end), 1e-6);
    EXPECT_NEAR(2 * std::atan2(dot(chain.turn(0).vector(), c.push), chain.turn(0).w), std::abs(c.end), 1e-6);
    EXPECT_LE(length(chain.bodies[arm].angular), 1e-9);
  }
}

/// Pairs of bodies on joints of all kinds, thrown: what one gets the other loses.
TEST(Joints, MomentumStays) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return Vec3d{any(random), any(random), any(random)}; };
  const auto pose = [&] {
    return Pose<double>{vector(), normalized(Quatd{any(random), any(random), any(random), any(random)})};
  };
  for (int trial = 0; trial < 50; ++trial) {
    Chain chain;
    chain.acceleration = {};
    const Pose<double> at = pose(), other = pose(), frame = pose();
    for (const Pose<double>& p : {at, other}) chain.add(1 + any(random) / 2, Vec3d{0.5, 0.4, 0.3}, p);
    std::vector<JointLimit<double>> limits{{JointSpace::linear, {any(random) > 0, any(random) > 0, true}}};
    limits.push_back({JointSpace::angular, {any(random) > 0, true, any(random) > 0}, -0.2, 0.3, {}, 0});
    if (trial % 2) limits.push_back({JointSpace::linear, {true, true, false}, 0, 0.1, 50.0, 1});
    chain.join(0, frame, 1, relative(other, compose(at, frame)),
               with_limits(limits, {{JointSpace::angular, DriveMode::force, 1, 0.1, 0, 3, 1}}));
    for (auto& b : chain.bodies) {
      b.linear = vector();
      b.angular = vector() * 3.0;
    }
    const auto momentum = [&] {
      return chain.bodies[0].linear * chain.masses[0] + chain.bodies[1].linear * chain.masses[1];
    };
    const auto spin = [&] {
      Vec3d sum{};
      for (std::size_t i = 0; i < 2; ++i) {
        FreeBody<double> f = chain.free[i];
        f.rotation = chain.bodies[i].rotation;
        set_angular_velocity(f, chain.bodies[i].angular);
        sum += f.angular_momentum + cross(chain.bodies[i].center, chain.bodies[i].linear) * chain.masses[i];
      }
      return sum;
    };
    const Vec3d p = momentum(), l = spin();
    chain.run(1);
    EXPECT_LE(length(momentum() - p), 1e-12);
    // The rows push at the places of the beginning and of the end, the bodies move in between.
    EXPECT_LE(length(spin() - l), 2e-2 * (1 + length(l))) << trial;
    EXPECT_TRUE(std::isfinite(chain.energy()));
  }
}

TEST(Joints, AnglesAreThoseOfTheLibrary) {
  for (int i = -400; i <= 400; ++i) {
    const double angle = i * std::acos(-1) / 400, r = std::exp(i / 40.0);
    const double found = angle_of(r * std::cos(angle), r * std::sin(angle));
    EXPECT_NEAR(i > -400 ? found : -std::abs(found), angle, 1e-15 + 4e-16 * std::abs(angle));
    const float single = angle_of(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    EXPECT_NEAR(std::abs(static_cast<double>(single)), std::abs(angle), 5e-7) << angle;
  }
  EXPECT_EQ(angle_of(0.0, 0.0), 0);
}

TEST(Joints, WhatIsNoneIsNamed) {
  const auto refusal = [](const Joint<double>& joint) -> std::string {
    try {
      check(joint);
    } catch (const InvalidValue& e) {
      return e.what();
    }
    return "taken";
  };
  EXPECT_EQ(refusal(with_limits({together})), "taken");
  EXPECT_EQ(refusal(with_limits({{}})), "joint.limits[0].axes: expected at least one axis, got none");
  EXPECT_EQ(refusal(with_limits({together, {JointSpace::linear, {true, false, false}, 2, 1, {}, 0}})),
            "joint.limits[1].min: expected at most max, got 2");
  const auto bounded = [](double min, double max) {
    return with_limits({{JointSpace::linear, {true, false, false}, min, max, {}, 0}});
  };
  EXPECT_EQ(refusal(bounded(infinity, infinity)), "joint.limits[0].min: expected a number or minus infinity, got inf");
  EXPECT_EQ(refusal(bounded(-infinity, -infinity)), "joint.limits[0].max: expected a number or infinity, got -inf");
  EXPECT_EQ(refusal(bounded(0, std::nan(""))), "joint.limits[0].max: expected a number or infinity, got nan");
  EXPECT_EQ(refusal(bounded(-infinity, infinity)), "taken");
  EXPECT_EQ(refusal(with_limits({{JointSpace::linear, {true, false, false}, 0, 0, -1.0, 0}})),
            "joint.limits[0].stiffness: expected a finite number >= 0, got -1");
  EXPECT_EQ(refusal(with_limits({}, {{JointSpace::linear, DriveMode::force, 3}})),
            "joint.drives[0].axis: expected 0, 1 or 2, got 3");
  EXPECT_EQ(refusal(with_limits({}, {{JointSpace::linear, DriveMode::force, 0, infinity}})),
            "joint.drives[0].position_target: expected a finite number, got inf");
  EXPECT_EQ(refusal(with_limits({}, {{JointSpace::linear, DriveMode::force, 0, 0, 0, 0, 1e200}})),
            "joint.drives[0].damping: expected a magnitude of at most 1e48, got 1e+200");
}

}  // namespace
}  // namespace graze::joints_test
