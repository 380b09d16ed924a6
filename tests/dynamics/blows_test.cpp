// Blows passed on through bodies that touch: cradles, faces, and what must stay.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "graze/blows.hpp"

namespace graze::testing {
namespace {

/// Bodies that touch, and what is needed to strike them.
template <class T>
struct PairThatTouches {
  std::vector<StruckBody<T>> bodies;
  std::vector<Blow<T>> blows;
  std::vector<Vec3<T>> points;
  std::vector<T> impulses;

  void touch(std::uint32_t a, std::uint32_t b, const Vec3<T>& normal, T restitution, std::vector<Vec3<T>> at) {
    blows.push_back(
        {a, b, normal, restitution, static_cast<std::uint32_t>(points.size()), static_cast<std::uint32_t>(at.size())});
    points.insert(points.end(), at.begin(), at.end());
    impulses.resize(points.size());
  }
  PassedOn<T> pass(T resting_speed, std::size_t most = 1000) {
    return pass_on<T>(bodies, blows, points, impulses, resting_speed, most);
  }
};

/// Balls of radius 1/2 in a row, each touching the next.
template <class T>
PairThatTouches<T> row_of_balls(const std::vector<T>& masses, T restitution) {
  PairThatTouches<T> row;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const T inertia = masses[i] / T(10);
    row.bodies.push_back(
        {{{}, {}, {static_cast<T>(i), 0, 0}}, inverse_mass(masses[i], Vec3<T>{inertia, inertia, inertia})});
    const auto index = static_cast<std::uint32_t>(i);
    if (i > 0) row.touch(index - 1, index, {1, 0, 0}, restitution, {{static_cast<T>(i) - T(0.5), 0, 0}});
  }
  return row;
}

template <class T>
class Blows : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Blows, Scalars);

TYPED_TEST(Blows, OfACradleOnlyTheLastBallLeaves) {
  using T = TypeParam;
  PairThatTouches<T> cradle = row_of_balls<T>({1, 1, 1, 1, 1, 1}, T(1));
  cradle.bodies[0].motion.linear.x = T(5);
  const PassedOn<T> passed = cradle.pass(T(0.1));
  const T tiny = T(64) * std::numeric_limits<T>::epsilon();
  EXPECT_EQ(passed.struck, 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(cradle.bodies[i].motion.linear.x, 0, tiny) << i;
  EXPECT_NEAR(cradle.bodies[5].motion.linear.x, 5, tiny);
  // Two come in, two go out.
  cradle = row_of_balls<T>({1, 1, 1, 1, 1}, T(1));
  cradle.bodies[0].motion.linear.x = cradle.bodies[1].motion.linear.x = T(3);
  cradle.pass(T(0.1));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(cradle.bodies[i].motion.linear.x, i < 3 ? 0 : 3, tiny) << i;
}

TYPED_TEST(Blows, ABoxThatFallsFlatReboundsFlat) {
  using T = TypeParam;
  for (const T e : {T(0), T(0.5), T(1)}) {
    PairThatTouches<T> box;
    const T inertia = T(1) / T(6);
    box.bodies = {{}, {{{0, -4, 0}, {}, {0, T(0.5), 0}}, inverse_mass(T(1), Vec3<T>{inertia, inertia, inertia})}};
    const T h = T(0.5);
    box.touch(0, 1, {0, 1, 0}, e, {{-h, 0, -h}, {-h, 0, h}, {h, 0, h}, {h, 0, -h}});
    EXPECT_EQ(box.pass(T(0.1)).struck, 1u);
    const T tiny = T(256) * std::numeric_limits<T>::epsilon();
    EXPECT_NEAR(box.bodies[1].motion.linear.y, T(4) * e, tiny);
    EXPECT_LE(length(box.bodies[1].motion.angular), tiny);
    T together(0);
    for (const T j : box.impulses) together += j;
    EXPECT_NEAR(together, T(4) * (T(1) + e), tiny);
  }
}

TYPED_TEST(Blows, WithoutReboundWhatIsStruckMovesTogether) {
  using T = TypeParam;
  PairThatTouches<T> row = row_of_balls<T>({1, 2, 3}, T(0));
  row.bodies[0].motion.linear.x = T(6);
  const PassedOn<T> passed = row.pass(T(1e-3));
  EXPECT_LE(passed.approach, T(1e-3));
  for (const auto& body : row.bodies) EXPECT_NEAR(body.motion.linear.x, 1, 2e-3);
}

TYPED_TEST(Blows, WhatRestsAndWhatIsImmovableIsLeftAlone) {
  using T = TypeParam;
  PairThatTouches<T> row = row_of_balls<T>({1, 1}, T(1));
  row.bodies[0].motion.linear.x = T(0.05);
  EXPECT_EQ(row.pass(T(0.1)).struck, 0u);
  EXPECT_EQ(row.bodies[0].motion.linear.x, T(0.05));
  PairThatTouches<T> walls;
  walls.bodies.resize(2);
  walls.bodies[0].motion.linear.x = T(1);
  walls.touch(0, 1, {1, 0, 0}, T(1), {{}});
  EXPECT_EQ(walls.pass(T(0)).struck, 0u);
}

TYPED_TEST(Blows, NoMoreAreStruckThanAllowed) {
  using T = TypeParam;
  PairThatTouches<T> cradle = row_of_balls<T>({1, 1, 1, 1}, T(1));
  cradle.bodies[0].motion.linear.x = T(5);
  const PassedOn<T> passed = cradle.pass(T(0), 2);
  EXPECT_EQ(passed.struck, 2u);
  EXPECT_NEAR(passed.approach, T(5), 1e-5);
}

// Bodies of masses over three decades that touch at random places, each pair at up to four points.
RC_GTEST_PROP(Blows, MomentumStaysAndEnergyDoesNotGrow, (std::uint32_t seed)) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&](double size) { return Vec3d{unit(engine), unit(engine), unit(engine)} * size; };
  PairThatTouches<double> heap;
  std::vector<double> masses;
  std::vector<Mat3d> inertias;
  for (int i = 0; i < 5; ++i) {
    masses.push_back(std::pow(10, 1.5 * unit(engine)));
    inertias.push_back(Mat3d::diagonal(Vec3d{1, 1.5, 1.2} * masses.back()));
    heap.bodies.push_back({{vector(3), vector(3), vector(2)}, inverse_mass(masses.back(), inertias.back())});
  }
  for (std::uint32_t a = 0; a < 5; ++a)
    for (std::uint32_t b = a + 1; b < 5; ++b) {
      const Vec3d normal = normalized(vector(1)), middle = vector(2);
      std::vector<Vec3d> at;
      for (std::uint32_t i = 0; i <= (a + b) % 4; ++i) at.push_back(middle + vector(0.5));
      heap.touch(a, b, normal, std::abs(unit(engine)), at);
    }
  const auto energy = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < 5; ++i) sum += kinetic_energy(heap.bodies[i].motion, masses[i], inertias[i]);
    return sum;
  };
  const auto momentum = [&] {
    Vec3d sum{};
    for (std::size_t i = 0; i < 5; ++i) sum += heap.bodies[i].motion.linear * masses[i];
    return sum;
  };
  const double energy_before = energy();
  const Vec3d before = momentum();
  const PassedOn<double> passed = heap.pass(0.01, 10000);
  RC_ASSERT(passed.approach <= 0.01);
  RC_ASSERT(energy() <= energy_before * (1 + 1e-9));
  RC_ASSERT(length(momentum() - before) <= 1e-11 * std::sqrt(energy_before * 100));
  for (const double j : heap.impulses) RC_ASSERT(j >= 0.0);
}

}  // namespace
}  // namespace graze::testing
