// Manifolds joined by their normal: what it costs where thousands become one.
#include "composite/merge_manifolds.hpp"

#include <gtest/gtest.h>

namespace graze {
namespace {

/// One of many manifolds of one normal, four points each, all of them different and in no order, as a tree finds them.
Manifold<double> scattered_manifold(std::size_t number) {
  Manifold<double> one;
  one.normal = {0, 1, 0};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto x = static_cast<double>((number * 4 + k) * 7919 % 1000003);
    one.points.push_back({{x, 0, 1}, {x, 0, 1}, 0, 0, 0.5});
  }
  return one;
}

// A join goes through every point that is held. One after every manifold would go through the square of them; one
// whenever what is held has doubled, of which a new manifold of four points weighs three times its points, comes when
// they have grown by a third: all joins together go through 1 + 3/4 + 9/16 + ... = 4 times as many as there are.
TEST(ManifoldGroups, JoinsGoThroughAFewTimesAsManyPointsAsThereAre) {
  constexpr std::size_t count = 24000;
  Manifolds<double> manifolds;
  ManifoldGroups<double> groups(manifolds);
  std::size_t joins = 0, points_gone_through = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = manifolds.size();
    groups.add(scattered_manifold(i), {});
    if (manifolds.size() > before) continue;
    ++joins;
    points_gone_through += 4 * (i + 1);
  }
  groups.finish();
  EXPECT_GT(joins, 0u);
  EXPECT_LE(points_gone_through, 4 * 4 * count);
  EXPECT_EQ(manifolds.size(), 1u);
  EXPECT_EQ(manifolds[0].points.size(), 4 * count);
}

}  // namespace
}  // namespace graze
