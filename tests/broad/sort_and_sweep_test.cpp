// Sort and sweep against all pairs, and the filters behind it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "graze/pairs.hpp"

namespace graze {
namespace {

/// Boxes on a small grid, so that equal, touching, flat and nested ones are common.
Aabbd box_of(const std::array<int, 6>& n) {
  const auto low = [&](std::size_t i) { return static_cast<double>(n[i] % 20); };
  const auto size = [&](std::size_t i) { return static_cast<double>(std::abs(n[i + 3]) % 5); };
  return {{low(0), low(1), low(2)}, {low(0) + size(0), low(1) + size(1), low(2) + size(2)}};
}

std::vector<IdPair> brute_force(const std::vector<std::pair<std::uint32_t, Aabbd>>& boxes) {
  std::vector<IdPair> pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < boxes.size(); ++j)
      if (boxes[i].first < boxes[j].first && overlap(boxes[i].second, boxes[j].second))
        pairs.push_back({boxes[i].first, boxes[j].first});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

RC_GTEST_PROP(SortAndSweep, FindsTheSamePairsAsBruteForce, (const std::vector<std::array<int, 6>>& numbers)) {
  const auto broad = make_sort_and_sweep<double>();
  std::vector<std::pair<std::uint32_t, Aabbd>> boxes;
  for (std::uint32_t i = 0; i < numbers.size(); ++i) {
    boxes.push_back({i * 7, box_of(numbers[i])});
    broad->insert(i * 7, boxes.back().second);
  }
  std::vector<IdPair> found;
  broad->pairs(found);
  RC_ASSERT(found == brute_force(boxes));
  // Every third goes, every second moves.
  for (std::size_t i = boxes.size(); i-- > 0;) {
    if (i % 3 == 0) {
      broad->remove(boxes[i].first);
      boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(i));
    } else if (i % 2 == 0) {
      boxes[i].second = {boxes[i].second.lower + Vec3d{1, -2, 3}, boxes[i].second.upper + Vec3d{1, -2, 3}};
      broad->move(boxes[i].first, boxes[i].second);
    }
  }
  broad->pairs(found);
  RC_ASSERT(found == brute_force(boxes));
  for (const auto& [id, box] : boxes) {
    std::vector<std::uint32_t> near, expected;
    broad->query(box, near);
    for (const auto& [other, candidate] : boxes)
      if (overlap(box, candidate)) expected.push_back(other);
    std::sort(expected.begin(), expected.end());
    RC_ASSERT(near == expected);
  }
}

TEST(SortAndSweep, TakesInfiniteBoxesAndNamesWrongOnes) {
  const auto broad = make_sort_and_sweep<double>();
  broad->insert(1, Aabbd::everything());
  broad->insert(2, {{0, 0, 0}, {1, 1, 1}});
  std::vector<IdPair> pairs;
  broad->pairs(pairs);
  EXPECT_EQ(pairs, (std::vector<IdPair>{{1, 2}}));
  EXPECT_THROW(broad->insert(2, {{0, 0, 0}, {1, 1, 1}}), InvalidValue);
  EXPECT_THROW(broad->remove(3), InvalidValue);
  EXPECT_THROW(broad->move(2, {{0, 0, std::nan("")}, {1, 1, 1}}), InvalidValue);
}

RC_GTEST_PROP(Filter, IsSymmetric,
              (std::uint64_t c1, std::uint64_t m1, std::int8_t g1, std::uint64_t c2, std::uint64_t m2,
               std::int8_t g2)) {
  const Filter a{c1, m1, static_cast<std::int32_t>(g1 % 3)}, b{c2, m2, static_cast<std::int32_t>(g2 % 3)};
  RC_ASSERT(may_collide(a, b) == may_collide(b, a));
}

TEST(Filter, GroupsGoBeforeMasks) {
  EXPECT_TRUE(may_collide({1, 2, 0}, {2, 1, 0}));
  EXPECT_FALSE(may_collide({1, 2, 0}, {2, 2, 0}));
  EXPECT_TRUE(may_collide({1, 0, 5}, {1, 0, 5}));
  EXPECT_FALSE(may_collide({1, ~0u, -5}, {1, ~0u, -5}));
  EXPECT_TRUE(may_collide({1, ~0u, -5}, {1, ~0u, 5}));
}

TEST(Pairs, BoundsFiltersAndPredicate) {
  const std::vector<Aabbd> boxes(3, Aabbd{{0, 0, 0}, {1, 1, 1}});
  const std::vector<Filter> filters{{1, ~0u, 0}, {2, ~1u, 0}, {4, ~0u, 0}};  // 0 and 1 do not collide
  std::vector<IdPair> pairs;
  PairFinder<double>().find(boxes, pairs);
  keep_allowed(pairs, filters, [](std::uint32_t a, std::uint32_t b) { return a != 1 || b != 2; });
  EXPECT_EQ(pairs, (std::vector<IdPair>{{0, 2}}));
}

}  // namespace
}  // namespace graze
