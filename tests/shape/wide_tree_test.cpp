// The wide tree against a look at every piece: regions, rays, planes, and boxes that are all alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "common/specimen.hpp"
#include "shape/hierarchy_pairs.hpp"
#include "shape/wide_tree.hpp"

namespace graze::testing {
namespace {

template <class T>
std::vector<TreePiece<T>> random_pieces(Random& random, std::size_t count, float reach, float size, float offset) {
  std::vector<TreePiece<T>> pieces;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3<T> p = converted<T>(random_vector(random, reach)) + Vec3<T>{T(offset), T(0), T(0)};
    const Vec3<T> e = converted<T>(abs(random_vector(random, size)));
    pieces.push_back({{p - e, p + e}, i});
  }
  return pieces;
}

template <class T>
std::set<std::uint32_t> pieces_within(const WideTree<T>& tree, const Aabb<T>& region, T limit) {
  std::set<std::uint32_t> found;
  visit(
      tree, region, [&] { return limit; }, [&](std::uint32_t i) { EXPECT_TRUE(found.insert(i).second); });
  return found;
}

template <class T>
class WideTrees : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WideTrees, Scalars);

// Nothing that lies within the limit is missed, from a tenth of a millimetre to ten kilometres and far from the origin.
TYPED_TEST(WideTrees, FindEverythingNearARegion) {
  using T = TypeParam;
  Random random(1);
  for (const float scale : {1e-4f, 1.0f, 1e4f})
    for (const float offset : {0.0f, 1e3f, 1e6f})
      for (const std::size_t count : {1u, 2u, 4u, 5u, 9u, 100u, 1000u}) {
        const auto pieces = random_pieces<T>(random, count, scale, scale / 10, offset * scale);
        const WideTree<T> tree(pieces);
        EXPECT_EQ(tree.size(), count);
        for (int k = 0; k < 20; ++k) {
          const Vec3<T> p = converted<T>(random_vector(random, scale * 1.5f)) + Vec3<T>{T(offset * scale), T(0), T(0)};
          const Aabb<T> region = inflated(Aabb<T>{p, p}, T(scale * uniform(random, 0, 0.3f)));
          const T limit = T(scale * uniform(random, 0, 0.3f));
          const std::set<std::uint32_t> found = pieces_within(tree, region, limit);
          for (const auto& piece : pieces) {
            const bool near = BoxQuestion<T>{region}(piece.box) <= signed_square(limit);
            EXPECT_TRUE(!near || found.count(piece.number));
          }
        }
      }
}

// The nearest piece is found by a shrinking limit, and at the cost of few.
TYPED_TEST(WideTrees, AShrinkingLimitLeavesLittleToVisit) {
  using T = TypeParam;
  Random random(2);
  const auto pieces = random_pieces<T>(random, 20000, 10, 0.05f, 0);
  const WideTree<T> tree(pieces);
  std::size_t visited = 0;
  for (int k = 0; k < 50; ++k) {
    const Vec3<T> p = converted<T>(random_vector(random, 12));
    const BoxQuestion<T> question{{p, p}};
    T best = std::numeric_limits<T>::infinity(), expected = best;
    const auto distance = [&](const Aabb<T>& box) { return std::sqrt(std::max(question(box), T(0))); };
    visit(
        tree, question, [&] { return best; },
        [&](std::uint32_t i) {
          best = std::min(best, distance(pieces[i].box));
          ++visited;
        });
    for (const auto& piece : pieces) expected = std::min(expected, distance(piece.box));
    EXPECT_EQ(best, expected);
  }
  EXPECT_LT(visited / 50, 60u);
}

// Every box that a ray crosses, rays along axes and in the sides of boxes included.
TYPED_TEST(WideTrees, FindEverythingOnARay) {
  using T = TypeParam;
  Random random(3);
  std::vector<TreePiece<T>> pieces = random_pieces<T>(random, 500, 10, 1, 0);
  for (std::uint32_t i = 0; i < 500; ++i) {  // flat and aligned ones
    const Vec3<T> p{T(random() % 9), T(random() % 9), T(random() % 9)};
    pieces.push_back({{p, p + Vec3<T>{T(random() % 2), T(random() % 2), T(random() % 2)}}, 500 + i});
  }
  const WideTree<T> tree(pieces);
  const T inf = std::numeric_limits<T>::infinity();
  for (int k = 0; k < 300; ++k) {
    Vec3<T> origin = converted<T>(random_vector(random, 15)),
            direction = normalized(converted<T>(random_vector(random, 1)));
    if (k % 2 == 0) {
      origin = {T(random() % 9), T(random() % 9), T(random() % 9)};
      direction = {T(0), T(0), T(0)};
      direction[random() % 3] = random() % 2 == 0 ? T(1) : T(-1);
    }
    const Vec3<T> inverse{T(1) / direction.x, T(1) / direction.y, T(1) / direction.z};
    const RayQuestion<T> question{origin, inverse, T(0), inf, T(0)};
    std::set<std::uint32_t> found;
    visit_ray(
        tree, origin, inverse, [&] { return inf; }, [&](std::uint32_t i) { found.insert(i); });
    for (const auto& piece : pieces) {
      if (question(piece.box) < inf) {
        EXPECT_TRUE(found.count(piece.number));
      }
    }
    // The same with doubles on whatever the tree holds.
    std::size_t wide = 0;
    visit_ray(
        tree, converted<double>(origin), converted<double>(inverse), [&] { return 1e9; },
        [&](std::uint32_t) { ++wide; });
    EXPECT_GE(wide, found.size());
  }
}

// A ray that has found something looks no further, and `false` ends any visit.
TEST(WideTree, VisitsEndWhenTheyAreTold) {
  std::vector<TreePiece<double>> pieces;
  for (std::uint32_t i = 0; i < 1000; ++i) pieces.push_back({{{1.0 * i, -1, -1}, {1.0 * i + 0.5, 1, 1}}, i});
  const WideTree<double> tree(pieces);
  double end = 1e9;
  std::size_t visited = 0;
  const double inf = std::numeric_limits<double>::infinity();
  visit_ray(
      tree, Vec3d{100.6, 0, 0}, Vec3d{1, inf, inf}, [&] { return end; },
      [&](std::uint32_t i) {
        ++visited;
        if (i >= 101) end = std::min(end, i - 100.6);
      });
  EXPECT_NEAR(end, 0.4, 1e-12);
  EXPECT_LT(visited, 12u);
  visited = 0;
  EXPECT_FALSE(visit(
      tree, Aabbd{{0, 0, 0}, {1000, 0, 0}}, [] { return 0.0; }, [&](std::uint32_t) { return ++visited < 5; }));
  EXPECT_EQ(visited, 5u);
}

// Two trees under a relative pose: every pair whose boxes come within the limit, and each once.
TYPED_TEST(WideTrees, FindEveryPairOfTwo) {
  using T = TypeParam;
  Random random(4);
  for (int i = 0; i < 30; ++i) {
    const auto pieces_a = random_pieces<T>(random, 1 + random() % 200, 3, 0.3f, 0),
               pieces_b = random_pieces<T>(random, 1 + random() % 200, 3, 0.3f, 0);
    const WideTree<T> a(pieces_a), b(pieces_b);
    const Pose<T> b_in_a{converted<T>(random_vector(random, 4)), normalized(converted<T>(random_rotation(random)))};
    const T limit = T(uniform(random, 0, 0.5f));
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    visit_pairs(
        a, b, b_in_a, [&] { return limit; },
        [&](std::uint32_t p, std::uint32_t q) {
          EXPECT_TRUE(found.insert({p, q}).second);
        });
    for (const auto& p : pieces_a)
      for (const auto& q : pieces_b) {
        // The distance of the boxes' middles less their radii is less than that of the boxes.
        const T apart = length(p.box.center() - transform(b_in_a, q.box.center()));
        const auto inner = [](const Aabb<T>& box) {
          const Vec3<T> e = box.extent() * T(0.5);
          return least(e.x, least(e.y, e.z));
        };
        if (apart - inner(p.box) - inner(q.box) < limit * T(0.999)) {
          EXPECT_TRUE(found.count({p.number, q.number}));
        }
      }
  }
}

// Two sheets one above the other: the pairs looked at grow with the sheets and not with their product.
TEST(WideTree, TwoSheetsCostTheirSum) {
  const auto sheet = [](std::uint32_t n) {
    std::vector<TreePiece<double>> pieces;
    for (std::uint32_t i = 0; i < n * n; ++i) {
      const Vec3d p{1.0 * (i % n), 0, 1.0 * (i / n)};
      pieces.push_back({{p, p + Vec3d{1, 0, 1}}, i});
    }
    return WideTree<double>(std::move(pieces));
  };
  const WideTree<double> a = sheet(200);
  const Posed above{{0.5, 0.01, 0.5}, Quatd::from_axis_angle({0, 1, 0}, 0.1)};
  std::size_t pairs = 0;
  visit_pairs(
      a, a, above, [] { return 0.02; }, [&](std::uint32_t, std::uint32_t) { ++pairs; });
  EXPECT_GT(pairs, 40000u);
  EXPECT_LT(pairs, 40000u * 32);
}

// What no split tells apart: equal boxes, equal middles, boxes without extent, coordinates whose squares overflow.
TYPED_TEST(WideTrees, TakeWhatNoSplitTellsApart) {
  using T = TypeParam;
  const T big = std::numeric_limits<T>::max() / T(2), tiny = std::numeric_limits<T>::denorm_min();
  const auto tree_of = [](std::size_t count, const auto& box_of) {
    std::vector<TreePiece<T>> pieces;
    for (std::uint32_t i = 0; i < count; ++i) pieces.push_back({box_of(T(i)), i});
    return WideTree<T>(pieces);
  };
  const Aabb<T> everything{{-big, -big, -big}, {big, big, big}};
  const auto all = [&](const WideTree<T>& tree) { return pieces_within(tree, everything, T(0)).size(); };
  EXPECT_EQ(all(tree_of(3000, [](T) { return Aabb<T>{{1, 2, 3}, {1, 2, 3}}; })), 3000u);
  EXPECT_EQ(all(tree_of(3000, [](T i) { return Aabb<T>{{-i, -i, -i}, {i, i, i}}; })), 3000u);
  EXPECT_EQ(all(tree_of(3000, [&](T i) { return Aabb<T>{{tiny * i, 0, 0}, {tiny * i, 0, 0}}; })), 3000u);
  EXPECT_EQ(all(tree_of(3000, [&](T i) { return Aabb<T>{{-big, i, i}, {big, i, i}}; })), 3000u);
  EXPECT_EQ(all(tree_of(3000, [&](T i) { return Aabb<T>{{0, 0, 0}, {big / (i + 1), 0, 0}}; })), 3000u);
}

// Middles that halve a hundred times: each split by area would part one piece from all others.
TEST(WideTree, StaysShallowWhateverTheSplits) {
  std::vector<TreePiece<double>> pieces;
  double x = 1;
  for (std::uint32_t i = 0; i < 900; ++i, x /= 2) pieces.push_back({{{x, x, x}, {x, x, x}}, i});
  const WideTree<double> tree(pieces);
  EXPECT_EQ(pieces_within(tree, {{0, 0, 0}, {1, 1, 1}}, 0.0).size(), 900u);
}

TEST(WideTree, TakesAMillionEqualPieces) {
  std::vector<TreePiece<float>> pieces(1000000, {{{1, 1, 1}, {2, 2, 2}}, 7});
  const WideTree<float> tree(std::move(pieces));
  std::size_t count = 0;
  visit(
      tree, Aabbf{{0, 0, 0}, {1, 1, 1}}, [] { return 0.0f; }, [&](std::uint32_t) { ++count; });
  EXPECT_EQ(count, 1000000u);
}

}  // namespace
}  // namespace graze::testing
