// Batches of polygons of few vertices have the bits of each pair alone. CMake runs these at every level of the
// instruction set (lanes.plane_*).
#include <gtest/gtest.h>

#include <cstring>

#include "graze/plane/batch.hpp"
#include "plane/figures.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneBatchPolygons : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneBatchPolygons, Scalars);

/// A polygon of up to nine vertices: about a circle, in a strip, on a grid where edges are in line and parallel, or
/// regular, and now and then another shape with corners.
template <class T>
Shape<T> cornered(double scale, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto number = [&](double low, double high) {
    return static_cast<T>(scale * std::uniform_real_distribution<double>(low, high)(random));
  };
  const T rounding = random() % 4 == 0 ? number(0, 0.2) : T(0);
  const auto kind = random() % 10;
  if (kind == 0) {
    const T w = random() % 8 == 0 ? T(0) : number(0.2, 1), h = number(0.2, 1);
    return {Box<T>({w, h}), rounding};
  }
  if (kind == 1) {
    const T h = random() % 8 == 0 ? T(0) : number(0.2, 1), r = number(0, 0.4);
    return {Capsule<T>(h, r), rounding};
  }
  if (kind == 2) return {Circle<T>(number(0, 0.5)), rounding};
  std::vector<Vec2<T>> points(1 + random() % 9);
  const double start = uniform(random), uneven = random() % 2 == 0 ? 0 : 0.3;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double angle = start + 6.283185307179586 * (double(i) + uneven * uniform(random)) / double(points.size());
    Vec2d p{std::cos(angle) * 0.8, std::sin(angle) * 0.8};
    if (kind == 3) p.y = 1e-3 * uniform(random);
    if (kind == 4) p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2};
    points[i] = converted<T>(p * scale);
  }
  return {ConvexPolygon<T>(points), rounding};
}

template <class T>
struct Crowd {
  std::vector<Shape<T>> shapes;
  std::vector<Pose2<T>> poses;
  std::vector<IdPair> pairs;

  Crowd(double scale, std::mt19937& random) {
    for (int i = 0; i < 300; ++i) {
      shapes.push_back(cornered<T>(scale, random));
      poses.push_back(random_pose<T>(scale / 3, random));
      if (i % 8 == 0) poses.back().translation = {static_cast<T>(scale * (i % 3)), static_cast<T>(scale / 2 * (i % 5))};
    }
    for (int i = 0; i < 12000; ++i) {
      const auto a = static_cast<std::uint32_t>(random() % shapes.size());
      pairs.push_back({a, random() % 32 == 0 ? a : static_cast<std::uint32_t>(random() % shapes.size())});
    }
  }
};

template <class T>
bool same(const Vec2<T>& a, const Vec2<T>& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
template <class T>
bool same(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TYPED_TEST(PlaneBatchPolygons, HaveTheBitsOfEachPairAlone) {
  using T = TypeParam;
  std::mt19937 random(15);
  std::size_t points = 0;
  for (const double scale : {1e-4, 1.0, 1e5}) {
    const Crowd<T> crowd(scale, random);
    const Bodies<T> bodies(crowd.shapes, crowd.poses);
    const Batch<T> batch(bodies, bodies, crowd.pairs);
    const T margin = static_cast<T>(0.1 * scale);
    std::vector<std::uint8_t> touch;
    std::vector<Distance<T>> distances;
    BatchContacts<T> found;
    overlap(batch, touch);
    distance(batch, distances);
    contacts(batch, margin, found);
    for (std::size_t i = 0; i < crowd.pairs.size(); ++i) {
      const auto [p, q] = crowd.pairs[i];
      const Shape<T>&a = crowd.shapes[p], &b = crowd.shapes[q];
      const Pose2<T>&at_a = crowd.poses[p], &at_b = crowd.poses[q];
      const std::string pair = std::string(a.name()) + " and " + b.name() + ", pair " + std::to_string(i);
      ASSERT_EQ(touch[i] != 0, overlap(a, at_a, b, at_b)) << pair;
      const Distance<T> alone = distance(a, at_a, b, at_b);
      ASSERT_TRUE(same(distances[i].distance, alone.distance)) << pair;
      ASSERT_TRUE(same(distances[i].normal, alone.normal)) << pair;
      ASSERT_TRUE(same(distances[i].a, alone.a)) << pair;
      ASSERT_TRUE(same(distances[i].b, alone.b)) << pair;
      Manifolds<T> manifolds;
      ASSERT_EQ(contacts(a, at_a, b, at_b, margin, manifolds), found.pairs[i].overlap) << pair;
      ASSERT_EQ(found.manifolds_of(i).size(), manifolds.size()) << pair;
      for (std::size_t m = 0; m < manifolds.size(); ++m) {
        const auto& group = found.manifolds_of(i)[m];
        ASSERT_TRUE(same(group.normal, manifolds[m].normal)) << pair;
        const auto there = found.points_of(group);
        ASSERT_EQ(there.size(), manifolds[m].points.size()) << pair;
        for (std::size_t k = 0; k < there.size(); ++k, ++points) {
          ASSERT_TRUE(same(there[k].a, manifolds[m].points[k].a)) << pair;
          ASSERT_TRUE(same(there[k].b, manifolds[m].points[k].b)) << pair;
          ASSERT_TRUE(same(there[k].distance, manifolds[m].points[k].distance)) << pair;
          ASSERT_EQ(there[k].feature, manifolds[m].points[k].feature) << pair;
          ASSERT_TRUE(same(there[k].weight, manifolds[m].points[k].weight)) << pair;
        }
      }
    }
  }
  EXPECT_GT(points, 10000u);
}

}  // namespace
}  // namespace graze::plane
