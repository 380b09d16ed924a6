// Saved states go into bytes and come back: the run goes on with the same bits, and bytes of no state are refused.
#include "graze/state_bytes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <random>

#include "capture/frames.hpp"
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
  const std::vector<plane::Shape<T>> shapes{plane::Circle<T>(T(0.3)), plane::Box<T>({T(0.5), T(0.6)})};
  for (std::size_t i = 0; i < 20; ++i) {
    plane::Body<T> body{shapes[i % 2]};
    body.pose.translation = {T(draw(random)), T(1 + 0.7 * double(i))};
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

/// The bytes that a body without contacts adds to a state.
template <class Space, class AnyBody>
std::size_t bytes_of(const AnyBody& body) {
  Simulation<double, Space> s;
  const std::size_t before = state_bytes(s.save()).size();
  s.add(body);
  return state_bytes(s.save()).size() - before;
}
TEST(StateBytesInDouble, ABodyTakesAsManyAsTheHeaderSays) {
  EXPECT_EQ(bytes_of<Space<double>>(Body<double>{Sphere<double>(1)}), 631u);
  EXPECT_EQ(bytes_of<plane::Space<double>>(plane::Body<double>{plane::Circle<double>(1)}), 391u);
}

/// The bytes of a state as version 2 wrote them, without whether it is warm started.
template <class T, class Space>
std::string of_version_2(std::string bytes) {
  constexpr std::size_t version_at = 14, sum_at = 18, body_at = sum_at + 8;
  // Behind the settings: a report, of counts and numbers, and two steps.
  constexpr std::size_t numbers = std::is_same_v<Space, plane::Space<T>> ? 10 : 13;
  bytes.erase(bytes.size() - (5 * sizeof(std::uint64_t) + sizeof(std::int32_t) + numbers * sizeof(T)) - 1, 1);
  bytes[version_at] = 2;
  const std::uint64_t sum = capture::checksum(std::string_view(bytes).substr(body_at));
  std::memcpy(bytes.data() + sum_at, &sum, sizeof(sum));
  return bytes;
}

template <class T, class Space, class Fill>
void expect_that_version_2_is_read(const Fill& fill) {
  Simulation<T, Space> s;
  fill(s);
  step(s, 30);
  const std::string bytes = state_bytes(s.save());
  EXPECT_EQ(state_bytes(read_state<T, Space>(of_version_2<T, Space>(bytes))), bytes);
}
TYPED_TEST(StateBytes, TheVersionBeforeIsRead) {
  using T = TypeParam;
  expect_that_version_2_is_read<T, Space<T>>(fill_space<T>);
  expect_that_version_2_is_read<T, plane::Space<T>>(fill_plane<T>);
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

/// The bytes of a state with others in two places, whose checksum fits.
std::string forged(std::string bytes, std::mt19937& random) {
  constexpr std::size_t sum_at = 18, body_at = sum_at + 8;
  for (int k = 0; k < 2; ++k) {
    const std::size_t at = body_at + random() % (bytes.size() - body_at - 8);
    const std::uint64_t value = std::array<std::uint64_t, 4>{~0ull, 0x7ff0000000000000u, random(), 0}[random() % 4];
    std::memcpy(bytes.data() + at, &value, 1 + random() % 8);
  }
  const std::uint64_t sum = capture::checksum(std::string_view(bytes).substr(body_at));
  std::memcpy(bytes.data() + sum_at, &sum, sizeof(sum));
  return bytes;
}

/// A state from forged bytes is refused, and the simulation as it was, or can be gone back to and gone on from with
/// finite motions.
template <class T, class Space, class Fill>
void expect_refused_or_harmless(const Fill& fill, int tries) {
  Simulation<T, Space> s;
  fill(s);
  step(s, 60);
  const std::string bytes = state_bytes(s.save());
  const std::uint64_t then = s.state_hash();
  std::mt19937 random(11);
  int refused = 0, taken = 0;
  for (int i = 0; i < tries; ++i) {
    try {
      s.restore(read_state<T, Space>(forged(bytes, random)));
      ++taken;
    } catch (const InvalidValue&) {
      ++refused;
      ASSERT_EQ(s.state_hash(), then);
      continue;
    }
    try {
      step(s, 1);
    } catch (const InvalidValue&) {  // longer than the longest step that the forger wrote
    }
    for (const auto& pose : s.poses()) ASSERT_TRUE(length(pose.translation) <= largest_magnitude<T> * T(2));
    s.restore(read_state<T, Space>(bytes));
    ASSERT_EQ(s.state_hash(), then);
  }
  EXPECT_GT(refused, tries / 30);
  EXPECT_GT(taken, tries / 30);
}

TYPED_TEST(StateBytes, ForgedOnesAreRefusedOrHarmless) {
  using T = TypeParam;
  expect_refused_or_harmless<T, Space<T>>(fill_space<T>, 2000);
  expect_refused_or_harmless<T, plane::Space<T>>(fill_plane<T>, 2000);
}

}  // namespace
}  // namespace graze::testing
