// Area, centre and inertia of the shapes of the plane, against sums over a fine grid.
#include "graze/plane/mass.hpp"

#include <gtest/gtest.h>

#include "graze/plane/query.hpp"

namespace graze::plane {
namespace {

/// By the points of a grid that lie inside.
MassProperties<double> by_grid(const Shaped& shape) {
  const Aabb2<double> box = bounds(shape, Pose2d{});
  constexpr int n = 200;
  const Vec2d step = (box.upper - box.lower) / double(n);
  double count = 0, x = 0, y = 0, polar = 0;
  const Shaped spot = Circle<double>(0);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const Vec2d p{box.lower.x + (i + 0.5) * step.x, box.lower.y + (k + 0.5) * step.y};
      if (!overlap(shape, Pose2d{}, spot, {p, {}})) continue;
      count += 1, x += p.x, y += p.y, polar += dot(p, p);
    }
  const double cell = step.x * step.y;
  const Vec2d center{x / count, y / count};
  return {count * cell, center, cell * (polar - count * dot(center, center))};
}

const std::vector<Vec2d> notched{{-1, -1}, {1, -1}, {1, 1}, {0.2, -0.3}, {-1, 0.8}};

TEST(PlaneMass, AgreesWithAGrid) {
  const std::vector<Vec2d> hexagon{{-1, -0.5}, {0.2, -1}, {1.2, -0.3}, {1, 0.8}, {-0.1, 1.1}, {-0.9, 0.6}};
  const Shaped shapes[] = {
      Circle<double>(0.7),
      Box<double>({1, 2}),
      {Box<double>({1, 2}), 0.3},
      {Box<double>({1, 0}), 0.3},
      Capsule<double>(1.5, 0.4),
      Capsule<double>(1.5, 0.6, 0.2),
      {Capsule<double>(1.5, 0.1, 0.5), 0.2},
      Capsule<double>(0.2, 0.9, 0.1),
      Ellipse<double>({1.2, 0.4}),
      {Ellipse<double>({1.2, 0.4}), 0.3},
      {Segment<double>({-1, 0.5}, {0.7, 0.2}), 0.25},
      ConvexPolygon<double>(hexagon),
      {ConvexPolygon<double>(hexagon), 0.2},
      Polygon<double>(notched),
      Compound<double>({{Box<double>({1, 1}), {{1, 0}, Rot2d::from_angle(0.4)}},
                        {Capsule<double>(1, 0.3), {{-1, 0.5}, Rot2d::from_angle(1.1)}}}),
  };
  for (const Shaped& shape : shapes) {
    const MassProperties<double> got = mass_properties(shape), grid = by_grid(shape);
    EXPECT_NEAR(got.area, grid.area, 1e-2 * grid.area) << shape.name() << " " << shape.rounding();
    EXPECT_NEAR(length(got.center - grid.center), 0, 1e-2) << shape.name() << " " << shape.rounding();
    EXPECT_NEAR(got.inertia, grid.inertia, 2e-2 * grid.inertia) << shape.name() << " " << shape.rounding();
  }
}

TEST(PlaneMass, KnownFormulas) {
  const double pi = std::acos(-1.0);
  const auto box = mass_properties(Shaped(Box<double>({2, 3})));
  EXPECT_DOUBLE_EQ(box.area, 6);
  EXPECT_DOUBLE_EQ(box.inertia, 6 * (4 + 9) / 12.0);
  const auto disc = mass_properties(Shaped(Circle<double>(2)));
  EXPECT_DOUBLE_EQ(disc.inertia, pi * 16 / 2);
  // A rounded box turns into the disc as the box vanishes, and a capsule is a rounded segment.
  const auto capsule = mass_properties(Shaped(Capsule<double>(1.5, 0.4)));
  const auto rounded = mass_properties(Shaped(Segment<double>({0, -0.75}, {0, 0.75}), 0.4));
  EXPECT_NEAR(capsule.inertia, rounded.inertia, 1e-14);
  // Of a tapered capsule whose discs grow alike.
  const auto tapered = mass_properties(Shaped(Capsule<double>(1.5, 0.4, 0.4 + 1e-9)));
  EXPECT_NEAR(tapered.inertia, capsule.inertia, 1e-7);
}

TEST(PlaneMass, WhatHasNoAreaHasNone) {
  EXPECT_EQ(mass_properties(Shaped(Segment<double>({0, 0}, {1, 0}))).area, 0);
  EXPECT_EQ(mass_properties(Shaped(HalfPlane<double>())).area, 0);
  EXPECT_EQ(mass_properties(Shaped(Box<double>({3, 0}))).area, 0);
}

TEST(PlaneMass, FarFromTheOriginItKeepsItsDigits) {
  std::vector<Vec2d> far;
  for (const Vec2d& p : notched) far.push_back(p + Vec2d{1e6, -2e6});
  const auto near = mass_properties(Shaped(Polygon<double>(notched))),
             moved = mass_properties(Shaped(Polygon<double>(far)));
  EXPECT_NEAR(moved.area, near.area, 1e-9);
  // The centre is right to the digits of coordinates that large, and the inertia of their squares' differences.
  EXPECT_NEAR(moved.center.x - 1e6, near.center.x, 1e-8);
}

TEST(PlaneMass, TenThousandVerticesMakeACircle) {
  std::vector<Vec2d> points;
  for (int i = 0; i < 10000; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / 10000;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  const double pi = std::acos(-1.0);
  for (const Shaped& shape : {Shaped(ConvexPolygon<double>(points)), Shaped(Polygon<double>(points))}) {
    EXPECT_NEAR(mass_properties(shape).area, pi, 1e-6) << shape.name();
    EXPECT_NEAR(mass_properties(shape).inertia, pi / 2, 1e-6) << shape.name();
  }
}

}  // namespace
}  // namespace graze::plane
