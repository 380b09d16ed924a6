// Many bodies of a world moved by one call, against as many calls.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "graze/plane/world.hpp"
#include "graze/world.hpp"

namespace graze::testing {
namespace {

template <class Space>
struct BallOf;
template <class T>
struct BallOf<Space<T>> {
  static Shape<T> shape() { return Sphere<T>(T(1)); }
};
template <class T>
struct BallOf<plane::Space<T>> {
  static plane::Shape<T> shape() { return plane::Circle<T>(T(1)); }
};

/// A row of balls that touch their neighbours, and what takes every second of them elsewhere.
template <class Space>
struct RowOfBalls {
  using Vec = typename Space::Vec;
  using T = decltype(Vec{}.x);
  using Pose = typename Space::Pose;
  using Turning = typename Space::Turning;

  RowOfBalls() {
    for (int i = 0; i < 20; ++i) {
      Body<T, Space> ball{BallOf<Space>::shape()};
      ball.pose.translation.x = T(i);
      ids.push_back(world.add(ball));
      if (i % 2 != 0) continue;
      moved.push_back(ids.back());
      Pose to;
      to.translation.x = T(i);
      to.translation.y = T(i % 3);
      poses.push_back(to);
      Vec speed{};
      speed.x = T(i);
      linear.push_back(speed);
      angular.emplace_back();
    }
    world.update();
  }
  void expect_like(const RowOfBalls& other) const {
    for (const BodyId id : ids) {
      EXPECT_EQ(world.bodies().poses()[id.index], other.world.bodies().poses()[id.index]);
      EXPECT_EQ(world.bodies().linear()[id.index], other.world.bodies().linear()[id.index]);
      EXPECT_EQ(world.bodies().changed()[id.index], other.world.bodies().changed()[id.index]);
    }
  }

  World<T, Space> world;
  std::vector<BodyId> ids, moved;
  std::vector<Pose> poses;
  std::vector<Vec> linear;
  std::vector<Turning> angular;
};

template <class Space>
class ManyMoves : public ::testing::Test {};
using SpacesOfManyMoves = ::testing::Types<Space<float>, Space<double>, plane::Space<float>, plane::Space<double>>;
TYPED_TEST_SUITE(ManyMoves, SpacesOfManyMoves);

TYPED_TEST(ManyMoves, AreThoseOfOneCallEach) {
  RowOfBalls<TypeParam> together, alone;
  together.world.move(together.moved, together.poses, together.linear, together.angular);
  for (std::size_t i = 0; i < alone.moved.size(); ++i)
    alone.world.move(alone.moved[i], alone.poses[i], alone.linear[i], alone.angular[i]);
  together.expect_like(alone);
  together.world.update();
  alone.world.update();
  EXPECT_EQ(together.world.contacts().pairs.size(), alone.world.contacts().pairs.size());
}

TYPED_TEST(ManyMoves, LeaveVelocitiesAsTheyAre) {
  RowOfBalls<TypeParam> row;
  row.world.move(row.moved, row.poses, row.linear, row.angular);
  for (auto& pose : row.poses) pose.translation.y += 1;
  row.world.move(row.moved, row.poses);
  for (std::size_t i = 0; i < row.moved.size(); ++i) {
    EXPECT_EQ(row.world.bodies().linear()[row.moved[i].index], row.linear[i]);
    EXPECT_EQ(row.world.bodies().poses()[row.moved[i].index], row.poses[i]);
  }
  row.world.move(std::span<const BodyId>{}, {});
}

/// One that is refused keeps all the others where they are.
TYPED_TEST(ManyMoves, NothingMovesWhereOneIsRefused) {
  using Row = RowOfBalls<TypeParam>;
  using T = typename Row::T;
  const auto refused = [](const auto& spoil) {
    Row row;
    const Row before;
    spoil(row);
    std::string path;
    try {
      row.world.move(row.moved, row.poses, row.linear, row.angular);
    } catch (const InvalidValue& e) {
      path = e.path();
    }
    row.expect_like(before);
    return path;
  };
  EXPECT_EQ(refused([](Row& r) { r.moved.back().generation = 7; }), "body");
  EXPECT_EQ(refused([](Row& r) { r.poses.back().translation.x = std::numeric_limits<T>::infinity(); }),
            "pose.translation[0]");
  EXPECT_EQ(refused([](Row& r) { r.linear.back().y = std::numeric_limits<T>::quiet_NaN(); }), "linear[1]");
  EXPECT_EQ(refused([](Row& r) { r.poses.pop_back(); }), "poses");
  EXPECT_EQ(refused([](Row& r) { r.angular.pop_back(); }), "angular");
  EXPECT_EQ(refused([](Row& r) { r.linear.clear(); }), "linear");
}

}  // namespace
}  // namespace graze::testing
