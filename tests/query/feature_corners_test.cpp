// The features that contact points name: their corners are where the points are.
#include "graze/feature_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "common/specimen.hpp"
#include "graze/query.hpp"

namespace graze::testing {
namespace {

double distance_to_segment(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  const Vec3d d = b - a;
  const double along = dot(d, d) > 0 ? std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0) : 0;
  return length(p - (a + d * along));
}

/// How far a point is from a vertex, an edge, or a flat convex face with these corners in order.
double distance_to_feature(const Vec3d& p, const std::vector<Vec3d>& corners) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = corners.size() > 2;
  Vec3d normal{};
  for (std::size_t i = 0; i < corners.size(); ++i) normal += cross(corners[i], corners[(i + 1) % corners.size()]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d &a = corners[i], &b = corners[(i + 1) % corners.size()];
    nearest = std::min(nearest, distance_to_segment(p, a, b));
    inside = inside && dot(cross(b - a, p - a), normal) >= 0;
  }
  return inside ? std::abs(dot(p - corners[0], normal)) / length(normal) : nearest;
}

template <class T>
struct Features : ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Features, Scalars);

/// Whether a point on a shape lies where its feature has its corners; every one of these shapes has them.
template <class T>
bool lies_on_feature(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& point, const Feature& feature) {
  const auto found = feature_corners(shape, 0, feature);
  EXPECT_FALSE(found.empty()) << shape.name() << ": " << int(feature.kind) << " " << feature.number;
  std::vector<Vec3d> corners;
  for (const Vec3<T>& corner : found) corners.push_back(converted<double>(transform(pose, corner)));
  EXPECT_EQ(feature.kind, corners.size() == 1   ? FeatureKind::vertex
                          : corners.size() == 2 ? FeatureKind::edge
                                                : FeatureKind::face);
  // A point counts as on an edge within a hundredth of the shortest edge, and as on a vertex where two edges are as
  // near. A rounding lies around the core; where a side leans from the normal, by 60 degrees at most, the point is as
  // far beside.
  constexpr double tolerance = 0.03;
  const double off = distance_to_feature(converted<double>(point), corners), rounding = double(shape.rounding());
  EXPECT_GE(off, rounding - 1e-4);
  return off <= 2 * rounding + tolerance;
}

TYPED_TEST(Features, PointsOfContactLieOnTheCornersThatTheyName) {
  using T = TypeParam;
  Random random(7);
  constexpr std::array<Kind, 5> kinds{Kind::box, Kind::rectangle, Kind::triangle, Kind::hull, Kind::segment};
  std::array<int, 4> seen{}, off{};
  for (int i = 0; i < 4000; ++i) {
    PlacedSpecimen p{random_specimen(kinds[random() % 5], 1, random), random_vector(random, 0.4f),
                     random_rotation(random)},
        q{random_specimen(kinds[random() % 5], 1, random), random_vector(random, 0.4f), random_rotation(random)};
    if (i % 3 == 0) q.rotation = p.rotation;  // parallel faces and edges
    const Shape<T> a = build<T>(p.specimen), b = build<T>(q.specimen);
    const Pose<T> pose_a = pose_of<T>(p), pose_b = pose_of<T>(q);
    Manifolds<T> found;
    contacts(a, pose_a, b, pose_b, T(0.1), found);
    for (const Manifold<T>& m : found)
      for (const ContactPoint<T>& point : m.points) {
        const Feature of_a = feature_of_a(point.feature), of_b = feature_of_b(point.feature);
        ++seen[std::size_t(of_a.kind)], ++seen[std::size_t(of_b.kind)];
        off[std::size_t(of_a.kind)] += !lies_on_feature(a, pose_a, point.a, of_a);
        off[std::size_t(of_b.kind)] += !lies_on_feature(b, pose_b, point.b, of_b);
      }
    if (this->HasFailure()) FAIL() << describe(p) << "\n" << describe(q);
  }
  EXPECT_EQ(seen[0], 0);
  for (std::size_t kind = 1; kind < 4; ++kind) EXPECT_GT(seen[kind], 300) << kind;
  // Two edges that lead on almost straight are both near along their whole length: then the vertex between has the
  // name.
  EXPECT_LE(off[1], 3);
  EXPECT_EQ(off[2] + off[3], 0);
}

TYPED_TEST(Features, OfACompoundsChildInTheCompoundsFrame) {
  using T = TypeParam;
  const Pose<T> placed{{T(3), T(0), T(0)}, {T(0), T(0.28), T(0), T(0.96)}};
  const Shape<T> two = Compound<T>({{Sphere<T>(T(1)), {}}, {Box<T>({T(1), T(1), T(1)}), placed}});
  Manifolds<T> found;
  contacts<T>(two, {}, Box<T>({T(1), T(1), T(1)}), {{T(3.4), T(0.9), T(0)}, {}}, T(0), found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].piece_a, 1u);
  for (const ContactPoint<T>& point : found[0].points) {
    std::vector<Vec3d> corners;
    for (const Vec3<T>& corner : feature_corners(two, found[0].piece_a, feature_of_a(point.feature)))
      corners.push_back(converted<double>(corner));
    ASSERT_FALSE(corners.empty());
    EXPECT_LE(distance_to_feature(converted<double>(point.a), corners), 0.02);
  }
  const auto* compound = two.template as<Compound<T>>();
  EXPECT_TRUE(feature_corners(two, 2, {FeatureKind::vertex, 0}).empty()) << compound->children().size() << " children";
}

TYPED_TEST(Features, WhatHasNoCornersNamesNone) {
  using T = TypeParam;
  for (const Shape<T>& round : {Shape<T>(Sphere<T>(T(1))), Shape<T>(Cylinder<T>(T(1), T(1), T(1))),
                                Shape<T>(Capsule<T>(T(1), T(1), T(1))), Shape<T>(Ellipsoid<T>({T(1), T(2), T(3)}))})
    for (const FeatureKind kind : {FeatureKind::none, FeatureKind::vertex, FeatureKind::edge, FeatureKind::face})
      EXPECT_TRUE(feature_corners(round, 0, {kind, 0}).empty()) << round.name();
  const Shape<T> box = Box<T>({T(1), T(1), T(1)});
  EXPECT_TRUE(feature_corners(box, 0, {FeatureKind::vertex, 8}).empty());
  EXPECT_TRUE(feature_corners(box, 0, {FeatureKind::face, 6}).empty());
  EXPECT_TRUE(feature_corners(box, 0, {FeatureKind::edge, 127 * 7 + 7}).empty());
}

/// Faces in the order that their outward normal asks for.
TYPED_TEST(Features, FacesRunCounterClockwise) {
  using T = TypeParam;
  const Shape<T> box = Box<T>({T(2), T(4), T(6)}),
                 hull = ConvexHull<T>(std::vector<Vec3<T>>{{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}, {0, 0, 2}});
  for (const auto& [shape, faces] : {std::pair(box, 6u), std::pair(hull, 4u)})
    for (std::uint32_t f = 0; f < faces; ++f) {
      const auto corners = feature_corners(shape, 0, {FeatureKind::face, f});
      ASSERT_EQ(corners.size(), faces == 6 ? 4u : 3u);
      Vec3<T> middle{};
      for (const Vec3<T>& c : corners) middle += c / T(corners.size());
      EXPECT_GT(dot(cross(corners[1] - corners[0], corners[2] - corners[1]), middle), T(0)) << f;
    }
}

}  // namespace
}  // namespace graze::testing
