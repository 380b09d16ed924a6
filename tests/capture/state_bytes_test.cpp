// Saved states go into bytes and come back: the run goes on with the same bits, and bytes that are no state are refused.
#include "graze/state_bytes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <random>

#include "dynamics/simulated.hpp"
#include "graze/error.hpp"

namespace graze::testing {
namespace {

/// A heap of boxes and balls that falls, two of them joined, one removed before.
template <class T>
void fill_space(Simulation<T>& s) {
  add_heap(s, 6, 30);
  const BodyId top = s.world().bodies().id(30), next = s.world().bodies().id(29);
  s.add(distance_joint<T>(top, {{T(0), T(1), T(0)}, {}}, next, {}, T(0), T(0.1)));
  s.remove(s.world().bodies().id(7));
  Material<T> belt;
  belt.surface_velocity = {T(1), T(0), T(0)};
  s.set_material(s.world().bodies().id(0), belt);
}

template <class T>
void fill_plane(plane::Simulation<T>& s) {
  plane::Body<T> ground{plane::Box<T>({T(20), T(1)})};
  ground.fixed = true;
  s.add(ground);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> draw(-2, 2);
  std::vector<BodyId> ids;
  for (int i = 0; i < 20; ++i) {
    plane::Body<T> body{i % 2 ? plane::Shape<T>(plane::Circle<T>(T(0.3)))
                              : plane::Shape<T>(plane::Box<T>({T(0.5), T(0.6)}))};
    body.pose.translation = {T(draw(random)), T(1 + 0.7 * i)};
    ids.push_back(s.add(body));
  }
  Joint<T, plane::Space<T>> joint;
  joint.a = ids[3];
  joint.b = ids[4];
  joint.frame_a.translation = {T(0), T(0.7)};
  JointLimit<T> held;
  held.axes = {true, true, false};
  joint.limits.push_back(held);
  s.add(joint);
  s.remove(ids[9]);
}

template <class T, class Space>
void step(Simulation<T, Space>& s, int count) {
  for (int i = 0; i < count; ++i) s.step(T(1) / T(60));
}

/// A state from the middle of a run, and what the run comes to.
template <class T, class Space, class Fill>
void expect_same_run(const Fill& fill) {
  const auto begin = [&](Simulation<T, Space>& s) { fill(s); };
  Simulation<T, Space> first;
  begin(first);
  step(first, 70);
  const std::string bytes = state_bytes(first.save());
  const std::uint64_t then = first.state_hash();
  step(first, 50);

  Simulation<T, Space> second;
  begin(second);
  step(second, 5);
  const State<T, Space> read = read_state<T, Space>(bytes);
  second.restore(read);
  EXPECT_EQ(second.state_hash(), then);
  EXPECT_EQ(state_bytes(second.save()), bytes);
  step(second, 50);
  EXPECT_EQ(second.state_hash(), first.state_hash());
}

template <class T>
class StateBytes : public ::testing::Test {};
using ScalarsOfBytes = ::testing::Types<float, double>;
TYPED_TEST_SUITE(StateBytes, ScalarsOfBytes);

TYPED_TEST(StateBytes, TheRunGoesOnInAnotherSimulation) {
  using T = TypeParam;
  expect_same_run<T, Space<T>>(fill_space<T>);
  expect_same_run<T, plane::Space<T>>(fill_plane<T>);
}

TYPED_TEST(StateBytes, OthersAreRefused) {
  using T = TypeParam;
  using Other = std::conditional_t<std::is_same_v<T, float>, double, float>;
  Simulation<T> s;
  fill_space(s);
  step(s, 30);
  const std::string bytes = state_bytes(s.save());
  EXPECT_THROW((read_state<Other, Space<Other>>(bytes)), InvalidValue);
  EXPECT_THROW((read_state<T, plane::Space<T>>(bytes)), InvalidValue);
  EXPECT_THROW((read_state<T>(bytes + '\0')), InvalidValue);
  EXPECT_THROW(state_bytes(State<T>()), InvalidValue);
  for (std::size_t length = 0; length < bytes.size(); length += 1 + length / 50)
    EXPECT_THROW((read_state<T>(std::string_view(bytes).substr(0, length))), InvalidValue) << length;
  std::string changed = bytes;
  for (std::size_t at = 0; at < bytes.size(); at += 1 + at / 50) {
    changed[at] = static_cast<char>(changed[at] ^ 4);
    EXPECT_THROW((read_state<T>(changed)), InvalidValue) << at;
    changed[at] = bytes[at];
  }
}

/// Bytes whose checksum fits are looked at number by number: a state that comes out of them can be gone back to and gone
/// on from, or is refused, and the simulation is then as it was.
TYPED_TEST(StateBytes, ForgedOnesAreRefusedOrHarmless) {
  using T = TypeParam;
  Simulation<T> s;
  fill_space(s);
  step(s, 60);
  const std::string bytes = state_bytes(s.save());
  const std::uint64_t then = s.state_hash();
  constexpr std::size_t sum_at = 18, body_at = sum_at + 8;
  std::mt19937 random(11);
  int refused = 0, taken = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string forged = bytes;
    for (int k = 0; k < 2; ++k) {
      const std::size_t at = body_at + random() % (bytes.size() - body_at - 8);
      const std::uint64_t value = std::array<std::uint64_t, 4>{~0ull, 0x7ff0000000000000u, random(), 0}[random() % 4];
      std::memcpy(forged.data() + at, &value, 1 + random() % 8);
    }
    std::uint64_t sum = 0xcbf29ce484222325u;
    for (const char byte : std::string_view(forged).substr(body_at))
      sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    std::memcpy(forged.data() + sum_at, &sum, sizeof(sum));
    State<T> state;
    try {
      state = read_state<T>(forged);
      s.restore(state);
      ++taken;
    } catch (const InvalidValue&) {
      ++refused;
      ASSERT_EQ(s.state_hash(), then);
      continue;
    }
    try {
      s.step(T(1) / T(60));
    } catch (const InvalidValue&) {  // longer than the longest step that the forger wrote
    }
    s.restore(read_state<T>(bytes));
    ASSERT_EQ(s.state_hash(), then);
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(taken, 100);
}

}  // namespace
}  // namespace graze::testing
