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
  constexpr Kind kinds[] = {Kind::sphere, Kind::capsule,        Kind::box,    Kind::rectangle, Kind::cylinder,
                            Kind::cone,   Kind::truncated_cone, Kind::segment};
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

/// The distance of a point at `rho` from the axis and at the height `y`, from the profile of a truncated cone: the
/// least to its three sides, each a segment, in extended precision; inside it is negative.
long double distance_to_profile(const Cylinder<double>& shape, long double rho, long double y) {
  const long double h = shape.half_height(), bottom = shape.radius_bottom(), top = shape.radius_top();
  const auto to_segment = [&](long double x0, long double y0, long double x1, long double y1) {
    const long double dx = x1 - x0, dy = y1 - y0, squared = dx * dx + dy * dy;
    const long double at = squared > 0 ? ((rho - x0) * dx + (y - y0) * dy) / squared : 0;
    const long double t = at < 0 ? 0 : at > 1 ? 1 : at;
    return std::hypot(rho - x0 - dx * t, y - y0 - dy * t);
  };
  const long double nearest =
      std::min({to_segment(0, h, top, h), to_segment(0, -h, bottom, -h), to_segment(bottom, -h, top, h)});
  const bool inside = h > 0 && std::abs(y) <= h && (rho - bottom) * 2 * h <= (top - bottom) * (y + h);
  return inside ? -nearest : nearest;
}

// Points outside of and deep in cylinders, cones and truncated cones, many of them flat or slender, on the axis and on
// the surface: the distance is exact, and the three parts of the answer agree.
TEST(Closest, OfConesIsExactInsideAndOutside) {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const auto length_of = [&] {
      const auto size = static_cast<double>(uniform(random, 0, 1));
      return random() % 8 == 0 ? 0 : random() % 4 == 0 ? size * 1e-3 : size;
    };
    const double height = length_of(), bottom = length_of(), top = random() % 3 == 0 ? bottom : length_of();
    const Cylinder<double> cone(height, bottom, top);
    const double size = cone.core_extent();
    Vec3d p = scaled(converted<double>(random_vector(random, 1)), Vec3d{1, height, 1});
    if (random() % 8 == 0) p.x = p.z = 0;
    if (random() % 8 == 0) p.y = height / 2;
    if (random() % 8 == 0) p = {bottom, -height / 2, 0};
    const Closest<double> found = closest<double>(cone, {}, p);
    const auto rho = std::hypot(static_cast<long double>(p.x), static_cast<long double>(p.z));
    const double reach = size + max_abs(p);
    ASSERT_EQ(found.status, Status::converged);
    ASSERT_NEAR(found.distance, static_cast<double>(distance_to_profile(cone, rho, static_cast<long double>(p.y))),
                1e-14 * reach)
        << height << " " << bottom << " " << top << " at " << p.x << " " << p.y << " " << p.z;
    ASSERT_LE(length(p - found.point - found.normal * found.distance), 1e-15 * reach);
    ASSERT_NEAR(length(found.normal), 1, 1e-15);
    // No point of the shape is further along the normal than the point itself.
    const Vec3d furthest = support<double>(cone, found.normal);
    ASSERT_LE(dot(found.normal, furthest - found.point), 1e-14 * reach);
  }
}

// Turned and far from the origin, with balls of a radius and a centre of their own, in float: as near the caps and the
// edge as a float can tell.
TEST(SphereCylinder, AgreesWithTheClosestPoint) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const float height = uniform(random, 0, 2), bottom = uniform(random, 0, 1), top = uniform(random, 0, 1);
    const Shape<float> cone(Cylinder<float>(height, bottom, top), 0.125f);
    const Shape<float> ball(Sphere<float>(0.25f, random_vector(random, 0.5f)));
    const auto random_pose = [&] {
      const Vec3f translation = random_vector(random, 1) + Vec3f{64, -64, 64};
      return Pose<float>{translation, normalized(random_rotation(random))};
    };
    const Pose<float> pose = random_pose(), placed = random_pose();
    const Vec3f center = transform(placed, ball.as<Sphere<float>>()->center());
    const Distance<float> d = distance(cone, pose, ball, placed);
    const Closest<float> c = closest(cone, pose, center);
    ASSERT_NEAR(d.distance, c.distance - 0.25f, 1e-5f);
    ASSERT_LE(length(d.b - d.a - d.normal * d.distance), 3e-5f);
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
