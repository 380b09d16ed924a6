// Colours of contacts: what shares a body that can be pushed has different ones, and large islands have the same bits
// on any threads, in space and in the plane.
#include "dynamics/colors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "common/executors.hpp"
#include "graze/plane/simulation.hpp"
#include "graze/simulation.hpp"

namespace graze::testing {
namespace {

std::vector<std::uint32_t> order_of(const Coloring& coloring) {
  return {coloring.order().begin(), coloring.order().end()};
}

/// A row of bodies on a floor, which is body 0: the floor takes no colour, neighbours take turns.
TEST(Colors, ARowOnAFloor) {
  const std::vector<std::uint8_t> movable{0, 1, 1, 1, 1};
  const std::vector<IslandLink> pairs{{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {2, 3}, {3, 4}};
  Coloring coloring;
  coloring.find(movable, pairs);
  // By hand: the floor's pairs first; then 1-2 and 3-4 have the second colour, and 2-3 the third.
  EXPECT_EQ(order_of(coloring), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 6, 5}));
  ASSERT_EQ(coloring.colors().size(), 3u);
  for (const auto& color : coloring.colors()) EXPECT_FALSE(color.ordered);
  EXPECT_EQ(coloring.colors()[1].first, 4u);
  EXPECT_EQ(coloring.colors()[1].end, 6u);
}

/// In random graphs no two pairs of a colour share a body that can be pushed, each pair has the first colour that is
/// free, and pairs of a colour stand in their own order.
TEST(Colors, GreedyInTheOrderOfPairs) {
  std::mt19937 generator(7);
  const auto random = [&] { return static_cast<std::uint32_t>(generator()); };
  Coloring coloring;
  for (int run = 0; run < 50; ++run) {
    const std::uint32_t bodies = 2 + random() % 60;
    std::vector<std::uint8_t> movable(bodies);
    for (std::uint8_t& m : movable) m = random() % 4 != 0 ? 1 : 0;
    std::vector<IslandLink> pairs(random() % (5 * bodies));
    for (IslandLink& p : pairs) {
      p.a = random() % bodies;
      p.b = (p.a + 1 + random() % (bodies - 1)) % bodies;
    }
    coloring.find(movable, pairs);
    const auto order = order_of(coloring);
    std::vector<std::size_t> color(pairs.size());
    for (std::size_t c = 0; c < coloring.colors().size(); ++c) {
      const Coloring::Range& range = coloring.colors()[c];
      ASSERT_FALSE(range.ordered);
      ASSERT_TRUE(std::is_sorted(order.begin() + range.first, order.begin() + range.end));
      for (std::uint32_t i = range.first; i < range.end; ++i) color[order[i]] = c;
    }
    // By brute force: the first colour that no earlier pair with a movable body in common has.
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      std::set<std::size_t> taken;
      for (std::size_t j = 0; j < i; ++j)
        for (const std::uint32_t x : {pairs[i].a, pairs[i].b})
          if (movable[x] != 0 && (pairs[j].a == x || pairs[j].b == x)) taken.insert(color[j]);
      std::size_t first = 0;
      while (taken.count(first) != 0) ++first;
      ASSERT_EQ(color[i], first) << i;
    }
  }
}

/// A hub that touches more than there are colours: the rest is solved in order.
TEST(Colors, MoreThanThereAre) {
  std::vector<IslandLink> pairs;
  for (std::uint32_t i = 1; i <= 100; ++i) pairs.push_back({0, i});
  Coloring coloring;
  coloring.find(std::vector<std::uint8_t>(101, 1), pairs);
  ASSERT_EQ(coloring.colors().size(), 64u);
  EXPECT_TRUE(coloring.colors().back().ordered);
  EXPECT_EQ(coloring.colors().back().end - coloring.colors().back().first, 37u);
  for (std::uint32_t i = 0; i < 100; ++i) EXPECT_EQ(coloring.order()[i], i);
}

/// A pyramid of so many contacts that its island is shared among threads.
constexpr int base = 28;

template <class Sim, class Add>
auto play(Executor* executor, const Add& add) {
  Sim s({}, executor);
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i) add(s, i + row / 2.0, row + 0.5 + 0.01 * ((3 * i + row) % 4));
  for (int i = 0; i < 6; ++i) s.step(1.0f / 64);
  // More points than 512 pairs can have in the plane, where a pair has two at most: the island is a large one.
  EXPECT_GT(s.report().contacts, 1024u);
  EXPECT_EQ(s.report().islands, 1u);
  EXPECT_GE(s.report().colors, 4u);
  return std::vector(s.poses().begin(), s.poses().end());
}

template <class Run>
void same_on_any_threads(const Run& run) {
  const auto serial = run(nullptr);
  for (const std::size_t count : {1u, 2u, 4u}) {
    ThreadExecutor threads(count);
    EXPECT_EQ(run(&threads), serial) << count;
  }
  BusyExecutor busy(true);
  EXPECT_EQ(run(&busy), serial);
}

TEST(Colors, ALargeIslandOfSpaceOnAnyThreads) {
  same_on_any_threads([](Executor* executor) {
    return play<Simulation<float>>(executor, [](Simulation<float>& s, double x, double y) {
      if (s.poses().empty()) {
        Body<float> floor{HalfSpace<float>()};
        floor.fixed = true;
        s.add(floor);
      }
      s.add({Box<float>({1, 1, 1}), {{float(x), float(y), 0}, {}}});
    });
  });
}

TEST(Colors, ALargeIslandOfThePlaneOnAnyThreads) {
  same_on_any_threads([](Executor* executor) {
    return play<plane::Simulation<float>>(executor, [](plane::Simulation<float>& s, double x, double y) {
      if (s.poses().empty()) {
        plane::Body<float> floor{plane::HalfPlane<float>()};
        floor.fixed = true;
        s.add(floor);
      }
      s.add({plane::Box<float>({1, 1}), {{float(x), float(y)}, {}}});
    });
  });
}

}  // namespace
}  // namespace graze::testing
