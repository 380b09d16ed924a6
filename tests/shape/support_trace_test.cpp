// Support queries step by step: the answer's own vertex, the best of each layer, and nothing counted that was not
// looked at.
#include "graze/shape/support_trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "common/specimen.hpp"
#include "graze/shape.hpp"

namespace graze::testing {
namespace {

template <class T>
std::vector<Vec3<T>> ellipsoid(std::size_t count, const Vec3d& radii, Random& random) {
  std::vector<Vec3<T>> points;
  while (points.size() < count) {
    const Vec3d p = converted<double>(random_vector(random, 1));
    if (const double l = length(p); l <= 1 && l > 0.1)
      points.push_back(converted<T>(Vec3d{radii.x * p.x / l, radii.y * p.y / l, radii.z * p.z / l}));
  }
  return points;
}

/// The greatest product of the vertices with the direction, by looking at all of them.
template <class T>
T greatest_of(const ConvexHull<T>& hull, const std::vector<std::uint32_t>& vertices, const Vec3<T>& d) {
  T most = -std::numeric_limits<T>::infinity();
  for (const std::uint32_t v : vertices) most = std::max(most, dot(hull.data().vertices[v], d));
  return most;
}

template <class T>
void check_trace(const ConvexHull<T>& hull, const std::vector<HullLayer>& layers, const Vec3<T>& d) {
  const SupportTrace trace = explain_support(hull, d);
  EXPECT_EQ(trace.vertex, hull.support_vertex(d));
  ASSERT_EQ(trace.layers.size(), layers.size());
  std::size_t products = 0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const SupportLayer& seen = trace.layers[i];
    products += seen.looked_at.size();
    EXPECT_EQ(seen.vertices, layers[i].vertices.size());
    ASSERT_EQ(seen.along.size(), seen.looked_at.size());
    for (std::size_t k = 0; k < seen.along.size(); ++k)
      EXPECT_EQ(static_cast<T>(seen.along[k]), dot(hull.data().vertices[seen.looked_at[k]], d));
    const std::set<std::uint32_t> there(layers[i].vertices.begin(), layers[i].vertices.end());
    for (const std::uint32_t v : seen.looked_at) EXPECT_TRUE(there.contains(v));
    EXPECT_TRUE(std::count(seen.looked_at.begin(), seen.looked_at.end(), seen.winner));
    // Coarser hulls are convex up to the tolerance to which the hull itself is.
    EXPECT_NEAR(dot(hull.data().vertices[seen.winner], d), greatest_of(hull, layers[i].vertices, d),
                hull.tolerance() * T(2) * length(d));
    if (i > 0 && !trace.scanned) {
      EXPECT_EQ(seen.looked_at.front(), trace.layers[i - 1].winner);
    }
  }
  EXPECT_EQ(trace.layers.back().winner, trace.vertex);
  EXPECT_EQ(trace.products, products);
}

template <class T>
class SupportTraces : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SupportTraces, Scalars);

TYPED_TEST(SupportTraces, GoDownLayerByLayerToTheFurthestVertex) {
  using T = TypeParam;
  Random random(21);
  for (const Vec3d radii : {Vec3d{1, 1, 1}, Vec3d{1.3, 0.9, 0.9}, Vec3d{2, 0.02, 0.02}})
    for (const std::size_t count : {40u, 300u, 3000u}) {
      const std::vector<Vec3<T>> points = ellipsoid<T>(count, radii, random);
      const ConvexHull<T> hull{std::span<const Vec3<T>>(points)};
      const std::vector<HullLayer> layers = hull_layers(hull);
      for (int i = 0; i < 100; ++i) check_trace<T>(hull, layers, converted<T>(random_vector(random, 3)));
    }
}

TYPED_TEST(SupportTraces, LookAtFewOfMany) {
  using T = TypeParam;
  Random random(22);
  const std::vector<Vec3<T>> points = ellipsoid<T>(10000, {1, 1, 1}, random);
  const ConvexHull<T> hull{std::span<const Vec3<T>>(points)};
  std::size_t most = 0;
  for (int i = 0; i < 200; ++i) {
    const SupportTrace trace = explain_support<T>(hull, converted<T>(random_vector(random, 1)));
    EXPECT_FALSE(trace.scanned);
    EXPECT_GE(trace.layers.size(), 4u);
    most = std::max(most, trace.products);
  }
  EXPECT_LT(most, 400u);
}

// Each layer is the hull of some of the next one's vertices: convex and closed, with Euler's number of edges.
TYPED_TEST(SupportTraces, LayersAreHullsInsideEachOther) {
  using T = TypeParam;
  Random random(23);
  const std::vector<Vec3<T>> points = ellipsoid<T>(2000, {1, 1, 1}, random);
  const ConvexHull<T> hull{std::span<const Vec3<T>>(points)};
  const std::vector<HullLayer> layers = hull_layers(hull);
  ASSERT_GE(layers.size(), 3u);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const HullLayer& layer = layers[i];
    std::set<std::uint32_t> ends;
    std::set<std::array<std::uint32_t, 2>> edges;
    for (const auto& [a, b] : layer.edges) {
      ends.insert(a), ends.insert(b);
      edges.insert({std::min(a, b), std::max(a, b)});
    }
    const std::set<std::uint32_t> vertices(layer.vertices.begin(), layer.vertices.end());
    EXPECT_EQ(vertices.size(), layer.vertices.size());
    EXPECT_EQ(ends, vertices);
    EXPECT_EQ(edges.size(), layer.edges.size()) << "an edge stands there twice";
    // Of triangles alone, which these are but for the hull itself, whose coplanar ones may be merged.
    if (i + 1 < layers.size()) {
      EXPECT_EQ(layer.edges.size(), 3 * layer.vertices.size() - 6);
      for (const std::uint32_t v : layer.vertices)
        EXPECT_TRUE(std::count(layers[i + 1].vertices.begin(), layers[i + 1].vertices.end(), v));
      EXPECT_LT(layer.vertices.size(), layers[i + 1].vertices.size());
    }
  }
  EXPECT_EQ(layers.back().vertices.size(), hull.data().vertices.size());
  EXPECT_EQ(layers.back().edges.size(), hull.data().edges.size());
}

TYPED_TEST(SupportTraces, SayThatSmallAndFlatHullsAreScanned) {
  using T = TypeParam;
  Random random(24);
  std::vector<std::vector<Vec3<T>>> sets{{{1, 2, 3}}, {{0, 0, 0}, {1, 0, 0}}, ellipsoid<T>(25, {1, 1, 1}, random)};
  sets.emplace_back();
  for (int i = 0; i < 50; ++i)
    sets.back().push_back({static_cast<T>(std::cos(i * 0.12566)), static_cast<T>(std::sin(i * 0.12566)), 0});
  for (const auto& points : sets) {
    const ConvexHull<T> hull{std::span<const Vec3<T>>(points)};
    const std::vector<HullLayer> layers = hull_layers(hull);
    ASSERT_EQ(layers.size(), 1u);
    for (int i = 0; i < 20; ++i) {
      const Vec3<T> d = converted<T>(random_vector(random, 1));
      const SupportTrace trace = explain_support(hull, d);
      EXPECT_TRUE(trace.scanned);
      EXPECT_EQ(trace.products, hull.data().vertices.size());
      check_trace<T>(hull, layers, d);
    }
  }
}

}  // namespace
}  // namespace graze::testing
