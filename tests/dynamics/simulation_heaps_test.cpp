// What collides at random keeps momentum, comes apart where it overlaps, and comes to rest.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "dynamics/simulated.hpp"

namespace graze::testing {
namespace {

template <class T>
class SimulationHeaps : public ::testing::Test {};
using ScalarsOfHeaps = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SimulationHeaps, ScalarsOfHeaps);

/// What collides in free space keeps momentum and angular momentum, and gains no energy.
RC_GTEST_PROP(Simulation, CollisionsConserve, (int seed)) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto number = [&] { return static_cast<double>(random() % 1024) / 512 - 1; };
  Simulation<double> s(settings<double>(0.0));
  Material<double> m;
  m.restitution = (random() % 2) != 0 ? 0.5 : 0.0;
  for (int i = 0; i < 6; ++i) {
    // From six sides, so far apart that none overlap at first.
    Vec3d at{number() / 4, number() / 4, number() / 4};
    at[static_cast<std::size_t>(i % 3)] += i < 3 ? 3 : -3;
    const double height = 1 + number() / 2;
    const Vec3d turn{number(), number(), number()}, spin{number(), number(), number()};
    s.add({Box<double>({1, height, 0.5}), {at, normalized(Quatd{turn.x, turn.y, turn.z, 1.5})}, at * -2.0, spin}, {},
          m);
  }
  const auto before = s.report();
  for (int i = 0; i < 100; ++i) s.step(dt);
  const auto after = s.report();
  const double size = 6 * 1000 * 6;
  RC_ASSERT(length(after.momentum - before.momentum) < 1e-9 * size);
  // Six of 1,000 at speed 6 that are pressed at places 6 dt apart.
  RC_ASSERT(length(after.angular_momentum - before.angular_momentum) < size * 6 * dt);
  RC_ASSERT(after.kinetic_energy < before.kinetic_energy * (1 + 1e-9));
}

/// Boxes that begin in one place come apart without being thrown: no faster than a fall from twice their size.
TYPED_TEST(SimulationHeaps, WhatBeginsInOneComesApart) {
  using T = TypeParam;
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<T>(random() % 1024) / T(512) - T(1); };
  Simulation<T> s(settings<T>());
  add_floor<T>(s);
  std::vector<BodyId> boxes;
  for (int i = 0; i < 8; ++i) {
    Vec3<T> at{number(), number(), number()};
    at = at * T(0.1) + Vec3<T>{T(0), T(0.7), T(0)};
    boxes.push_back(s.add({Box<T>({T(1), T(1), T(1)}), {at, {}}}));
  }
  T fastest(0);
  for (int i = 0; i < 10 * 64; ++i) {
    s.step(T(dt));
    for (const BodyId id : boxes) fastest = std::max(fastest, length(s.motion(id).linear));
  }
  EXPECT_LT(fastest, std::sqrt(T(2) * T(10) * T(2)));
  EXPECT_LT(s.report().deepest, T(0.02));
  for (const BodyId id : boxes) EXPECT_GT(s.poses()[id.index].translation.y, T(0.4));
}

/// Ten boxes on each other that overlap by so much of their size come apart no faster than one contact pushes, and none
/// is thrown: the tower grows to its height, and where it overlaps by no more than a tenth it stands. So do boxes that
/// are moved into each other when they have fallen for a step.
template <class T>
void expect_that_towers_grow(bool moved) {
  for (const double overlap : {0.01, 0.03, 0.1, 0.5}) {
    Simulation<T> s(settings<T>());
    add_floor<T>(s);
    std::vector<BodyId> boxes;
    const auto place = [](int i, double apart) { return Pose<T>{{T(0), T(0.5) + T(i) * T(apart), T(0)}, {}}; };
    for (int i = 0; i < 10; ++i)
      boxes.push_back(s.add({Box<T>({T(1), T(1), T(1)}), place(i, moved ? 2 : 1 - overlap)}));
    if (moved) {
      s.step(T(dt));
      for (int i = 0; i < 10; ++i) s.set_pose(boxes[static_cast<std::size_t>(i)], place(i, 1 - overlap));
    }
    T fastest(0), highest(0);
    for (int i = 0; i < 5 * 64; ++i) {
      s.step(T(dt));
      for (const BodyId id : boxes) {
        // A tower that was put in by half falls to a side later, and its boxes bounce.
        if (overlap <= 0.1 || i < 64) fastest = std::max(fastest, s.motion(id).linear.y);
        highest = std::max(highest, s.poses()[id.index].translation.y);
      }
    }
    EXPECT_LT(fastest, std::sqrt(T(10))) << overlap;
    EXPECT_LT(highest, T(9.5) + T(0.1)) << overlap;
    if (overlap > 0.1) continue;
    const Vec3<T> top = s.poses()[boxes.back().index].translation;
    EXPECT_NEAR(top.y, T(9.5), T(0.02)) << overlap;
    EXPECT_LT(std::abs(top.x) + std::abs(top.z), T(0.5)) << overlap;
  }
}
TYPED_TEST(SimulationHeaps, TowersThatOverlapGrow) { expect_that_towers_grow<TypeParam>(false); }
TYPED_TEST(SimulationHeaps, TowersThatAreMovedIntoOverlapGrow) { expect_that_towers_grow<TypeParam>(true); }

/// A heap of anything comes to rest, and nothing is a NaN on the way.
TEST(Simulation, HeapsComeToRest) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    Simulation<float> s(settings<float>(10.0f, true));
    add_heap(s, seed, 25);
    for (int i = 0; i < 20 * 64; ++i) s.step(float(dt));
    const auto r = s.report();
    EXPECT_TRUE(std::isfinite(r.kinetic_energy));
    EXPECT_LT(r.kinetic_energy, 5.0f) << seed;
    EXPECT_LT(r.deepest, 0.02f) << seed;
    for (const Posef& pose : s.poses().subspan(1)) EXPECT_GT(pose.translation.y, 0.1f) << seed;
  }
}

}  // namespace
}  // namespace graze::testing
