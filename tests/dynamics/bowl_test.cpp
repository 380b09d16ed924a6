// Balls in a bowl: nothing but the solver's friction and damping of contacts brings to rest what can roll, and they
// rest on triangles, edges and each other.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/simulation.hpp"

namespace graze::testing {
namespace {

/// The part of a sphere of radius 3 about (0, 3, 0) within 75 degrees of straight down, in rings of triangles.
template <class T>
Mesh<T> bowl() {
  constexpr int rings = 8, around = 24;
  const double pi = std::acos(-1.0), radius = 3;
  std::vector<Vec3<T>> vertices{{}};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto at = [](int ring, int i) { return static_cast<std::uint32_t>(1 + (ring - 1) * around + i % around); };
  for (int ring = 1; ring <= rings; ++ring)
    for (int i = 0; i < around; ++i) {
      const double up = ring * 75 * pi / 180 / rings, turn = 2 * pi * i / around;
      vertices.push_back(converted<T>(Vec3d{radius * std::sin(up) * std::cos(turn), radius * (1 - std::cos(up)),
                                            radius * std::sin(up) * std::sin(turn)}));
      if (ring == 1) {
        triangles.push_back({0, at(1, i + 1), at(1, i)});
        continue;
      }
      triangles.push_back({at(ring - 1, i), at(ring - 1, i + 1), at(ring, i + 1)});
      triangles.push_back({at(ring - 1, i), at(ring, i + 1), at(ring, i)});
    }
  return Mesh<T>(vertices, triangles);
}

template <class T>
class Bowl : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Bowl, Scalars);

TYPED_TEST(Bowl, TwentyBallsComeToRestInIt) {
  using T = TypeParam;
  constexpr T radius = T(0.25);
  Simulation<T> simulation;
  Body<T> ground{bowl<T>()};
  ground.fixed = true;
  simulation.add(ground);
  std::vector<BodyId> balls;
  for (int i = 0; i < 20; ++i) {
    Body<T> ball{Sphere<T>(radius)};
    // Nowhere above one another, and not evenly.
    ball.pose.translation = {T(0.7 * std::sin(2.4 * i)), T(1 + 0.55 * i), T(0.7 * std::cos(2.4 * i))};
    balls.push_back(simulation.add(ball));
  }
  int steps = 0;
  const int most = 20 * 60;
  while (steps < most && (steps == 0 || simulation.report().awake > 0)) simulation.step(T(1) / 60), ++steps;
  EXPECT_LT(steps, most);
  EXPECT_LT(simulation.report().deepest, T(0.001));
  EXPECT_EQ(simulation.report().kinetic_energy, T(0));
  for (const BodyId ball : balls) {
    EXPECT_TRUE(simulation.asleep(ball));
    // Inside: no centre is further from the bowl's centre than the sphere of the balls' centres, up to a contact's
    // depth.
    const Vec3<T> from_center = simulation.poses()[ball.index].translation - Vec3<T>{0, 3, 0};
    EXPECT_LT(length(from_center), T(3) - radius + T(0.005));
  }
}

}  // namespace
}  // namespace graze::testing
