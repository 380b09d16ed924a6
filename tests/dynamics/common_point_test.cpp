// Two free bodies that press each other keep their angular momentum about a fixed point, in space and in the plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "dynamics/simulated.hpp"
#include "graze/plane/simulation.hpp"

namespace graze::testing {
namespace {

template <class T>
class CommonPoint : public ::testing::Test {};
using ScalarsOfPairs = ::testing::Types<float, double>;
TYPED_TEST_SUITE(CommonPoint, ScalarsOfPairs);

constexpr double speed = 10;  // at which two bodies meet

/// How two bodies meet, and whether fast ones are held back.
struct Encounter {
  double friction;
  bool continuous;
  double lighter = 1;   ///< the density of the second as a part of the first one's
  double faster = 0.5;  ///< the part of the speed that the second has
};

/// The speed at which the body on a side comes: the first on the side of -1, the second on that of 1.
template <class T>
T approach(const Encounter& meeting, T side) {
  return static_cast<T>(speed * (side > T(0) ? meeting.faster : meeting.faster - 1));
}

template <class T>
T random_number(std::mt19937& random) {
  return static_cast<T>(random() % 1024) / T(512) - T(1);
}
template <class T>
Vec3<T> random_vector(std::mt19937& random) {
  const T x = random_number<T>(random), y = random_number<T>(random);
  return {x, y, random_number<T>(random)};
}

template <class T>
T magnitude(const Vec3<T>& turning) {
  return length(turning);
}
template <class T>
T magnitude(const T& turning) {
  return std::abs(turning);
}

/// What a pair did in a second: the change of its angular momentum as a part of its reduced mass times the speed times a
/// metre, and whether it met.
struct Change {
  double momentum;
  bool met;
};

template <class T, class Space>
Change play(Simulation<T, Space>& s) {
  const auto before = s.report();
  for (int i = 0; i < 64; ++i) s.step(static_cast<T>(dt));
  const auto after = s.report();
  const auto& bodies = s.world().bodies();
  const T a = s.mass(bodies.id(0)), b = s.mass(bodies.id(1)), mass = a * b / (a + b);
  const T change = magnitude(after.angular_momentum - before.angular_momentum);
  return {static_cast<double>(change / mass) / speed, after.kinetic_energy < before.kinetic_energy * T(0.9999)};
}

/// Boxes, capsules and balls about a metre across that turn and meet off their centres.
template <class T>
Change meet_in_space(unsigned seed, const Encounter& meeting) {
  std::mt19937 random(seed);
  SimulationSettings<T> free = settings<T>(T(0));
  free.continuous = meeting.continuous;
  Simulation<T> s(free);
  const Material<T> m{static_cast<T>(meeting.friction), static_cast<T>(meeting.friction)};
  const Vec3<T> off = random_vector<T>(random) * T(0.3);
  for (const T side : {T(-1), T(1)}) {
    const auto shape = [&]() -> Shape<T> {
      switch (random() % 3) {
      case 0: return Box<T>({T(1), T(0.75) + random_number<T>(random) / T(4), T(0.6)});
      case 1: return Capsule<T>(T(0.3), T(0.8));
      default: return Sphere<T>(T(0.5));
      }
    }();
    const Vec3<T> axis = random_vector<T>(random), linear = random_vector<T>(random),
                  angular = random_vector<T>(random) * T(2);
    const Pose<T> at{Vec3<T>{T(0), T(0), side * T(2)} + off * side,
                     normalized(Quat<T>{axis.x, axis.y, axis.z, T(0.8)})};
    Dynamics<T> body;
    if (side > T(0)) body.density *= static_cast<T>(meeting.lighter);
    s.add({shape, at, linear - Vec3<T>{T(0), T(0), approach<T>(meeting, side)}, angular}, body, m);
  }
  return play(s);
}

/// The same in the plane.
template <class T>
Change meet_in_plane(unsigned seed, const Encounter& meeting) {
  using Vec = plane::Vec2<T>;
  std::mt19937 random(seed);
  plane::SimulationSettings<T> free;
  free.gravity = {};
  free.sleep = false;
  free.continuous = meeting.continuous;
  plane::Simulation<T> s(free);
  const plane::Material<T> m{static_cast<T>(meeting.friction), static_cast<T>(meeting.friction)};
  const T off = random_number<T>(random) * T(0.3);
  for (const T side : {T(-1), T(1)}) {
    const auto shape = [&]() -> plane::Shape<T> {
      switch (random() % 3) {
      case 0: return plane::Box<T>({T(1), T(0.75) + random_number<T>(random) / T(4)});
      case 1: return plane::Capsule<T>(T(0.3), T(0.8));
      default: return plane::Circle<T>(T(0.5));
      }
    }();
    const T turned = random_number<T>(random) * T(3), x = random_number<T>(random), y = random_number<T>(random),
            angular = random_number<T>(random) * T(2);
    const Vec linear{x, y - approach<T>(meeting, side)};
    plane::Dynamics<T> body;
    if (side > T(0)) body.density *= static_cast<T>(meeting.lighter);
    s.add({shape, {{off * side, side * T(2)}, plane::Rot2<T>::from_angle(turned)}, linear, angular}, body, m);
  }
  return play(s);
}

/// Expects of 200 pairs that none changes by more than `most`.
template <class F>
void expect_kept(const F& meet, const Encounter& meeting, double most) {
  int met = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Change change = meet(seed, meeting);
    EXPECT_LE(change.momentum, most) << seed;
    met += change.met ? 1 : 0;
  }
  EXPECT_GT(met, 150);
}

/// Without friction nothing but rounding is left of it: of each of 64 steps of some sub-steps.
TYPED_TEST(CommonPoint, PressingKeepsAngularMomentum) {
  using T = TypeParam;
  const Encounter smooth{0, false};
  const double rounding = 1024 * static_cast<double>(std::numeric_limits<T>::epsilon());
  expect_kept(meet_in_space<T>, smooth, rounding);
  expect_kept(meet_in_plane<T>, smooth, rounding);
}

/// What slides is moved by the mean of its velocities across the normal, which friction changes: by half of that in a
/// sub-step it acts beside the common point.
TYPED_TEST(CommonPoint, FrictionChangesItByAHundredth) {
  using T = TypeParam;
  const Encounter rough{0.6, false};
  expect_kept(meet_in_space<T>, rough, 0.0125);
  expect_kept(meet_in_plane<T>, rough, 0.0125);
}

/// Two that fly freely are both held back where they meet, each on its own way. Where they are held back in the steps
/// after it, as what turns into the other, they stand elsewhere than their impulses found them.
TYPED_TEST(CommonPoint, HoldingBackChangesItByAFewHundredths) {
  using T = TypeParam;
  for (const double friction : {0.0, 0.6})
    for (const Encounter& meeting : {Encounter{friction, true}, {friction, true, 1, 1}, {friction, true, 50, 1}}) {
      expect_kept(meet_in_space<T>, meeting, 0.04);
      expect_kept(meet_in_plane<T>, meeting, 0.04);
    }
}

}  // namespace
}  // namespace graze::testing
