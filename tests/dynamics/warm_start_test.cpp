// Simulations without warm starting: sub-steps begin without the impulses of the last one, in space and in the plane.
#include <gtest/gtest.h>

#include "graze/plane/simulation.hpp"
#include "graze/simulation.hpp"
#include "graze/state_bytes.hpp"

namespace graze::testing {
namespace {

template <class T, class Space>
struct StackWords;
template <class T>
struct StackWords<T, Space<T>> {
  static Body<T> box() { return {Box<T>({T(1), T(1), T(1)})}; }
  static Body<T> floor() { return {HalfSpace<T>()}; }
  static Vec3<T> up(T by) { return {T(0), by, T(0)}; }
};
template <class T>
struct StackWords<T, plane::Space<T>> {
  static plane::Body<T> box() { return {plane::Box<T>({T(1), T(1)})}; }
  static plane::Body<T> floor() { return {plane::HalfPlane<T>()}; }
  static plane::Vec2<T> up(T by) { return {T(0), by}; }
};

/// Boxes that stand on each other, with four sub-steps.
template <class T, class Space>
class Stack {
  using Words = StackWords<T, Space>;

 public:
  Simulation<T, Space> simulation;
  std::vector<BodyId> boxes;

  Stack(int count, bool warm_start) : simulation(settings(warm_start)) {
    auto floor = Words::floor();
    floor.fixed = true;
    simulation.add(floor);
    for (int i = 0; i < count; ++i) {
      auto box = Words::box();
      box.pose.translation = Words::up(T(0.5) + T(i));
      boxes.push_back(simulation.add(box));
    }
  }
  void step(int steps) {
    for (int i = 0; i < steps; ++i) simulation.step(T(1) / T(64));
  }
  /// How far the top has come down.
  T sunk() const { return T(boxes.size()) - T(0.5) - simulation.poses()[boxes.back().index].translation.y; }

 private:
  static SimulationSettings<T, Space> settings(bool warm_start) {
    SimulationSettings<T, Space> s;
    s.gravity = Words::up(T(-10));
    s.sleep = false;
    s.most_sub_steps = s.sub_steps;
    s.warm_start = warm_start;
    return s;
  }
};

template <class T>
class WarmStartOf : public ::testing::Test {};
using ScalarsOfWarmStart = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WarmStartOf, ScalarsOfWarmStart);

/// A stack is borne by the impulses of its contacts, each of which bears all above it: from nothing one pass does not
/// find them.
template <class T, class Space>
void expect_that_stacks_sink() {
  Stack<T, Space> warm(10, true), cold(10, false);
  for (auto* stack : {&warm, &cold}) stack->step(128);
  // One that begins anew each time stirs: what counts is its mean.
  T sunk_warm(0), sunk_cold(0);
  for (int i = 0; i < 64; ++i) {
    for (auto* stack : {&warm, &cold}) stack->step(1);
    sunk_warm += warm.sunk() / T(64);
    sunk_cold += cold.sunk() / T(64);
  }
  EXPECT_GT(sunk_warm, T(0));
  EXPECT_LT(sunk_warm, T(0.05));
  EXPECT_GT(sunk_cold, T(4) * sunk_warm);
}
TYPED_TEST(WarmStartOf, StacksSinkWithout) {
  expect_that_stacks_sink<TypeParam, Space<TypeParam>>();
  expect_that_stacks_sink<TypeParam, plane::Space<TypeParam>>();
}

/// One box lies still all the same, with the impulse that bears it: its rows alone have nothing to find.
template <class T, class Space>
void expect_that_one_box_is_borne() {
  Stack<T, Space> one(1, false);
  one.step(64);
  EXPECT_LT(std::abs(one.sunk()), T(2e-3));
  const auto& contacts = one.simulation.world().contacts();
  T borne(0);
  for (const auto& point : contacts.points) borne += point.impulse.y;
  const T weight = one.simulation.mass(one.boxes[0]) * T(10) / T(64);
  EXPECT_NEAR(std::abs(borne), weight, T(0.02) * weight);
}
TYPED_TEST(WarmStartOf, OneBoxIsBorneWithout) {
  expect_that_one_box_is_borne<TypeParam, Space<TypeParam>>();
  expect_that_one_box_is_borne<TypeParam, plane::Space<TypeParam>>();
}

/// The setting is part of states and of their bytes and hashes.
template <class T, class Space>
void expect_that_states_have_it() {
  Stack<T, Space> cold(3, false), warm(3, true);
  EXPECT_NE(cold.simulation.state_hash(), warm.simulation.state_hash());
  cold.step(20);
  const std::string bytes = state_bytes(cold.simulation.save());
  cold.step(20);
  warm.simulation.restore(read_state<T, Space>(bytes));
  EXPECT_FALSE(warm.simulation.settings().warm_start);
  warm.step(20);
  EXPECT_EQ(warm.simulation.state_hash(), cold.simulation.state_hash());
}
TYPED_TEST(WarmStartOf, StatesHaveIt) {
  expect_that_states_have_it<TypeParam, Space<TypeParam>>();
  expect_that_states_have_it<TypeParam, plane::Space<TypeParam>>();
}

/// A chain of balls holds its links at their lengths without it too: locked axes are solved at once.
TYPED_TEST(WarmStartOf, ChainsHoldWithout) {
  using T = TypeParam;
  SimulationSettings<T> settings;
  settings.warm_start = false;
  Simulation<T> s(settings);
  Body<T> post{Sphere<T>(T(0.1))};
  post.fixed = true;
  BodyId last = s.add(post);
  for (int i = 1; i <= 8; ++i) {
    const BodyId next = s.add({Sphere<T>(T(0.1)), {{T(i), T(0), T(0)}, {}}});
    s.add(ball_joint<T>(last, {{T(0.5), T(0), T(0)}, {}}, next, {{T(-0.5), T(0), T(0)}, {}}));
    last = next;
  }
  for (int i = 0; i < 300; ++i) {
    s.step(T(1) / T(60));
    for (std::uint32_t link = 1; link < 9; ++link) {
      const auto end = [&](std::uint32_t of, T x) { return transform(s.poses()[of], Vec3<T>{x, T(0), T(0)}); };
      ASSERT_LT(length(end(link - 1, T(0.5)) - end(link, T(-0.5))), T(0.02)) << i;
    }
  }
}

}  // namespace
}  // namespace graze::testing
