// The features that contact points of the plane name: their corners are where the points are.
#include "graze/plane/feature_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "plane/figures.hpp"

namespace graze::plane {
namespace {

template <class T>
struct PlaneFeatures : ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneFeatures, Scalars);

/// How far a point is from the segment between the first and the last of these corners.
double off_corners(const Vec2d& p, const std::vector<Vec2d>& corners) {
  const Vec2d a = corners.front(), d = corners.back() - a;
  const double along = dot(d, d) > 0 ? std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0) : 0;
  return length(p - (a + d * along));
}

template <class T>
std::vector<Vec2d> corners_in_world(const Shape<T>& shape, const Pose2<T>& pose, const Feature& feature) {
  std::vector<Vec2d> corners;
  for (const Vec2<T>& corner : feature_corners(shape, 0, feature))
    corners.push_back(converted<double>(transform(pose, corner)));
  return corners;
}
/// What all points of a manifold name of one shape.
template <class T>
std::vector<Vec2d> all_corners(const Shape<T>& shape, const Pose2<T>& pose, const Manifold<T>& manifold,
                               Feature (*of)(std::uint32_t)) {
  std::vector<Vec2d> corners;
  for (const ContactPoint<T>& p : manifold.points)
    for (const Vec2d& corner : corners_in_world(shape, pose, of(p.feature))) corners.push_back(corner);
  return corners;
}
/// How far a point is from what a manifold's points name together or, of a vertex alone, from the edges that meet
/// there.
template <class T>
double off_feature(const Vec2d& p, const Shape<T>& shape, const Pose2<T>& pose, const std::vector<Vec2d>& corners) {
  double nearest = off_corners(p, corners);
  if (corners.size() > 1) return nearest;
  for (std::uint32_t i = 0;; ++i) {
    const auto edge = corners_in_world(shape, pose, {FeatureKind::edge, i});
    if (edge.empty()) return nearest;
    if (edge[0] == corners[0] || edge[1] == corners[0]) nearest = std::min(nearest, off_corners(p, edge));
  }
}

/// Radius of the disc that rounds the core, which its corners are of.
template <class T>
double rounding_of(const Shape<T>& shape) {
  const auto* capsule = shape.template as<Capsule<T>>();
  return double(shape.rounding()) +
         (capsule ? std::max(double(capsule->radius_bottom()), double(capsule->radius_top())) : 0.0);
}

TYPED_TEST(PlaneFeatures, PointsOfContactLieOnTheCornersThatTheyName) {
  using T = TypeParam;
  std::mt19937 random(7);
  constexpr std::array kinds{1, 2, 4, 5};  // box, capsule, segment, convex polygon
  int lines = 0, corners_alone = 0;
  for (int round = 0; round < 4000; ++round) {
    const Figure<T> a = random_figure<T>(kinds[random() % 4], 1, random),
                    b = random_figure<T>(kinds[random() % 4], 1, random);
    const Pose2<T> pose_a = random_pose<T>(0.7, random), pose_b = random_pose<T>(0.7, random);
    Manifolds<T> found;
    contacts(a.shape, pose_a, b.shape, pose_b, T(0.1), found);
    for (const Manifold<T>& m : found) {
      const auto of_a = all_corners(a.shape, pose_a, m, feature_of_a),
                 of_b = all_corners(b.shape, pose_b, m, feature_of_b);
      ASSERT_FALSE(of_a.empty() || of_b.empty()) << a.shape.name() << " and " << b.shape.name();
      for (const ContactPoint<T>& p : m.points) {
        ASSERT_LE(off_feature(converted<double>(p.a), a.shape, pose_a, of_a), rounding_of(a.shape) + 1e-5);
        ASSERT_LE(off_feature(converted<double>(p.b), b.shape, pose_b, of_b), rounding_of(b.shape) + 1e-5);
      }
      for (const auto& corners : {of_a, of_b}) (corners.size() > 1 ? lines : corners_alone) += 1;
    }
  }
  EXPECT_GT(lines, 1000);
  EXPECT_GT(corners_alone, 300);
}

/// A concave outline that is given either way round, and a chain met from either side: names are those of the vertices
/// as they were given, whichever piece touches.
TYPED_TEST(PlaneFeatures, OfOutlinesAreThoseOfTheirVertices) {
  using T = TypeParam;
  std::vector<Vec2<T>> points{{-2, 0}, {2, 0}, {2, 2}, {0, T(0.5)}, {-2, 2}};
  for (const bool reversed : {false, true}) {
    if (reversed) std::reverse(points.begin(), points.end());
    const Shape<T> polygon = Polygon<T>(points), chain = Chain<T>(points, true),
                   two = Compound<T>({{Circle<T>(T(1)), {{T(9), T(0)}, {}}}, {polygon, {{T(3), T(0)}, {}}}});
    for (std::uint32_t i = 0; i < points.size(); ++i)
      for (const Shape<T>& shape : {polygon, chain}) {
        const auto vertex = feature_corners(shape, ~0u, {FeatureKind::vertex, i});
        ASSERT_EQ(vertex.size(), 1u) << shape.name();
        EXPECT_EQ(vertex[0], points[i]);
        const auto of_child = feature_corners(two, 1, {FeatureKind::vertex, i});
        ASSERT_EQ(of_child.size(), 1u);
        EXPECT_EQ(of_child[0], points[i] + (Vec2<T>{T(3), T(0)}));
      }
    // A small ball at the middle of each edge, on either side of it.
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const Vec2<T> p = points[i], q = points[(i + 1) % points.size()], e = q - p;
      for (const T side : {T(1), T(-1)})
        for (const Shape<T>& shape : {polygon, chain}) {
          const Vec2<T> ball = (p + q) * T(0.5) + Vec2<T>{e.y, -e.x} * (side * T(0.05) / length(e));
          Manifolds<T> found;
          contacts<T>(shape, {}, Circle<T>(T(0.06)), {ball, {}}, T(0), found);
          ASSERT_FALSE(found.empty());
          auto corners = feature_corners(shape, found[0].piece_a, feature_of_a(found[0].points[0].feature));
          ASSERT_EQ(corners.size(), 2u) << shape.name() << " edge " << i;
          if (corners[0] != p) std::swap(corners[0], corners[1]);
          EXPECT_EQ(corners[0], p);
          EXPECT_EQ(corners[1], q);
        }
    }
  }
}

TYPED_TEST(PlaneFeatures, WhatHasNoCornersNamesNone) {
  using T = TypeParam;
  for (const Shape<T>& round :
       {Shape<T>(Circle<T>(T(1))), Shape<T>(Ellipse<T>({T(1), T(2)})), Shape<T>(HalfPlane<T>())})
    for (const FeatureKind kind : {FeatureKind::none, FeatureKind::vertex, FeatureKind::edge, FeatureKind::face})
      EXPECT_TRUE(feature_corners(round, 0, {kind, 0}).empty()) << round.name();
  const Shape<T> box = Box<T>({T(1), T(1)});
  EXPECT_TRUE(feature_corners(box, 0, {FeatureKind::vertex, 4}).empty());
  EXPECT_TRUE(feature_corners(box, 0, {FeatureKind::edge, 4}).empty());
  EXPECT_TRUE(feature_corners(box, 0, {FeatureKind::face, 0}).empty());
  // An edge of a chain in a compound may be either of the two that meet at the vertex of its number.
  const std::vector<Vec2<T>> points{{0, 0}, {1, 0}, {2, 1}};
  const Shape<T> chain = Compound<T>({{Chain<T>(points), {}}});
  EXPECT_TRUE(feature_corners(chain, 0, {FeatureKind::edge, 1}).empty());
  EXPECT_EQ(feature_corners(chain, 0, {FeatureKind::edge, 0}).size(), 2u);
  EXPECT_TRUE(feature_corners(chain, 1, {FeatureKind::edge, 0}).empty()) << "one child";
}

/// Numbers have 14 bits: above, two vertices share one.
TYPED_TEST(PlaneFeatures, AreNotCertainWhereNumbersWrap) {
  using T = TypeParam;
  std::vector<Vec2<T>> points;
  for (int i = 0; i <= 16384; ++i) points.push_back({T(i), T(i % 2)});
  const Shape<T> longest = Chain<T>(std::span(points).first(16384)), longer = Chain<T>(points);
  EXPECT_EQ(feature_corners(longest, 0, {FeatureKind::vertex, 0}).size(), 1u);
  EXPECT_TRUE(feature_corners(longer, 0, {FeatureKind::vertex, 0}).empty());
}

}  // namespace
}  // namespace graze::plane
