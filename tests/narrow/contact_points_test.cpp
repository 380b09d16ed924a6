// Contact points one by one: on the surfaces of rounded shapes, each with a name and a place of its own, the same
// wherever the scene stands.
#include <algorithm>
#include <set>

#include "common/specimen.hpp"
#include "manifold_of.hpp"

namespace graze::testing {
namespace {

using reference::Real;

/// Of a rounded shape, whose surface is as far from its core as the margin is wide: told from the core alone.
Real beside_surface(PlacedSpecimen placed, const Vec3d& point) {
  const auto margin = static_cast<Real>(placed.specimen.margin);
  placed.specimen.margin = 0;
  return std::abs(reference::outside_distance(reference_of(placed), vector_of(point)) - margin);
}

// A lid hangs 23 degrees aslant on a slab: the point over its edge lies on the edge's quarter round, not a radius below
// the edge.
TEST(ContactPoints, PointsOfATiltedRoundedBoxLieOnItsSurface) {
  const Shaped slab = Box<double>({4, 1, 4}), lid = Shaped(Box<double>({1, 1, 1}), 0.3);
  const double angle = 2 * std::atan(0.2);
  const Posed pose{{0, 1.35, 0}, Quatd::from_axis_angle({0, 0, 1}, angle)};
  const Manifold<double> m = only_manifold(slab, {}, lid, pose, 0.6);
  ASSERT_EQ(m.points.size(), 4u);
  for (const auto& p : m.points) {
    EXPECT_EQ(p.a.y, 0.5);
    EXPECT_NEAR(closest(lid, pose, p.b).distance, 0, 1e-12);
  }
}

// Rounded shapes one on the other, aslant by up to 30 degrees (so that feet fall beyond edges and corners), apart and
// overlapping.
TEST(ContactPoints, PointsOfRoundedShapesLieOnBothSurfaces) {
  Random random(14);
  int points = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto ka = static_cast<Kind>(random() % bounded_kinds), kb = static_cast<Kind>(random() % kind_count);
    PlacedSpecimen a{random_specimen(ka, 1, random), random_vector(random, 0.4f), random_rotation(random)};
    PlacedSpecimen b{random_specimen(kb, 1, random), random_vector(random, 0.4f), a.rotation};
    if (i % 4 != 0) a.specimen.margin = uniform(random, 0.01f, 0.3f);
    if (i % 4 != 1) b.specimen.margin = uniform(random, 0.01f, 0.3f);
    if (kb == Kind::half_space) b.translation *= 0.2f;
    const Vec3f tilt = random_vector(random, i % 2 ? 0.15f : 0.01f);
    b.rotation = normalized(b.rotation * Quatf{tilt.x, tilt.y, tilt.z, 1});
    const Shaped sa = build<double>(a.specimen), sb = build<double>(b.specimen);
    Manifolds<double> manifolds;
    contacts(sa, pose_of<double>(a), sb, pose_of<double>(b), 0.3, manifolds);
    for (const auto& m : manifolds)
      for (const auto& p : m.points) {
        ++points;
        EXPECT_LT(length(p.b - p.a - m.normal * p.distance), 1e-12);
        if (a.specimen.margin > 0) {
          EXPECT_LT(beside_surface(a, p.a), 2e-6L) << describe(a) << "\n" << describe(b);
        }
        if (b.specimen.margin > 0 && kb != Kind::half_space) {
          EXPECT_LT(beside_surface(b, p.b), 2e-6L) << describe(a) << "\n" << describe(b);
        }
      }
  }
  EXPECT_GT(points, 20000);
}

// A cylinder's line touches a box's face about at its corner, whose end the line's end all but meets: one point.
TEST(ContactPoints, PointsThatRoundingSplitsAreOne) {
  const Shape<float> can = Cylinder<float>(0.8043799f, 0.5724918f),
                     box = Box<float>({0.14606866f, 0.6359927f, 0.6081095f});
  const Posef at_can{{0.70013446f, -0.06977015f, 0.68350122f}, {}};
  const Posef at_box{{-0.24040722f, 0.00180585f, 0.42755058f},
                     normalized(Quatf{-0.42470438f, -0.81927955f, -0.00680978f, 0.33611954f})};
  Manifolds<float> manifolds;
  contacts(can, at_can, box, at_box, 0.0f, manifolds);
  ASSERT_EQ(manifolds.size(), 1u);
  EXPECT_EQ(manifolds[0].points.size(), 1u);
}

TEST(ContactPoints, PointsHaveNamesAndPlacesOfTheirOwn) {
  Random random(15);
  for (int i = 0; i < 20000; ++i) {
    const auto ka = static_cast<Kind>(random() % bounded_kinds), kb = static_cast<Kind>(random() % kind_count);
    const PlacedSpecimen a{random_specimen(ka, 1, random), random_vector(random, 0.5f), random_rotation(random)};
    PlacedSpecimen b{random_specimen(kb, 1, random), random_vector(random, 0.5f), random_rotation(random)};
    if (i % 2 == 0) b.rotation = a.rotation;
    const auto check = [&]<class T>(T margin, double same) {
      Manifolds<T> manifolds;
      contacts(build<T>(a.specimen), pose_of<T>(a), build<T>(b.specimen), pose_of<T>(b), margin, manifolds);
      for (const auto& m : manifolds)
        for (std::size_t k = 0; k < m.points.size(); ++k)
          for (std::size_t l = 0; l < k; ++l) {
            const auto &p = m.points[k], &q = m.points[l];
            EXPECT_NE(p.feature, q.feature) << describe(a) << "\n" << describe(b);
            EXPECT_GT(static_cast<double>(std::max(max_abs(p.a - q.a), max_abs(p.b - q.b))), same)
                << describe(a) << "\n"
                << describe(b);
          }
    };
    check(0.05f, 1e-7);
    check(0.05, 1e-12);
  }
}

// The line of a cylinder's side lies along a box's edge, which the normal of the depth, right to half the digits of the
// depth, places a few millionths beside it: two points wherever the scene stands.
TEST(ContactPoints, ACylinderAlongABoxesEdgeTouchesInTwoPointsHoweverTheSceneIsTurned) {
  Random random(17);
  const Shaped can = Cylinder<double>(0.79, 0.3513), box = Box<double>({0.77, 0.303, 0.3});
  const Posed at_can{{-0.1805, -0.2852, 0.511}, {}};
  const Posed at_box{{-0.7145, -0.648, 0.7669}, Quatd::from_axis_angle({1, 0, 0}, std::acos(-1) / 2)};
  for (int i = 0; i < 1000; ++i) {
    const Posed move{converted<double>(random_vector(random, 50)),
                     normalized(converted<double>(random_rotation(random)))};
    const Posed pa = compose(move, at_can), pb = compose(move, at_box);
    const Manifold<double> m = only_manifold(can, pa, box, pb);
    ASSERT_EQ(m.points.size(), 2u) << i;
    EXPECT_EQ(std::min(m.points[0].feature, m.points[1].feature), 0x40008084u);
    EXPECT_EQ(std::max(m.points[0].feature, m.points[1].feature), 0x80014001u);
    for (const auto& p : m.points) {
      EXPECT_NEAR(closest(can, pa, p.a).distance, 0, 1e-10);
      EXPECT_NEAR(closest(box, pb, p.b).distance, 0, 1e-10);
    }
  }
}

// What rounding decides must not decide the names: which end of a side of no length it is, and on which side of a box's
// rim a capsule's line lies that runs along it.
TEST(ContactPoints, PointsKeepTheirNumberAndNamesWhenTheSceneIsTurned) {
  struct Case {
    Shaped a, b;
    Posed at_a, at_b;
    std::multiset<std::uint32_t> features;
  };
  const Case cases[] = {
      {Rectangle<double>(0.527, 0.566),
       Capsule<double>(0.749, 0.873),
       at(-0.219, -0.61, 0.149),
       at(0.842, -0.504, 0.631),
       {0x40058001}},
      {Shaped(Rectangle<double>(0.772, 0.139)),
       Shaped(Capsule<double>(0.559, 0.81), 0.213),
       at(-0.372, -0.483, 0.227),
       at(0.211, -0.222, 0.286),
       {0x80848001}},
      {Box<double>({0.119, 0.987, 0.532}),
       Capsule<double>(0.752, 0.361),
       at(0.505, 0.747, 0.691),
       at(0.842, 0.975, 0.276),
       {0x80824000, 0x40038001}},
  };
  Random random(18);
  for (const Case& c : cases)
    for (int i = 0; i < 500; ++i) {
      const Posed move{converted<double>(random_vector(random, 50)),
                       normalized(converted<double>(random_rotation(random)))};
      std::multiset<std::uint32_t> features;
      for (const auto& p : only_manifold(c.a, compose(move, c.at_a), c.b, compose(move, c.at_b)).points)
        features.insert(p.feature);
      ASSERT_EQ(features, c.features) << i;
    }
}

}  // namespace
}  // namespace graze::testing
