// Manifolds joined by their normal: what it costs where thousands become one.
#include "composite/merge_manifolds.hpp"

#include <gtest/gtest.h>

#include <ctime>

namespace graze {
namespace {

/// So many manifolds of one normal, four points each, all of them different.
double seconds_to_join(std::size_t count) {
  double best = 1e300;
  for (int run = 0; run < 3; ++run) {
    Manifolds<double> manifolds;
    const std::clock_t begin = std::clock();
    ManifoldGroups<double> groups(manifolds);
    for (std::size_t i = 0; i < count; ++i) {
      Manifold<double> one;
      one.normal = {0, 1, 0};
      for (int k = 0; k < 4; ++k) {
        // In no order, as a tree finds them.
        const auto x = static_cast<double>((i * 4 + static_cast<std::size_t>(k)) * 7919 % 1000003);
        one.points.push_back({{x, 0, 1}, {x, 0, 1}, 0, 0, 0.5});
      }
      groups.add(one);
    }
    groups.finish();
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    EXPECT_EQ(manifolds.size(), 1u);
    EXPECT_EQ(manifolds[0].points.size(), 4 * count);
  }
  return best;
}

// Eight times as many take some ten times as long (n log n), not 64 times.
TEST(ManifoldGroups, TimeDoesNotGrowWithTheSquareOfOneManifold) {
  EXPECT_LT(seconds_to_join(24000), 24 * seconds_to_join(3000));
}

}  // namespace
}  // namespace graze
