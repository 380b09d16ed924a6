// Simulations of the plane against closed forms, and what must stay or be the same.
#include "graze/plane/simulation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "common/executors.hpp"

namespace graze::plane {
namespace {

using graze::testing::BusyExecutor;
using graze::testing::ThreadExecutor;

constexpr double dt = 1.0 / 64;  // exact, so that closed forms can be compared to the last digits

template <class T>
SimulationSettings<T> settings(T gravity = T(10), bool sleep = false) {
  SimulationSettings<T> s;
  s.gravity = {T(0), -gravity};
  s.sleep = sleep;
  return s;
}

template <class T>
BodyId add_floor(Simulation<T>& s, const Material<T>& material = {}, const Rot2<T>& rotation = {}) {
  Body<T> body{HalfPlane<T>()};
  body.pose.rotation = rotation;
  body.fixed = true;
  return s.add(body, {}, material);
}

template <class T>
class PlaneSimulationOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneSimulationOf, Scalars);

TYPED_TEST(PlaneSimulationOf, FallsAsGalileoSays) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  const BodyId ball = s.add({Circle<T>(T(0.5)), {{T(1), T(100)}, {}}, {T(3), T(0)}});
  for (int i = 0; i < 128; ++i) s.step(T(dt));
  const Vec2<T> at = s.poses()[ball.index].translation;
  const T rounding = T(200) * std::numeric_limits<T>::epsilon() * T(100);
  EXPECT_NEAR(at.x, T(7), rounding);
  EXPECT_NEAR(at.y, T(80), rounding);
}

/// The centre of mass of what turns flies a parabola, and the turn is the rate times the time; with a centre of mass
/// beside the origin of the shape the latter goes round it.
TYPED_TEST(PlaneSimulationOf, TurnsAtItsRate) {
  using T = TypeParam;
  for (const T rate : {T(0.1), T(-7), T(300)}) {
    Simulation<T> s(settings<T>());
    Dynamics<T> d;
    d.center_of_mass = Vec2<T>{T(0.25), T(0)};
    const Vec2<T> center{T(0.25), T(1000)};
    // The centre stands still: the origin, a quarter to its left, turns about it.
    const BodyId book = s.add({Box<T>({T(1), T(2)}), {{T(0), T(1000)}, {}}, {T(0), T(-0.25) * rate}, rate}, d);
    const T before = s.angular_momentum(book);
    for (int i = 0; i < 64; ++i) s.step(T(dt));
    EXPECT_EQ(s.angular_momentum(book), before);
    const double angle = static_cast<double>(rate);
    const Pose2<T> pose = s.poses()[book.index];
    const double rounding = 256 * static_cast<double>(std::numeric_limits<T>::epsilon());
    EXPECT_NEAR(static_cast<double>(pose.rotation.cosine), std::cos(angle), rounding * (1 + std::abs(angle)));
    EXPECT_NEAR(static_cast<double>(pose.rotation.sine), std::sin(angle), rounding * (1 + std::abs(angle)));
    const Vec2<T> middle = transform(pose, *d.center_of_mass);
    EXPECT_NEAR(static_cast<double>(middle.x), static_cast<double>(center.x), rounding * 10);
    EXPECT_NEAR(static_cast<double>(middle.y), static_cast<double>(center.y) - 5, rounding * 1000);
  }
}

/// The rotation that is made without sine and cosine is theirs.
TEST(PlaneFreeMotion, RotationsAreThoseOfTheLibrary) {
  for (double angle = -40; angle < 40; angle += 0.0137) {
    const Rot2<double> turn = rotation_by(angle);
    EXPECT_NEAR(turn.cosine, std::cos(angle), 1e-15 * (4 + std::abs(angle)));
    EXPECT_NEAR(turn.sine, std::sin(angle), 1e-15 * (4 + std::abs(angle)));
  }
  EXPECT_EQ(rotation_by(0.0), Rot2<double>{});
  EXPECT_EQ(rotation_by(std::numeric_limits<double>::infinity()), Rot2<double>{});
}

/// A box slides down a slope of 30 degrees with g (sin - friction cos), and stays where friction suffices.
TYPED_TEST(PlaneSimulationOf, SlidesDownASlope) {
  using T = TypeParam;
  const double angle = 0.5235987755982988;
  const Rot2<T> tilt = Rot2<T>::from_angle(static_cast<T>(angle));
  for (const double part : {0.5, 0.98, 1.02}) {
    const double friction = part * std::tan(angle);
    const Material<T> m{static_cast<T>(friction), static_cast<T>(friction)};
    Simulation<T> s(settings<T>());
    add_floor<T>(s, m, tilt);
    const BodyId box = s.add({Box<T>({T(1), T(0.25)}), {rotate(tilt, Vec2<T>{T(0), T(0.125)}), tilt}}, {}, m);
    const Vec2<T> start = s.poses()[box.index].translation;
    for (int i = 0; i < 128; ++i) s.step(T(dt));
    const double speed = static_cast<double>(length(s.motion(box).linear));
    const double way = static_cast<double>(length(s.poses()[box.index].translation - start));
    const double exact = 10 * (std::sin(angle) - friction * std::cos(angle));
    if (part < 1) {
      EXPECT_NEAR(speed / (exact * 2), 1, 0.005) << part;
      EXPECT_NEAR(way / (exact * 2), 1, part < 0.9 ? 0.005 : 0.05) << part;
    } else {
      EXPECT_LT(way, 1e-3) << part;
      EXPECT_LT(speed, 1e-4) << part;
    }
  }
}

/// What slides on a level floor stops after v² / (2 μ g).
TYPED_TEST(PlaneSimulationOf, StopsWhereFrictionEndsIt) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_floor(s);
  const BodyId plate = s.add({Box<T>({T(2), T(0.1)}), {{T(0), T(0.05)}, {}}, {T(6), T(0)}});
  for (int i = 0; i < 128; ++i) s.step(T(dt));
  EXPECT_NEAR(s.poses()[plate.index].translation.x, T(3), T(0.01));
  EXPECT_LT(length(s.motion(plate).linear), T(1e-4));
}

/// A disc that slides begins to roll: with the inertia m r² / 2 two thirds of the speed are left (Coriolis 1835). With
/// rolling friction it then comes to a stop.
TYPED_TEST(PlaneSimulationOf, SlidingDiscsRoll) {
  using T = TypeParam;
  for (const T rolling : {T(0), T(0.05)}) {
    Simulation<T> s(settings<T>());
    Material<T> m;
    m.rolling_friction = rolling;
    add_floor<T>(s, m);
    const BodyId disc = s.add({Circle<T>(T(0.5)), {{T(0), T(0.5)}, {}}, {T(6), T(0)}}, {}, m);
    for (int i = 0; i < 128; ++i) s.step(T(dt));
    if (rolling == T(0)) {
      EXPECT_NEAR(s.motion(disc).linear.x, T(4), T(0.02));
      EXPECT_NEAR(s.motion(disc).angular, T(-8), T(0.04));
    } else {
      for (int i = 0; i < 10 * 64; ++i) s.step(T(dt));
      EXPECT_LT(length(s.motion(disc).linear), T(1e-4));
      EXPECT_LT(std::abs(s.motion(disc).angular), T(1e-4));
    }
  }
}

/// Rolling friction of a length c turns a disc back by c m g: with the inertia m r² / 2 it slows down by 2 c g / 3 r.
TYPED_TEST(PlaneSimulationOf, RollingFrictionSlowsADiscDown) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  Material<T> m;
  m.rolling_friction = T(0.075);
  add_floor<T>(s, m);
  const BodyId disc = s.add({Circle<T>(T(0.5)), {{T(0), T(0.5)}, {}}, {T(4), T(0)}, T(-8)}, {}, m);
  for (int i = 0; i < 128; ++i) s.step(T(dt));
  EXPECT_NEAR(s.motion(disc).linear.x, T(2), T(0.02));
  EXPECT_NEAR(s.motion(disc).angular, T(-4), T(0.04));
}

/// Static friction holds up to its cone; what slides is held back by the dynamic one: on a slope of 3 : 4 by
/// (3 - 4 / 4) g / 5.
TYPED_TEST(PlaneSimulationOf, StaticFrictionHoldsWhatDynamicLetsGo) {
  using T = TypeParam;
  const Rot2<T> tilt{T(0.8), T(-0.6)};
  const Vec2<T> down{T(0.8), T(-0.6)}, up{T(0.6), T(0.8)};
  const Material<T> m{T(0.9), T(0.25)};
  for (const T speed : {T(0), T(1)}) {
    Simulation<T> s(settings<T>());
    add_floor<T>(s, m, tilt);
    const BodyId box = s.add({Box<T>({T(2), T(0.5)}), {up * T(0.25), tilt}, down * speed}, {}, m);
    for (int i = 0; i < 128; ++i) s.step(T(dt));
    const T expected = speed == T(0) ? T(0) : speed + (T(3) - T(1)) / T(5) * T(10) * T(2);
    EXPECT_NEAR(dot(s.motion(box).linear, down), expected, T(0.02) * (T(1) + expected)) << speed;
  }
}

/// Nor does it slide that a box touches first at a corner, or a little later, wherever static friction holds it.
TYPED_TEST(PlaneSimulationOf, WhatIsPutDownGentlyStays) {
  using T = TypeParam;
  const Rot2<T> tilt{T(0.8), T(-0.6)};
  const Vec2<T> up{T(0.6), T(0.8)};
  for (const double friction : {0.8, 0.9, 1.2})
    for (const double gap : {-1e-4, -1e-7, 0.0, 1e-8, 1e-6, 1e-5, 1e-4})
      for (const double height : {0.5, 1.0}) {
        const Material<T> m{static_cast<T>(friction), T(0.25)};
        Simulation<T> s(settings<T>());
        add_floor<T>(s, m, tilt);
        const T away = static_cast<T>(height / 2 + gap);
        const BodyId box = s.add({Box<T>({T(2), static_cast<T>(height)}), {up * away, tilt}}, {}, m);
        for (int i = 0; i < 128; ++i) s.step(T(dt));
        EXPECT_LT(length(s.motion(box).linear), T(1e-4)) << friction << ", " << gap << ", " << height;
      }
}

/// A ball that falls from h rebounds to e² h, and with e = 1 keeps its energy.
TYPED_TEST(PlaneSimulationOf, Rebounds) {
  using T = TypeParam;
  for (const double e : {0.5, 0.8, 1.0}) {
    Material<T> m;
    m.restitution = static_cast<T>(e);
    Simulation<T> s(settings<T>());
    add_floor<T>(s, m);
    const BodyId ball = s.add({Circle<T>(T(0.5)), {{T(0), T(5.5)}, {}}}, {}, m);
    T highest(0);
    bool risen = false;
    for (int i = 0; i < 4 * 64; ++i) {
      s.step(T(dt));
      const T v = s.motion(ball).linear.y;
      if (risen && v < T(0)) break;
      risen = risen || v > T(0);
      if (risen) highest = greatest(highest, s.poses()[ball.index].translation.y - T(0.5));
    }
    EXPECT_NEAR(static_cast<double>(highest) / (e * e * 5), 1, 0.005) << e;
  }
}

/// The blow passes through touching balls: the last leaves with the speed of the first.
TYPED_TEST(PlaneSimulationOf, NewtonsCradle) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(0)));
  Material<T> m;
  m.restitution = T(1);
  std::vector<BodyId> balls;
  for (int i = 0; i < 5; ++i) balls.push_back(s.add({Circle<T>(T(0.5)), {{T(i), T(0)}, {}}}, {}, m));
  const BodyId first = s.add({Circle<T>(T(0.5)), {{T(-2), T(0)}, {}}, {T(5), T(0)}}, {}, m);
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.motion(balls[4]).linear.x, T(5), T(0.01));
  for (const BodyId ball : {first, balls[0], balls[1], balls[2], balls[3]})
    EXPECT_NEAR(length(s.motion(ball).linear), T(0), T(0.01));
}

template <class T>
std::vector<BodyId> add_tower(Simulation<T>& s, int count) {
  add_floor(s);
  std::vector<BodyId> boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(s.add({Box<T>({T(1), T(1)}), {{T(0), T(i) + T(0.5)}, {}}}));
  return boxes;
}

TYPED_TEST(PlaneSimulationOf, TenBoxesStandAwake) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  const auto boxes = add_tower(s, 10);
  for (int i = 0; i < 5 * 64; ++i) s.step(T(dt));
  const Vec2<T> top = s.poses()[boxes.back().index].translation;
  EXPECT_NEAR(top.y, T(9.5), T(0.02));
  EXPECT_NEAR(top.x, T(0), T(0.02));
  EXPECT_LT(s.report().deepest, T(0.002));
  EXPECT_EQ(s.report().awake, 10u);
  EXPECT_EQ(s.report().islands, 1u);
}

TYPED_TEST(PlaneSimulationOf, APyramidStands) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_floor(s);
  std::vector<std::pair<BodyId, Vec2<T>>> boxes;
  constexpr int base = 12;
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i) {
      const Vec2<T> at{(T(i) + T(row) / T(2)) * T(1.1), T(row) + T(0.5)};
      boxes.emplace_back(s.add({Box<T>({T(1), T(1)}), {at, {}}}), at);
    }
  for (int i = 0; i < 5 * 64; ++i) s.step(T(dt));
  for (const auto& [box, at] : boxes) EXPECT_LT(length(s.poses()[box.index].translation - at), T(0.02));
  EXPECT_LT(s.report().deepest, T(0.002));
}

TYPED_TEST(PlaneSimulationOf, SleepsAndWakes) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(10), true));
  const auto boxes = add_tower(s, 3);
  for (int i = 0; i < 3 * 64; ++i) s.step(T(dt));
  for (const BodyId box : boxes) EXPECT_TRUE(s.asleep(box));
  EXPECT_EQ(s.report().awake, 0u);
  const T height = s.poses()[boxes[2].index].translation.y;
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  EXPECT_EQ(s.poses()[boxes[2].index].translation.y, height);
  s.remove(boxes[0]);  // what stood on it falls
  EXPECT_FALSE(s.asleep(boxes[1]));
  for (int i = 0; i < 4 * 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.poses()[boxes[2].index].translation.y, T(1.5), T(0.01));
  s.apply_impulse(boxes[2], {T(3000), T(0)}, s.poses()[boxes[2].index].translation);
  EXPECT_FALSE(s.asleep(boxes[2]));
  for (int i = 0; i < 32; ++i) s.step(T(dt));
  EXPECT_GT(s.poses()[boxes[2].index].translation.x, T(0.1));
}

/// An impulse beside the centre moves it by p / m and turns the body by r × p / I; the box of 1 by 1 has m / 6.
TYPED_TEST(PlaneSimulationOf, ImpulsesAndForcesMoveAndTurn) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(0)));
  const BodyId box = s.add({Box<T>({T(1), T(1)}), {{T(2), T(3)}, {}}});
  EXPECT_NEAR(s.mass(box), T(1000), T(1e-3));
  s.apply_impulse(box, {T(0), T(500)}, {T(2.5), T(3)});
  EXPECT_NEAR(s.motion(box).linear.y, T(0.5), T(1e-6));
  EXPECT_NEAR(s.motion(box).angular, T(1.5), T(1e-5));
  s.apply_angular_impulse(box, s.angular_momentum(box) * T(-1));
  s.apply_force(box, {T(64000), T(0)});
  s.apply_torque(box, T(32000) / T(3));
  s.step(T(dt));
  EXPECT_NEAR(s.motion(box).linear.x, T(1), T(1e-5));
  EXPECT_NEAR(s.motion(box).angular, T(1), T(1e-5));
}

TYPED_TEST(PlaneSimulationOf, KinematicPlatformAndBelt) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  Dynamics<T> kinematic;
  kinematic.kinematic = true;
  const BodyId platform = s.add({Box<T>({T(40), T(1)}), {{T(0), T(-0.5)}, {}}, {T(0), T(1)}}, kinematic);
  const BodyId box = s.add({Box<T>({T(1), T(1)}), {{T(0), T(0.5)}, {}}});
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.poses()[platform.index].translation.y, T(0.5), T(1e-4));
  EXPECT_NEAR(s.poses()[box.index].translation.y, T(1.5), T(0.005));
  s.set_velocity(platform, {});
  Material<T> belt;
  belt.surface_velocity = {T(2), T(0)};
  s.set_material(platform, belt);
  for (int i = 0; i < 2 * 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.motion(box).linear.x, T(2), T(0.01));
  s.set_material(platform, {});
  const Pose2<T> there{{T(3), T(0.5)}, Rot2<T>::from_angle(T(-0.1))};
  s.move_to(platform, there, T(dt));
  s.step(T(dt));
  EXPECT_NEAR(s.poses()[platform.index].translation.x, T(3), T(1e-5));
  EXPECT_NEAR(s.poses()[platform.index].rotation.sine, there.rotation.sine, T(1e-6));
}

TYPED_TEST(PlaneSimulationOf, BulletsStopAtAWallAndAtEachOther) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(0)));
  Body<T> wall{Box<T>({T(0.01), T(4)}), {{T(10.3), T(0)}, {}}};
  wall.fixed = true;
  s.add(wall);
  const BodyId bullet = s.add({Box<T>({T(0.2), T(0.2)}), {}, {T(300), T(0)}, T(5)});
  const BodyId left = s.add({Circle<T>(T(0.1)), {{T(-10), T(8)}, {}}, {T(300), T(0)}});
  const BodyId right = s.add({Circle<T>(T(0.1)), {{T(10), T(8)}, {}}, {T(-300), T(0)}});
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  EXPECT_LT(s.poses()[bullet.index].translation.x, T(10.3));
  EXPECT_LE(s.poses()[left.index].translation.x, s.poses()[right.index].translation.x);
}

/// Shapes of all kinds fall onto a floor.
template <class T>
void add_heap(Simulation<T>& s, unsigned seed, int count, T size = T(1)) {
  add_floor(s);
  std::mt19937 random(seed);
  const auto number = [&] { return T(random() % 1024) / T(512) - T(1); };
  for (int i = 0; i < count; ++i) {
    const auto shape = [&]() -> Shape<T> {
      const T half = size / T(2);
      switch (random() % 6) {
      case 0: return Circle<T>(half);
      case 1: return Capsule<T>(size / T(4), size);
      case 2: return ConvexPolygon<T>(std::vector<Vec2<T>>{{-half, -half}, {half, -half}, {T(0), half}});
      case 3: return Ellipse<T>({half, size / T(4)});
      case 4: return Box<T>({size, half});
      default: return Box<T>({size, size});
      }
    };
    const Vec2<T> x = normalized(Vec2<T>{number() + T(1.5), number()});
    const Pose2<T> pose{{number() * size * T(4), (T(1) + T(i) / T(2)) * size}, {x.x, x.y}};
    Material<T> m;
    m.rolling_friction = size / T(10);
    s.add({shape(), pose}, {}, m);
  }
}

template <class T>
std::vector<Pose2<T>> poses_after(Simulation<T>& s, int steps, T step = T(dt)) {
  for (int i = 0; i < steps; ++i) s.step(step);
  return {s.poses().begin(), s.poses().end()};
}

TYPED_TEST(PlaneSimulationOf, SameBitsOnAnyThreads) {
  using T = TypeParam;
  const auto run = [](Executor* executor) {
    Simulation<T> s(settings<T>(T(10), true), executor);
    add_heap(s, 5, 60);
    return poses_after(s, 100);
  };
  const auto serial = run(nullptr);
  ThreadExecutor threads(4);
  BusyExecutor busy(true);
  EXPECT_EQ(run(&threads), serial);
  EXPECT_EQ(run(&busy), serial);
}

TYPED_TEST(PlaneSimulationOf, SameBitsAfterRestore) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(10), true));
  add_heap(s, 6, 40);
  poses_after(s, 60);
  const State<T> state = s.save();
  const auto once = poses_after(s, 60);
  s.restore(state);
  EXPECT_EQ(poses_after(s, 60), once);
  poses_after(s, 20);
  s.restore(state);
  EXPECT_EQ(poses_after(s, 60), once);
}

TYPED_TEST(PlaneSimulationOf, SameBitsInAnotherSize) {
  using T = TypeParam;
  const auto run = [](T scale, T step) {
    Simulation<T> s(settings<T>(T(10), true));
    add_heap(s, 7, 20, scale);
    auto poses = poses_after(s, 150, step);
    for (Pose2<T>& p : poses) p.translation = p.translation / scale;
    return poses;
  };
  EXPECT_EQ(run(T(4), T(2 * dt)), run(T(1), T(dt)));
}

/// What collides in free space keeps momentum and, but for the way that bodies go while they are pressed, angular
/// momentum; and gains no energy beyond what parts those that start in each other.
RC_GTEST_PROP(PlaneSimulation, CollisionsConserve, (int seed)) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto number = [&] { return static_cast<double>(random() % 1024) / 512 - 1; };
  Simulation<double> s(settings<double>(0.0));
  Material<double> m;
  m.restitution = (random() % 2) != 0 ? 0.5 : 0.0;
  for (int i = 0; i < 6; ++i) {
    const double angle = 1.047197551196598 * (i + number() / 8);
    const Vec2d at = Vec2d{std::cos(angle), std::sin(angle)} * 3;
    s.add({Box<double>({1, 1 + number() / 2}), {at, Rot2d::from_angle(number())}, at * -2.0, number()}, {}, m);
  }
  const auto before = s.report();
  for (int i = 0; i < 100; ++i) s.step(dt);
  const auto after = s.report();
  const double size = 6 * 1000 * 6;
  RC_ASSERT(length(after.momentum - before.momentum) < 1e-9 * size);
  // Six of 1,000 at speed 6 that are pressed at places 6 dt apart.
  RC_ASSERT(std::abs(after.angular_momentum - before.angular_momentum) < size * 6 * dt);
  RC_ASSERT(after.kinetic_energy < before.kinetic_energy * (1 + 1e-9));
}

/// A heap of anything comes to rest, and nothing is a NaN on the way.
TEST(PlaneSimulation, HeapsComeToRest) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    Simulation<float> s(settings<float>(10.0f, true));
    add_heap(s, seed, 25);
    for (int i = 0; i < 20 * 64; ++i) s.step(float(dt));
    const auto r = s.report();
    EXPECT_TRUE(std::isfinite(r.kinetic_energy));
    EXPECT_LT(r.kinetic_energy, 5.0f) << seed;
    EXPECT_LT(r.deepest, 0.02f) << seed;
    for (const Pose2f& pose : s.poses().subspan(1)) EXPECT_GT(pose.translation.y, 0.1f) << seed;
  }
}

}  // namespace
}  // namespace graze::plane
