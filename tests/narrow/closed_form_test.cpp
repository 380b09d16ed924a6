// The closed forms as the lectures give them, by hand.
#include <random>

#include "common/specimen.hpp"
#include "manifold_of.hpp"
#include "narrow/core/point_point.hpp"
#include "narrow/general.hpp"
#include "narrow/pairs/half_space_distance.hpp"

namespace graze::testing {
namespace {

TEST(SphereSphere, NormalDepthAndPointsLieOnTheLineOfCentres) {
  const Shaped a = Sphere<double>(2), b = Sphere<double>(1);
  const Distance<double> d = distance(a, at(0, 0, 0), b, at(0, 2.5, 0));
  EXPECT_EQ(d.distance, -0.5);
  EXPECT_EQ(d.normal, (Vec3d{0, 1, 0}));
  EXPECT_EQ(d.a, (Vec3d{0, 2, 0}));
  EXPECT_EQ(d.b, (Vec3d{0, 1.5, 0}));
}

// P divides the line of centres in the ratio of the radii: |P - c1| / |P - c2| = r1 / r2.
TEST(SphereSphere, ContactPositionIsWeightedByTheRadii) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double r1 = static_cast<double>(uniform(random, 0.1f, 2)), r2 = static_cast<double>(uniform(random, 0.1f, 2));
    const Vec3d c1 = converted<double>(random_vector(random, 1)), c2 = converted<double>(random_vector(random, 1));
    Manifolds<double> manifolds;
    if (!contacts<double>(Sphere<double>(r1), {c1, {}}, Sphere<double>(r2), {c2, {}}, 0, manifolds)) continue;
    const Vec3d p = manifolds.at(0).points[0].position();
    EXPECT_NEAR(length(p - c1) * r2, length(p - c2) * r1, 1e-12);
  }
}

// A point at a segment's end, up to the rounding of coordinates that cancel: the normal separates the two.
TEST(SphereSegment, APointAtAnEndGetsANormalThatSeparates) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d from = converted<double>(random_vector(random, 1)), to = converted<double>(random_vector(random, 1));
    const Posed pose{converted<double>(random_vector(random, 1)),
                     normalized(converted<double>(random_rotation(random)))};
    const Vec3d end = transform(pose, from), along = transform(pose, to) - end;
    const Distance<double> d = distance<double>(Sphere<double>(0), {end, {}}, LineSegment<double>(from, to), pose);
    EXPECT_NEAR(d.distance, 0, 1e-15);
    EXPECT_GE(dot(d.normal, along), -1e-12) << i;
  }
}

TEST(SphereSphere, CoincidentCentresGetAUnitNormal) {
  const Distance<double> d = distance<double>(Sphere<double>(2), at(1, 1, 1), Sphere<double>(1), at(1, 1, 1));
  EXPECT_EQ(d.distance, -3);
  EXPECT_EQ(length(d.normal), 1);
  EXPECT_EQ(d.b - d.a, d.normal * -3.0);
}

// The test without a square root must not differ from the one with it but by the rounding of a square.
TEST(SphereSphere, SquaredTestTouchesExactly) {
  EXPECT_TRUE(spheres_overlap(Vec3d{0, 0, 0}, 1.0, Vec3d{3, 0, 0}, 2.0));
  EXPECT_FALSE(spheres_overlap(Vec3d{0, 0, 0}, 1.0, Vec3d{std::nextafter(3.0, 4.0), 0, 0}, 2.0));
  EXPECT_TRUE(overlap<double>(Sphere<double>(1), at(0, 0, 0), Sphere<double>(2), at(0, 3, 0)));
}

TEST(HalfSpaceBox, AllCornersAndTheProjectedRadiusAgree) {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const Vec3d half = abs(converted<double>(random_vector(random, 2)));
    const Posed pose{converted<double>(random_vector(random, 3)),
                     normalized(converted<double>(random_rotation(random)))};
    EXPECT_NEAR(lowest_corner(half, pose), lowest_by_radius(half, pose), 1e-14);
  }
}

TEST(HalfSpaceBox, RestsOnItsFourLowerCorners) {
  Manifolds<double> manifolds;
  EXPECT_TRUE(contacts<double>(HalfSpace<double>(), {}, Box<double>({2, 2, 2}), at(0, 0.75, 0), 0, manifolds));
  ASSERT_EQ(manifolds.size(), 1u);
  EXPECT_EQ(manifolds[0].normal, (Vec3d{0, 1, 0}));
  ASSERT_EQ(manifolds[0].points.size(), 4u);
  for (const auto& p : manifolds[0].points) {
    EXPECT_EQ(p.distance, -0.25);
    EXPECT_EQ(p.b - p.a, manifolds[0].normal * p.distance);
  }
}

TEST(HalfSpaces, FacingOnesHaveAGapAndOthersNoDepth) {
  const Shaped plane = HalfSpace<double>();
  const Posed upside_down{{0, 2, 0}, {1, 0, 0, 0}};
  EXPECT_EQ(distance(plane, {}, plane, upside_down).distance, 2);
  EXPECT_FALSE(overlap(plane, {}, plane, upside_down));
  EXPECT_EQ(distance(plane, {}, plane, {{0, -2, 0}, {1, 0, 0, 0}}).distance, -2);
  EXPECT_TRUE(overlap(plane, {}, plane, at(0, 5, 0)));
  EXPECT_EQ(distance(plane, {}, plane, at(0, 5, 0)).status, Status::unbounded);
}

TEST(HalfSpace, MarginMovesItUp) {
  EXPECT_EQ(distance<double>({HalfSpace<double>(), 0.5}, {}, Sphere<double>(1), at(0, 2, 0)).distance, 0.5);
}

// Every closed form agrees with the general path that it short-cuts.
TEST(ClosedForms, AgreeWithTheGeneralPath) {
  constexpr Kind kinds[] = {Kind::sphere, Kind::capsule, Kind::box, Kind::rectangle, Kind::segment};
  Random random(3);
  for (const Kind ka : kinds)
    for (const Kind kb : kinds)
      for (int i = 0; i < 500; ++i) {
        const PlacedSpecimen a{random_specimen(ka, 1, random), random_vector(random, 1), random_rotation(random)};
        const PlacedSpecimen b{random_specimen(kb, 1, random), random_vector(random, 1), random_rotation(random)};
        const Shaped sa = build<double>(a.specimen), sb = build<double>(b.specimen);
        const Posed pa = pose_of<double>(a), pb = pose_of<double>(b);
        const auto radius = [](const Shaped& s) {
          return s.rounding() + s.visit([](const auto& c) {
            if constexpr (requires { c.core_radius(); })
              return c.core_radius();
            else
              return 0.0;
          });
        };
        const GeneralDistance g = general_distance(sa, sb, relative_in_double(pa, pb));
        EXPECT_NEAR(distance(sa, pa, sb, pb).distance, g.core.distance - radius(sa) - radius(sb), 1e-10)
            << describe(a) << "\n"
            << describe(b);
      }
}

TEST(Closest, IsSignedAndPointsOutward) {
  const Shaped box = Box<double>({2, 2, 2});
  const Closest<double> outside = closest(box, {}, Vec3d{3, 0, 0});
  EXPECT_EQ(outside.distance, 2);
  EXPECT_EQ(outside.point, (Vec3d{1, 0, 0}));
  EXPECT_EQ(outside.normal, (Vec3d{1, 0, 0}));
  const Closest<double> inside = closest(box, {}, Vec3d{0, 0.75, 0});
  EXPECT_EQ(inside.distance, -0.25);
  EXPECT_EQ(inside.point, (Vec3d{0, 1, 0}));
  EXPECT_EQ(inside.normal, (Vec3d{0, 1, 0}));
}

}  // namespace
}  // namespace graze::testing
