// Contact manifolds: every point on both surfaces, the whole area spanned, steady from frame to frame.
#include <gtest/gtest.h>

#include <set>

#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "narrow/convex_pair.hpp"
#include "reference/certificate.hpp"

namespace graze::testing {
namespace {

using reference::Real;

constexpr Posed at(double x, double y, double z) { return {{x, y, z}, {}}; }
reference::Vector vector_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

Manifold<double> only_manifold(const Shaped& a, const Posed& pa, const Shaped& b, const Posed& pb, double margin = 0) {
  Manifolds<double> manifolds;
  contacts(a, pa, b, pb, margin, manifolds);
  EXPECT_LE(manifolds.size(), 1u);
  return manifolds.empty() ? Manifold<double>{} : manifolds[0];
}

/// Area of the points' hull across the normal, by the shoelace formula in order of angle about their middle.
double area_of(const Manifold<double>& m) {
  const Vec3d u = any_perpendicular(m.normal), v = cross(m.normal, u);
  Vec3d middle;
  for (const auto& p : m.points) middle += p.a / static_cast<double>(m.points.size());
  std::vector<std::array<double, 3>> around;
  for (const auto& p : m.points) {
    const double x = dot(p.a - middle, u), y = dot(p.a - middle, v);
    around.push_back({std::atan2(y, x), x, y});
  }
  std::sort(around.begin(), around.end());
  double twice = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto &p = around[i], &q = around[(i + 1) % around.size()];
    twice += p[1] * q[2] - q[1] * p[2];
  }
  return twice / 2;
}

TEST(Manifold, StackedBoxesTouchInFourCorners) {
  const Shaped box = Box<double>({2, 2, 2});
  const Manifold<double> m = only_manifold(box, at(0, 0, 0), box, at(0.5, 1.99, 0));
  EXPECT_EQ(m.normal, (Vec3d{0, 1, 0}));
  ASSERT_EQ(m.points.size(), 4u);
  EXPECT_NEAR(area_of(m), 1.5 * 2, 1e-12);
  for (const auto& p : m.points) EXPECT_NEAR(p.distance, -0.01, 1e-12);
}

TEST(Manifold, TurnedBoxesTouchInEightPoints) {
  const Shaped box = Box<double>({2, 2, 2});
  const Posed turned{{0, 2, 0}, Quatd::from_axis_angle({0, 1, 0}, std::acos(-1) / 4)};
  const Manifold<double> m = only_manifold(box, {}, box, turned);
  ASSERT_EQ(m.points.size(), 8u);
  EXPECT_NEAR(area_of(m), 8 * (std::sqrt(2) - 1), 1e-9);  // a regular octagon about a circle of radius 1
}

TEST(Manifold, CapsulesAndCylindersLieOnTwoPointsAndStandOnFour) {
  const Shaped floor = Box<double>({20, 2, 20});
  const Quatd lying = Quatd::from_axis_angle({0, 0, 1}, std::acos(-1) / 2);
  EXPECT_EQ(only_manifold(floor, {}, Capsule<double>(2, 0.5), {{0, 1.5, 0}, lying}).points.size(), 2u);
  EXPECT_EQ(only_manifold(floor, {}, Cylinder<double>(2, 0.5), {{0, 1.5, 0}, lying}).points.size(), 2u);
  EXPECT_GE(only_manifold(floor, {}, Cylinder<double>(2, 0.5), at(0, 2, 0)).points.size(), 4u);
  EXPECT_GE(only_manifold(floor, {}, Cylinder<double>(2, 0.5, 0.2), at(0, 2, 0)).points.size(), 4u);
  EXPECT_EQ(only_manifold(floor, {}, Cylinder<double>(2, 0.5, 0), {{0, 2, 0}, {1, 0, 0, 0}}).points.size(), 1u);
  EXPECT_EQ(only_manifold(floor, {}, Ellipsoid<double>({1, 0.5, 0.7}), at(0, 1.5, 0)).points.size(), 1u);
  EXPECT_EQ(only_manifold(Capsule<double>(2, 0.5), {}, Capsule<double>(2, 0.5), at(1, 0.5, 0)).points.size(), 2u);
}

TEST(Manifold, CrossingEdgesTouchInOnePoint) {
  const Shaped box = Box<double>({2, 2, 2});
  const Quatd tilt_x = Quatd::from_axis_angle({1, 0, 0}, std::acos(-1) / 4);
  const Quatd tilt_z = Quatd::from_axis_angle({0, 0, 1}, std::acos(-1) / 4);
  const Manifold<double> m = only_manifold(box, {{0, 0, 0}, tilt_x}, box, {{0, 2 * std::sqrt(2) - 0.01, 0}, tilt_z});
  ASSERT_EQ(m.points.size(), 1u);
  EXPECT_NEAR(m.normal.y, 1, 1e-9);
  EXPECT_NEAR(m.points[0].distance, -0.01, 1e-9);
}

// For random pairs of all kinds: points within the margin, on both shapes, apart along the normal; the deepest is as
// deep as the shapes are, up to the preference for faces.
TEST(Manifold, PointsLieOnBothShapesWhateverThePair) {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const auto ka = static_cast<Kind>(random() % bounded_kinds), kb = static_cast<Kind>(random() % kind_count);
    const PlacedSpecimen a{random_specimen(ka, 1, random), random_vector(random, 0.5f), random_rotation(random)};
    PlacedSpecimen b{random_specimen(kb, 1, random), random_vector(random, 0.5f), random_rotation(random)};
    if (i % 2 == 0) b.rotation = a.rotation;  // faces face each other
    const Shaped sa = build<double>(a.specimen), sb = build<double>(b.specimen);
    Manifolds<double> manifolds;
    const double margin = 0.05;
    const bool touch = contacts(sa, pose_of<double>(a), sb, pose_of<double>(b), margin, manifolds);
    const Distance<double> d = distance(sa, pose_of<double>(a), sb, pose_of<double>(b));
    ASSERT_EQ(touch, d.distance <= 0);
    ASSERT_EQ(manifolds.empty(), d.distance > margin);
    const reference::Placed ra = reference_of(a), rb = reference_of(b);
    for (const auto& m : manifolds) {
      EXPECT_NEAR(length(m.normal), 1, 1e-12);
      double least = 1;
      for (const auto& p : m.points) {
        EXPECT_LE(p.distance, margin);
        EXPECT_LT(length(p.b - p.a - m.normal * p.distance), 1e-12);
        EXPECT_LT(reference::outside_distance(ra, vector_of(p.a)), 2e-6L) << describe(a) << "\n" << describe(b);
        EXPECT_LT(reference::outside_distance(rb, vector_of(p.b)), 2e-6L) << describe(a) << "\n" << describe(b);
        least = std::min(least, p.distance);
      }
      EXPECT_NEAR(least, d.distance, 0.02) << describe(a) << "\n" << describe(b);
    }
  }
}

TEST(Manifold, SwappingTheShapesMirrorsPointsAndFeatures) {
  Random random(8);
  const Shaped box = Box<double>({1, 0.6, 0.8}), can = Cylinder<double>(0.8, 0.4);
  for (int i = 0; i < 500; ++i) {
    const Posed pa{cast<double>(random_vector(random, 0.5f)), normalized(cast<double>(random_rotation(random)))};
    const Posed pb{cast<double>(random_vector(random, 0.5f)), normalized(cast<double>(random_rotation(random)))};
    const Manifold<double> m = only_manifold(box, pa, can, pb, 0.01), w = only_manifold(can, pb, box, pa, 0.01);
    ASSERT_EQ(m.points.size(), w.points.size());
    if (m.points.empty()) continue;
    EXPECT_LT(length(m.normal + w.normal), 2e-5);  // half the digits of the depth
    std::multiset<std::uint32_t> features, mirrored;
    for (const auto& p : m.points) features.insert(p.feature);
    for (const auto& p : w.points) mirrored.insert((p.feature << 16) | (p.feature >> 16));
    EXPECT_EQ(features, mirrored);
  }
}

// A box of 1 m rests on another, tilted up to 5 mrad, about 1 mm deep, its pose drawn anew in each frame: the manifold
// of a stack must not flicker.
TEST(Manifold, RestingBoxesDoNotFlicker) {
  Random random(9);
  const Shaped box = Box<double>({1, 1, 1});
  std::size_t count = 0;
  std::set<std::uint32_t> features;
  int kinds = 0, counts = 0, ids = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec3d tilt = cast<double>(random_vector(random, 0.005f));
    const Posed pose{{0.1 + static_cast<double>(uniform(random, -0.001f, 0.001f)),
                      0.999 + static_cast<double>(uniform(random, -0.0005f, 0.0005f)), 0.05},
                     normalized(Quatd{tilt.x / 2, tilt.y / 2, tilt.z / 2, 1})};
    const Manifold<double> m = only_manifold(box, {}, box, pose, 0.02);
    std::set<std::uint32_t> now;
    for (const auto& p : m.points) now.insert(p.feature);
    if (i > 0) {
      kinds += (count > 1) != (m.points.size() > 1);
      counts += count != m.points.size();
      ids += features != now;
    }
    count = m.points.size();
    features = now;
  }
  EXPECT_EQ(kinds, 0);
  EXPECT_LT(counts, 100);
  EXPECT_LT(ids, 100);
}

}  // namespace
}  // namespace graze::testing
