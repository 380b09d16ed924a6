// Volume, centre and inertia: against closed forms known by hand, by scaling, moving, cutting in two, and by counting.
#include <gtest/gtest.h>

#include <cmath>

#include "common/specimen.hpp"
#include "graze/geometry.hpp"
#include "graze/query.hpp"

namespace graze::testing {
namespace {

const double pi = std::acos(-1.0);

TEST(Mass, ClosedForms) {
  const auto ball = mass_properties<double>(Sphere<double>(2, {1, 2, 3}));
  EXPECT_NEAR(ball.volume, 4 * pi / 3 * 8, 1e-11);
  EXPECT_LT(length(ball.center - Vec3d{1, 2, 3}), 1e-13);
  EXPECT_NEAR(ball.inertia.row[0].x, 0.4 * ball.volume * 4, 1e-10);

  const auto box = mass_properties<double>(Box<double>({1, 2, 3}));
  EXPECT_NEAR(box.volume, 6, 1e-13);
  EXPECT_NEAR(box.inertia.row[1].y, 6.0 * (1 + 9) / 12, 1e-12);
  EXPECT_NEAR(box.inertia.row[0].y, 0, 1e-13);

  const auto cone = mass_properties<double>(Cylinder<double>(4, 1, 0));
  EXPECT_NEAR(cone.volume, pi / 3 * 4, 1e-12);
  EXPECT_NEAR(cone.center.y, -1, 1e-12);
  EXPECT_NEAR(cone.inertia.row[1].y, 0.3 * cone.volume, 1e-12);
  EXPECT_NEAR(cone.inertia.row[0].x, cone.volume * (3.0 / 20 + 3.0 / 80 * 16), 1e-12);

  const auto ellipsoid = mass_properties<double>(Ellipsoid<double>({1, 2, 3}));
  EXPECT_NEAR(ellipsoid.inertia.row[2].z, ellipsoid.volume * (1 + 4) / 5, 1e-11);

  EXPECT_NEAR(mass_properties<double>(Capsule<double>(3, 0.5)).volume, pi * 0.25 * 3 + pi / 6, 1e-12);
  EXPECT_NEAR(mass_properties<double>(Capsule<double>(0.1, 2, 0.5)).volume, 4 * pi / 3 * 8, 1e-10);
}

// Steiner: the volume of a rounded body is V + S r + M r^2 + 4/3 pi r^3, with M = pi (a + b + c) for a box.
TEST(Mass, RoundedBodies) {
  const double r = 0.3;
  const auto box = mass_properties<double>({Box<double>({1, 2, 3}), r});
  EXPECT_NEAR(box.volume, 6 + 22 * r + pi * 6 * r * r + 4 * pi / 3 * r * r * r, 1e-11);
  const auto rectangle = mass_properties<double>({Rectangle<double>(1, 2), r});
  EXPECT_NEAR(rectangle.volume, 4 * r + pi * 3 * r * r + 4 * pi / 3 * r * r * r, 1e-11);
  const auto segment = mass_properties<double>({LineSegment<double>({1, 1, 1}, {1, 3, 1}), 0.5});
  const auto capsule = mass_properties<double>(Capsule<double>(2, 0.5));
  EXPECT_NEAR(segment.volume, capsule.volume, 1e-12);
  EXPECT_NEAR(segment.inertia.row[0].x, capsule.inertia.row[0].x, 1e-12);
  // A cylinder rounded by r: its outline's corner is a quarter of a torus.
  const double cap = 1, h = 2;
  const auto cylinder = mass_properties<double>({Cylinder<double>(h, cap), r});
  const double torus = pi * r * r / 2 * 2 * pi * (cap + 4 * r / (3 * pi));
  EXPECT_NEAR(cylinder.volume, pi * (cap + r) * (cap + r) * h + 2 * r * pi * cap * cap + torus, 1e-11);
}

// What has no closed form is sampled, to 0.02 % of the volume where it is smooth.
TEST(Mass, SampledBodies) {
  struct Ball final : SupportFunction<double> {
    Vec3d support(const Vec3d& d) const override { return Vec3d{1, 2, 3} + normalized(d) * 2.0; }
  };
  const auto ball = mass_properties<double>(UserConvex<double>(std::make_shared<Ball>()));
  const double volume = 4 * pi / 3 * 8;
  EXPECT_NEAR(ball.volume, volume, 1e-4 * volume);
  EXPECT_LT(length(ball.center - Vec3d{1, 2, 3}), 1e-4);
  EXPECT_NEAR(ball.inertia.row[0].x, 0.4 * volume * 4, 1e-4 * volume * 4);

  // Steiner, of a ball that is told as an ellipsoid: V + S r + 4 pi R r^2 + 4/3 pi r^3.
  const double r = 0.25;
  const auto rounded = mass_properties<double>({Ellipsoid<double>({1, 1, 1}), r});
  const double whole = 4 * pi / 3 * (1 + r) * (1 + r) * (1 + r);
  EXPECT_NEAR(rounded.volume, whole, 1e-4 * whole);
  // And against the same formula integrated for a spheroid: surface area and mean curvature of radii 1, 1, 2.
  const auto flat = mass_properties<double>({Ellipsoid<double>({1, 2, 1}), r});
  const double e = std::sqrt(3.0) / 2, area = 2 * pi * (1 + 2 / e * std::asin(e));
  const double curvature = 2 * pi * (2 + 1 / (2 * e) * std::atanh(e));
  const double steiner = 4 * pi / 3 * 2 + area * r + curvature * r * r + 4 * pi / 3 * r * r * r;
  EXPECT_NEAR(flat.volume, steiner, 2e-4 * steiner);
}

// Counting cells of a grid whose middle is inside, told by the library's own signed distance.
TEST(Mass, AgreesWithCountingCells) {
  Random random(5);
  for (const Kind kind : {Kind::tapered_capsule, Kind::truncated_cone, Kind::hull, Kind::ellipsoid, Kind::triangle}) {
    Specimen s = random_specimen(kind, 1, random);
    s.margin = kind == Kind::triangle ? 0.3f : s.margin;
    const Shaped shape = build<double>(s);
    const auto m = mass_properties(shape);
    const Aabbd box = bounds(shape, Posed{});
    const int n = 40;
    const Vec3d cell = box.extent() / static_cast<double>(n);
    double volume = 0;
    Vec3d first;
    for (int i = 0; i < n * n * n; ++i) {
      const Vec3d p = box.lower + scaled(cell, Vec3d{i % n + 0.5, i / n % n + 0.5, i / n / n + 0.5});
      if (closest(shape, {}, p).distance > 0) continue;
      volume += cell.x * cell.y * cell.z;
      first += p * (cell.x * cell.y * cell.z);
    }
    EXPECT_NEAR(m.volume, volume, 0.02 * volume) << name_of(kind);
    EXPECT_LT(length(m.center - first / volume), 0.01 * length(box.extent())) << name_of(kind);
  }
}

TEST(Mass, MovesAndScalesWithTheShape) {
  Random random(6);
  for (int i = 0; i < 50; ++i) {
    std::vector<Vec3d> points, moved, doubled;
    const Posed pose{converted<double>(random_vector(random, 1000)),
                     normalized(converted<double>(random_rotation(random)))};
    for (int k = 0; k < 20; ++k) {
      points.push_back(converted<double>(random_vector(random, 1)));
      moved.push_back(transform(pose, points.back()));
      doubled.push_back(points.back() * 2.0);
    }
    const auto m = mass_properties<double>({ConvexHull<double>(points), 0.1});
    const auto at = mass_properties<double>({ConvexHull<double>(moved), 0.1});
    const auto twice = mass_properties<double>({ConvexHull<double>(doubled), 0.2});
    EXPECT_NEAR(at.volume, m.volume, 1e-9);
    EXPECT_LT(length(at.center - transform(pose, m.center)), 1e-9);
    EXPECT_NEAR(twice.volume, 8 * m.volume, 1e-10);
    EXPECT_NEAR(twice.inertia.row[1].z, 32 * m.inertia.row[1].z, 1e-9);
  }
}

TEST(Mass, CompoundsAddAndSurfacesHaveNone) {
  const Shaped half = Box<double>({1, 2, 3});
  const auto both = mass_properties<double>(Compound<double>({{half, {{-0.5, 0, 0}, {}}}, {half, {{0.5, 0, 0}, {}}}}));
  const auto whole = mass_properties<double>(Box<double>({2, 2, 3}));
  EXPECT_NEAR(both.volume, whole.volume, 1e-12);
  EXPECT_NEAR(both.inertia.row[2].z, whole.inertia.row[2].z, 1e-11);
  for (const Shaped& surface :
       {Shaped(Rectangle<double>(1, 2)), Shaped(HalfSpace<double>()), Shaped(Box<double>({0, 1, 1})),
        Shaped(Triangle<double>({0, 0, 0}, {1, 0, 0}, {0, 1, 0})), Shaped(Sphere<double>(0))}) {
    EXPECT_EQ(mass_properties(surface).volume, 0);
  }
  const std::vector<Vec3d> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_NEAR(mass_properties<double>(Mesh<double>(p, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})).volume, 1.0 / 6,
              1e-14);
  EXPECT_EQ(mass_properties<double>(Mesh<double>(p, {{0, 2, 1}})).volume, 0);
}

}  // namespace
}  // namespace graze::testing
