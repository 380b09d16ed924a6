// The dynamic tree's own questions, and that it stays a good tree: the pairs it finds are tested with all broad phases.
#include "graze/dynamic_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <thread>

#include "broad/id_table.hpp"
#include "broad/pair_sort.hpp"

namespace graze {
namespace {

struct Random {
  std::mt19937 bits{3};

  double operator()(double low, double high) { return low + (high - low) * static_cast<double>(bits()) / 4294967296.0; }
  Vec3d point(double range) { return {(*this)(-range, range), (*this)(-range, range), (*this)(-range, range)}; }
  Aabbd box(double range, double size) {
    const Vec3d center = point(range), half{(*this)(0, size), (*this)(0, size), (*this)(0, size)};
    return {center - half, center + half};
  }
};

std::vector<Aabbd> boxes_of(std::size_t n, double range) {
  Random random;
  std::vector<Aabbd> boxes;
  for (std::size_t i = 0; i < n; ++i) boxes.push_back(random.box(range, i % 50 == 0 ? 5 : 0.5));
  return boxes;
}

/// In long double, axis by axis.
double distance(const Aabbd& a, const Aabbd& b) {
  long double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const long double gap = std::max<long double>(
        {0, static_cast<long double>(b.lower[i]) - a.upper[i], static_cast<long double>(a.lower[i]) - b.upper[i]});
    sum += gap * gap;
  }
  return static_cast<double>(std::sqrt(sum));
}

TEST(DynamicTree, NearestFindsTheNearestWithoutLookingAtMost) {
  const auto boxes = boxes_of(5000, 30);
  DynamicTree<double> tree;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) tree.insert(i, boxes[i]);
  Random random;
  std::size_t seen = 0;
  for (int i = 0; i < 200; ++i) {
    const Aabbd from = random.box(60, i % 2);
    double expected = std::numeric_limits<double>::infinity(), found = expected;
    for (const Aabbd& box : boxes) expected = std::min(expected, distance(from, box));
    tree.nearest(from, found, [&](std::uint32_t id, const Aabbd& box) {
      EXPECT_EQ(box, boxes[id]);
      ++seen;
      return found = std::min(found, distance(from, box));
    });
    ASSERT_EQ(found, expected);
  }
  EXPECT_LT(seen, 200 * 20);
}

TEST(DynamicTree, NearestKeepsToTheLimitAndStopsWhenTold) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  DynamicTree<double> tree;
  for (std::uint32_t i = 0; i < 100; ++i) tree.insert(i, {{i * 2.0, 0, 0}, {i * 2.0 + 1, 1, 1}});
  tree.insert(500, {{-inf, 1e9, -inf}, {inf, inf, inf}});
  const Aabbd origin{{-1, 0, 0}, {-1, 0, 0}};
  const auto count = [&](double limit, double then) {
    int calls = 0;
    tree.nearest(origin, limit, [&](std::uint32_t, const Aabbd&) {
      ++calls;
      return then;
    });
    return calls;
  };
  EXPECT_EQ(count(0.5, 0.5), 0);
  EXPECT_EQ(count(1, 1), 1);
  EXPECT_EQ(count(10, 10), 5);  // at 1, 3, 5, 7, 9
  EXPECT_EQ(count(inf, inf), 101);
  EXPECT_EQ(count(inf, -1), 1);
  EXPECT_EQ(count(-1, -1), 0);
  EXPECT_EQ(count(1e300, 1e300), 101);
}

TEST(DynamicTree, NearestNeitherOverflowsNorUnderflows) {
  for (const float scale : {1e-30f, 1e30f}) {
    DynamicTree<float> tree;
    for (std::uint32_t i = 0; i < 50; ++i) {
      const float x = scale * static_cast<float>(i + 1);
      tree.insert(i, {{x, x, x}, {x, x, x}});
    }
    std::uint32_t first = 99;
    tree.nearest({}, std::numeric_limits<float>::max(), [&](std::uint32_t id, const Aabbf&) {
      first = id;
      return -1.0f;
    });
    EXPECT_EQ(first, 0u);
  }
}

TEST(DynamicTree, VisitsWhatAnyPredicateAccepts) {
  const auto boxes = boxes_of(1000, 20);
  DynamicTree<double> tree;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) tree.insert(i, boxes[i]);
  // Above a tilted plane: no box could ask that.
  const auto accept = [](const Aabbd& box) { return box.upper.x + box.upper.y + box.upper.z >= 10; };
  std::vector<std::uint32_t> found, expected;
  tree.visit(accept, [&](std::uint32_t id, const Aabbd&) { found.push_back(id); });
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (accept(boxes[i])) expected.push_back(i);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
}

TEST(DynamicTree, FollowsARayFromNearToFarAndMissesNothing) {
  Random random;
  DynamicTree<float> tree;
  std::vector<Aabbf> boxes;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Aabbd box = random.box(20, i % 3 == 0 ? 0 : 1);  // some are points
    boxes.push_back({converted<float>(box.lower), converted<float>(box.upper)});
    tree.insert(i, boxes.back());
  }
  std::size_t crossed = 0, told = 0;
  for (int k = 0; k < 1500; ++k) {
    // Half of them through a corner of a box, a third along a side of it.
    const Aabbf& aimed = boxes[random.bits() % boxes.size()];
    const Vec3f from = k % 3 == 0 ? Vec3f{aimed.lower.x, aimed.upper.y, -30} : converted<float>(random.point(25));
    Vec3d way = converted<double>(aimed.upper) - converted<double>(from);
    if (k % 3 == 0) way = {0, 0, 1};
    if (k % 2 != 0 && k % 3 != 0) way = random.point(1);
    const NodeRay<float> ray(from, way, 0);
    constexpr float most = std::numeric_limits<float>::max();
    std::vector<std::uint32_t> found;
    tree.in_order([&](const auto& node, auto& out) { node.entries(ray, out); }, most,
                  [&](std::uint32_t id, const Aabbf&) {
                    found.push_back(id);
                    return most;
                  });
    std::sort(found.begin(), found.end());
    told += found.size();
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      // Slabs in double, with no allowance for rounding.
      double enter = 0, leave = std::numeric_limits<double>::infinity();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double o = double(from[axis]), low = double(boxes[i].lower[axis]) - o,
                     high = double(boxes[i].upper[axis]) - o;
        if (way[axis] == 0 && (low > 0 || high < 0)) leave = -1;
        if (way[axis] == 0) continue;
        enter = std::max(enter, std::min(low / way[axis], high / way[axis]));
        leave = std::min(leave, std::max(low / way[axis], high / way[axis]));
      }
      if (!(enter <= leave)) continue;
      ++crossed;
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), i)) << "ray " << k << ", box " << i;
    }
  }
  EXPECT_GT(crossed, 1000u);
  EXPECT_LT(told, crossed + crossed / 4);
}

/// Drifting, jumping, coming and going for long: what it costs to ask stays what a new tree costs.
TEST(DynamicTree, StaysAsGoodAsANewOne) {
  constexpr std::uint32_t n = 2000;
  std::vector<Aabbd> boxes = boxes_of(n, 20);
  DynamicTree<double> tree;
  for (std::uint32_t i = 0; i < n; ++i) tree.insert(i, boxes[i]);
  Random random;
  std::vector<IdPair> pairs;
  for (std::uint32_t frame = 0; frame < 150; ++frame) {
    for (std::uint32_t i = 0; i < n; ++i) {
      if (i % 100 == frame % 100) {
        tree.remove(i);
        tree.insert(i, boxes[i] = random.box(20, i % 50 == 0 ? 5 : 0.5));
      } else {
        const Vec3d by{0.02 * (i % 7), 0.03 * (i % 5) - 0.06, 0.05 * (i % 3) - 0.05};
        tree.move(i, boxes[i] = {boxes[i].lower + by, boxes[i].upper + by});
      }
    }
    tree.moved_pairs(pairs);
  }
  DynamicTree<double> fresh;
  for (std::uint32_t i = 0; i < n; ++i) fresh.insert(i, boxes[i]);
  const auto cost = [&](const DynamicTree<double>& t) {
    std::size_t tests = 0;
    for (const Aabbd& box : boxes)
      t.visit([&](const Aabbd& other) { return ++tests, overlap(box, other); }, [](std::uint32_t, const Aabbd&) {});
    return tests;
  };
  EXPECT_LT(cost(tree), 2 * cost(fresh));
  EXPECT_LT(tree.memory(), 2 * fresh.memory());
}

/// The first question after a change brings the tree up to date, whichever thread asks it.
TEST(DynamicTree, MayBeAskedFromSeveralThreads) {
  const auto boxes = boxes_of(2000, 20);
  DynamicTree<double> tree;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) tree.insert(i, boxes[i]);
  std::vector<std::uint32_t> found[4];
  std::vector<std::thread> threads;
  for (auto& out : found) threads.emplace_back([&tree, &out] { tree.query({{-5, -5, -5}, {5, 5, 5}}, out); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_FALSE(found[0].empty());
  for (const auto& out : found) EXPECT_EQ(out, found[0]);
}

/// One place after the other in the same spot: the worst that can be put into a tree one by one.
TEST(DynamicTree, TakesThousandsInOnePlaceOneByOne) {
  DynamicTree<float> tree;
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    tree.insert(i, {});
    tree.query({{1, 1, 1}, {1, 1, 1}}, found);
  }
  tree.query({}, found);
  EXPECT_EQ(found.size(), 3000u);
}

TEST(IdTable, HoldsIdsNearAndFar) {
  IdTable table;
  Random random;
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < 2000; ++i)
    ids.push_back(i % 3 == 0 ? static_cast<std::uint32_t>(random.bits()) : 5000 - i);
  for (std::uint32_t i = 0; i < ids.size(); ++i) {
    ASSERT_EQ(table.find(ids[i]), IdTable::none);
    table.insert(ids[i], i);
  }
  for (std::uint32_t i = 0; i < ids.size(); ++i) ASSERT_EQ(table.find(ids[i]), i);
  EXPECT_EQ(table.size(), ids.size());
  EXPECT_LT(table.memory(), ids.size() * 64);
  for (const std::uint32_t id : ids) table.erase(id);
  for (const std::uint32_t id : ids) ASSERT_EQ(table.find(id), IdTable::none);
}

TEST(PairSort, SortsFewAndManyPairsAnId) {
  PairSort sort;
  Random random;
  for (const std::uint32_t ids : {2u, 100u, 5000u, 4000000000u}) {
    std::vector<IdPair> pairs;
    for (std::uint32_t i = 0; i < 20000; ++i) {
      const auto a = static_cast<std::uint32_t>(random(0, random(0, ids))),
                 b = static_cast<std::uint32_t>(random(0, ids));
      pairs.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<IdPair> sorted = pairs;
    std::shuffle(sorted.begin(), sorted.end(), random.bits);
    sort(sorted, std::min(ids, 10000u));
    EXPECT_EQ(sorted, pairs) << ids;
  }
}

}  // namespace
}  // namespace graze
