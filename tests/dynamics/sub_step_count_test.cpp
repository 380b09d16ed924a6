// How many sub-steps an island takes: what calls for more, how many at most, and how they become fewer.
#include "dynamics/sub_step_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace graze {

namespace {

constexpr double sixtieth = 1.0 / 60, gravity_here = 10;

/// Boxes of 1 m on each other, at rest: the lowest contact bears them all, the mean one half of them.
IslandLoad<double> tower(int boxes) {
  IslandLoad<double> load;
  load.strain = 2 * gravity_here * boxes;
  load.mean_strain = load.strain / 2;
  load.mean_borne = boxes;
  load.smallest = 1;
  return load;
}

/// The count to which an island comes under the same load for long.
int settled(const IslandLoad<double>& load, int least = 4, int most = 64) {
  int count = std::min(most_for_one, most);
  for (int i = 0; i < 200; ++i) count = sub_step_count(load, sixtieth, gravity_here, count, least, most);
  return count;
}

}  // namespace

TEST(SubStepCount, IsTheLeastWithoutLoad) {
  IslandLoad<double> load;
  load.smallest = 1;
  EXPECT_EQ(settled(load), 4);
  EXPECT_EQ(settled(load, 32), 32);
  EXPECT_EQ(settled(load, 1, 1), 1);
}

TEST(SubStepCount, GrowsWithTheHardestPressedContactUpToSixteen) {
  IslandLoad<double> load;
  load.smallest = 1;
  int before = 0;
  for (const double strain : {10.0, 100.0, 500.0, 1e6}) {
    load.strain = strain;
    const int count = sub_step_count(load, sixtieth, gravity_here, 4, 4, 64);
    EXPECT_GT(count, before) << strain;
    before = count;
  }
  EXPECT_EQ(before, 16);
}

/// What stands high gets more than sixteen, one more a step; what is still falling gets none.
TEST(SubStepCount, GrowsOneByOneWhereBodiesStandHigh) {
  IslandLoad<double> load = tower(60);
  int count = 16;
  for (int i = 17; i < 25; ++i) {
    count = sub_step_count(load, sixtieth, gravity_here, count, 4, 64);
    EXPECT_EQ(count, i);
  }
  EXPECT_GT(settled(tower(60)), settled(tower(50)));
  EXPECT_EQ(settled(tower(1000)), 64);
  EXPECT_EQ(settled(tower(1000), 4, 32), 32);
  EXPECT_LE(settled(tower(30)), 16);
  load.mean_square_speed = 1;
  EXPECT_EQ(sub_step_count(load, sixtieth, gravity_here, 16, 4, 64), 16);
}

/// A count that is high enough for the load is kept until it could be much lower, and then goes down one by one; above
/// sixteen not before the bodies are calm.
TEST(SubStepCount, FallsOneByOneWhenThereIsLittleLeftToBear) {
  EXPECT_EQ(sub_step_count(tower(60), sixtieth, gravity_here, 40, 4, 64), 40);
  IslandLoad<double> little = tower(2);
  EXPECT_EQ(sub_step_count(little, sixtieth, gravity_here, 40, 4, 64), 39);
  EXPECT_EQ(sub_step_count(little, sixtieth, gravity_here, 12, 4, 64), 11);
  little.mean_square_speed = 0.1;
  EXPECT_EQ(sub_step_count(little, sixtieth, gravity_here, 40, 4, 64), 40);
  EXPECT_EQ(sub_step_count(little, sixtieth, gravity_here, 12, 4, 64), 11);
}

/// Sub-steps so short that a body falls by little of its size, whatever else.
TEST(SubStepCount, IsEnoughForSmallBodiesToFallSlowly) {
  IslandLoad<double> grains;
  grains.smallest = 1e-4;
  const int count = settled(grains);
  EXPECT_GT(count, 16);
  EXPECT_LT(gravity_here * sixtieth * sixtieth / (count * count), 0.02 * grains.smallest);
}

/// Sizes times four and steps times two change nothing.
TEST(SubStepCount, HasNoUnits) {
  for (const int boxes : {1, 10, 40, 60, 90}) {
    const IslandLoad<double> load = tower(boxes);
    IslandLoad<double> large = load;
    large.strain /= 4;
    large.mean_strain /= 4;
    large.smallest *= 4;
    for (const int last : {4, 16, 17, 40})
      EXPECT_EQ(sub_step_count(load, sixtieth, gravity_here, last, 4, 64),
                sub_step_count(large, 2 * sixtieth, gravity_here, last, 4, 64));
  }
}

}  // namespace graze
