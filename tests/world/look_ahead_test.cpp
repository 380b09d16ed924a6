// What a solver asks of a world between finding contacts and moving: impacts by velocities that it has just found, of
// bodies that it has just marked, and pairs that it has muted since.
#include <gtest/gtest.h>

#include "graze/world.hpp"

namespace graze::testing {
namespace {

TEST(LookAhead, ImpactsFollowTheVelocitiesOfNow) {
  Worldd world;
  Body<double> wall{Box<double>({0.5, 4.0, 4.0})};
  wall.fixed = true;
  wall.pose.translation = {5, 0, 0};
  const BodyId w = world.add(wall);
  const Posed at{};
  const BodyId ball = world.add({Sphere<double>(0.5), at});
  world.update(0.1);
  EXPECT_TRUE(world.impacts().empty());

  world.move(ball, at, {100, 0, 0}, {});
  world.find_impacts(0.1);
  EXPECT_TRUE(world.impacts().empty());  // nobody is marked
  world.set_fast(ball, true);
  world.find_impacts(0.1);
  ASSERT_EQ(world.impacts().size(), 1u);
  EXPECT_EQ(world.impacts()[0].a, w);
  EXPECT_NEAR(world.impacts()[0].hit.t, 0.0425, 1e-6);
  world.set_fast(ball, false);
  world.find_impacts(0.1);
  EXPECT_TRUE(world.impacts().empty());
  EXPECT_THROW(world.find_impacts(-1), InvalidValue);
}

TEST(LookAhead, PairsAreMutedAndHeardAgain) {
  Worldd world;
  world.add({Sphere<double>(1.0)});
  world.add({Sphere<double>(1.0)});
  world.update();
  EXPECT_EQ(world.contacts().pairs.size(), 1u);
  world.set_allow([](BodyId, BodyId) { return false; });
  world.update();
  EXPECT_TRUE(world.contacts().pairs.empty());
  world.set_allow({});
  world.update();
  EXPECT_EQ(world.contacts().pairs.size(), 1u);
}

}  // namespace
}  // namespace graze::testing
