// Batches on the caller's threads: the answers of the calling thread alone, and the same arrays for any number.
#include <gtest/gtest.h>

#include "common/executors.hpp"
#include "query/crowd.hpp"

namespace graze::testing {
namespace {

/// Contacts of each pair, wherever its manifolds stand.
template <class T>
void expect_same_pairs(const BatchContacts<T>& found, const BatchContacts<T>& expected) {
  ASSERT_EQ(found.pairs.size(), expected.pairs.size());
  ASSERT_EQ(found.manifolds.size(), expected.manifolds.size());
  ASSERT_EQ(found.points.size(), expected.points.size());
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    ASSERT_EQ(found.pairs[i].overlap, expected.pairs[i].overlap);
    const auto here = found.manifolds_of(i), there = expected.manifolds_of(i);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t m = 0; m < here.size(); ++m) {
      ASSERT_TRUE(same_bits(here[m].normal, there[m].normal));
      const auto p = found.points_of(here[m]), q = expected.points_of(there[m]);
      ASSERT_EQ(p.size(), q.size());
      for (std::size_t k = 0; k < p.size(); ++k) ASSERT_TRUE(same_bits(p[k], q[k]));
    }
  }
}

/// Compact contacts are the full ones in fewer bytes, each pair's manifolds in their order.
template <class T>
void expect_compact(const CompactContacts<T>& found, const BatchContacts<T>& expected) {
  ASSERT_EQ(found.manifolds.size(), expected.manifolds.size());
  ASSERT_EQ(found.points.size(), expected.points.size());
  std::vector<std::size_t> told(expected.pairs.size(), 0);
  for (const auto& m : found.manifolds) {
    ASSERT_LT(m.pair, told.size());
    const auto manifolds = expected.manifolds_of(m.pair);
    ASSERT_LT(told[m.pair], manifolds.size());
    const auto& there = manifolds[told[m.pair]++];
    ASSERT_TRUE(same_bits(m.normal, there.normal));
    const auto p = found.points_of(m);
    const auto q = expected.points_of(there);
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t k = 0; k < p.size(); ++k) ASSERT_TRUE(same_bits(p[k].position, q[k].position()));
  }
}

/// Whatever runs the parts, and in whatever order, the arrays are the same.
template <class T>
void expect_same_arrays(const BatchContacts<T>& a, const BatchContacts<T>& b) {
  ASSERT_EQ(a.manifolds.size(), b.manifolds.size());
  for (std::size_t i = 0; i < a.pairs.size(); ++i) ASSERT_EQ(a.pairs[i].first_manifold, b.pairs[i].first_manifold);
  for (std::size_t m = 0; m < a.manifolds.size(); ++m)
    ASSERT_EQ(a.manifolds[m].first_point, b.manifolds[m].first_point);
}

template <class T>
void expect_same_on_threads(const Batch<T>& batch, T margin) {
  std::vector<std::uint8_t> touch, touch_here;
  std::vector<Distance<T>> distances, distances_here;
  BatchContacts<T> expected, first;
  CompactContacts<T> compact;
  overlap(batch, touch);
  distance(batch, distances);
  contacts(batch, margin, expected);
  ThreadExecutor three(3), one(1);
  BusyExecutor busy(true);
  for (Executor* executor :
       {static_cast<Executor*>(&three), static_cast<Executor*>(&one), static_cast<Executor*>(&busy)}) {
    overlap(batch, touch_here, executor);
    ASSERT_EQ(touch, touch_here);
    distance(batch, distances_here, executor);
    ASSERT_EQ(distances.size(), distances_here.size());
    for (std::size_t i = 0; i < distances.size(); ++i) ASSERT_TRUE(same_bits(distances[i], distances_here[i]));
    BatchContacts<T> found = expected;  // full of another answer
    contacts(batch, margin, found, executor);
    expect_same_pairs(found, expected);
    contacts(batch, margin, compact, executor);
    expect_compact(compact, expected);
    if (first.pairs.empty()) first = found;
    expect_same_arrays(found, first);
  }
}

template <class T>
class BatchThreads : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(BatchThreads, Scalars);

// Three parts, the last one short.
constexpr std::size_t many = 20'000;

TYPED_TEST(BatchThreads, AnswerPairsByIndex) {
  using T = TypeParam;
  const Crowd<T> crowd(200, 1);
  const Bodies<T> bodies = crowd.bodies();
  Random random(2);
  std::vector<IdPair> pairs;
  for (std::size_t i = 0; i < many; ++i)
    pairs.push_back({static_cast<std::uint32_t>(random() % 200), static_cast<std::uint32_t>(random() % 200)});
  expect_same_on_threads(Batch<T>(bodies, bodies, pairs), T(0.02));
}

TYPED_TEST(BatchThreads, AnswerPairsInOrder) {
  using T = TypeParam;
  const Crowd<T> crowd(many, 3), single(1, 4);
  const std::vector<Box<T>> boxes(many, Box<T>({T(0.5), T(1), T(0.25)}));
  const std::vector<Sphere<T>> sphere(1, Sphere<T>(T(0.5)));
  const std::vector<Pose<T>> reversed(crowd.poses.rbegin(), crowd.poses.rend());
  const Bodies<T> mixed = crowd.bodies(), of_boxes(boxes, reversed), one = single.bodies(), turned(sphere, reversed);
  expect_same_on_threads(Batch<T>(mixed, of_boxes), T(0.02));
  expect_same_on_threads(Batch<T>(of_boxes, Bodies<T>(boxes, crowd.poses)), T(0.02));
  expect_same_on_threads(Batch<T>(one, mixed), T(0));
  expect_same_on_threads(Batch<T>(of_boxes, turned), T(0));
}

TYPED_TEST(BatchThreads, FindNothingInNoPairs) {
  using T = TypeParam;
  const Crowd<T> crowd(3, 5);
  const Bodies<T> bodies = crowd.bodies();
  ThreadExecutor two(2);
  const Batch<T> none(bodies, bodies, std::span<const IdPair>{});
  std::vector<std::uint8_t> touch(3);
  overlap(none, touch, &two);
  EXPECT_TRUE(touch.empty());
  BatchContacts<T> found;
  contacts(Batch<T>(bodies, bodies), T(100), found);
  EXPECT_FALSE(found.points.empty());
  contacts(none, T(100), found, &two);
  EXPECT_TRUE(found.pairs.empty() && found.manifolds.empty() && found.points.empty());
}

}  // namespace
}  // namespace graze::testing
