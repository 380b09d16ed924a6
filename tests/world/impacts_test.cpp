// What fast bodies are told they would meet, against casting every pair.
#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "common/executors.hpp"
#include "graze/cast.hpp"
#include "world/scenario.hpp"

namespace graze {
namespace {

using testing::Random;
using testing::ThreadExecutor;

template <class T>
class Impacts : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Impacts, Scalars);

/// A compound of a ball that turns about a point beside it reaches a wall by the ball's radius.
TYPED_TEST(Impacts, TurningCompoundsOfRoundShapesAreMet) {
  using T = TypeParam;
  const Shape<T> wall = Box<T>({T(1), T(10), T(10)});
  int met = 0;
  for (const Shape<T>& child : {Shape<T>(Sphere<T>(T(1))), Shape<T>(Capsule<T>(T(1), T(0.1)))})
    for (const T x : {T(2.2), T(2.4)}) {
      const Shape<T> shape = Compound<T>({{child, {{T(1), T(1), T(1)}, {}}}});
      const Pose<T> at{{x + T(0.5), T(0), T(0)}, {}};
      const Velocity<T> turning{{}, {T(0), T(0), T(-0.8)}};
      World<T> world;
      Body<T> body{shape, {}}, fixed{wall, at};
      body.fast = true;
      body.angular = turning.angular;
      fixed.fixed = true;
      world.add(body);
      world.add(fixed);
      world.update(T(1));
      const auto hit = cast(shape, Pose<T>{}, turning, wall, at, {}, T(1));
      ASSERT_EQ(world.impacts().size(), hit ? 1u : 0u) << x;
      if (!hit) continue;
      EXPECT_EQ(world.impacts()[0].hit.t, hit->t) << x;
      ++met;
    }
  EXPECT_GE(met, 2);
}

/// Bullets through thin walls, past each other and at each other.
TYPED_TEST(Impacts, FastBodiesAreToldWhatTheyWouldPassThrough) {
  using T = TypeParam;
  Random random(8);
  std::size_t met = 0;
  for (const std::size_t threads : {1, 3}) {
    ThreadExecutor executor(threads);
    World<T> world({}, &executor);
    for (int i = 0; i < 60; ++i) {
      Body<T> body = testing::random_body<T>(random, 3);
      const bool turns = random() % 2 == 0;
      if (body.shape.template as<HalfSpace<T>>()) continue;
      body.fast = i % 3 == 0 && !body.fixed;
      if (!body.fixed) body.linear = converted<T>(testing::random_vector(random, body.fast ? 40.0f : 2.0f));
      if (!body.fixed && turns) body.angular = converted<T>(testing::random_vector(random, 2));
      world.add(body);
    }
    const T duration(0.25);
    world.update(duration);
    std::map<std::pair<std::uint32_t, std::uint32_t>, T> found;
    T last(0);
    for (const Impact<T>& impact : world.impacts()) {
      EXPECT_GE(impact.hit.t, last);
      last = impact.hit.t;
      EXPECT_TRUE(found.emplace(std::pair(impact.a.index, impact.b.index), impact.hit.t).second);
    }
    std::size_t expected = 0;
    const auto& bodies = world.bodies();
    for (std::uint32_t i = 0; i < bodies.size(); ++i)
      for (std::uint32_t j = i + 1; j < bodies.size(); ++j) {
        if ((bodies.fast()[i] == 0 && bodies.fast()[j] == 0)) continue;
        if (!may_collide(bodies.filters()[i], bodies.filters()[j])) continue;
        const Body<T> a = bodies.body(bodies.id(i)), b = bodies.body(bodies.id(j));
        const auto hit = graze::cast<T>(a.shape, a.pose, {a.linear, a.angular}, b.shape, b.pose, {b.linear, b.angular},
                                        duration, CastOptions{Separating::ignored});
        expected += hit.has_value();
        const auto at = found.find({i, j});
        ASSERT_EQ(hit.has_value(), at != found.end()) << i << ' ' << j;
        EXPECT_TRUE(!hit || hit->t == at->second);
      }
    EXPECT_EQ(found.size(), expected);
    met += expected;
    world.update();
    EXPECT_TRUE(world.impacts().empty());
  }
  EXPECT_GT(met, 20u);
}

/// Whoever moves a body says where it is, not that it stands.
TYPED_TEST(Impacts, AMovedBodyKeepsItsVelocities) {
  using T = TypeParam;
  World<T> world;
  Body<T> wall{Shape<T>(Box<T>({T(0.1), T(4), T(4)}))};
  wall.fixed = true;
  world.add(wall);
  Body<T> bullet{Shape<T>(Sphere<T>(T(0.01))), {{T(-3), T(0), T(0)}, {}}, {T(50), T(0), T(0)}, {T(1), T(2), T(3)}};
  bullet.fast = true;
  const BodyId id = world.add(bullet);
  const Pose<T> nearer{{T(-2), T(0.5), T(0)}, {}};
  world.move(id, nearer);
  EXPECT_EQ(world.bodies().body(id).linear, bullet.linear);
  EXPECT_EQ(world.bodies().body(id).angular, bullet.angular);
  world.update(T(0.1));
  ASSERT_EQ(world.impacts().size(), 1u);
  EXPECT_NEAR(world.impacts()[0].hit.t, (T(2) - T(0.06)) / T(50), T(1e-6));
  // Other velocities are named, and so is none.
  world.move(id, nearer, {T(0), T(5), T(0)}, {});
  EXPECT_EQ(world.bodies().body(id).linear, (Vec3<T>{T(0), T(5), T(0)}));
  EXPECT_EQ(world.bodies().body(id).angular, Vec3<T>{});
  world.update(T(0.1));
  EXPECT_TRUE(world.impacts().empty());
}

/// A wall that its user moves is fixed and has a velocity: that counts whichever of the two bodies is the fast one.
TYPED_TEST(Impacts, AFixedBodyComesWithItsVelocity) {
  using T = TypeParam;
  for (const auto& [wall_speed, wall_fast, ball_speed, ball_fast, expected] :
       {std::tuple{T(0), false, T(-1), true, T(1)}, std::tuple{T(10), false, T(-1), true, T(1) / T(11)},
        std::tuple{T(10), false, T(0), true, T(0.1)}, std::tuple{T(10), true, T(0), false, T(0.1)},
        std::tuple{T(10), true, T(0), true, T(0.1)}}) {
    World<T> world;
    Body<T> wall{Shape<T>(Box<T>({T(1), T(1), T(1)})), {}, {wall_speed, T(0), T(0)}};
    wall.fixed = true;
    wall.fast = wall_fast;
    Body<T> ball{Shape<T>(Sphere<T>(T(0.5))), {{T(2), T(0), T(0)}, {}}, {ball_speed, T(0), T(0)}};
    ball.fast = ball_fast;
    world.add(wall);
    world.add(ball);
    world.update(T(1.5));
    ASSERT_EQ(world.impacts().size(), 1u) << wall_speed << ' ' << wall_fast << ' ' << ball_speed;
    EXPECT_NEAR(world.impacts()[0].hit.t, expected, T(1e-6));
  }
}

}  // namespace
}  // namespace graze
