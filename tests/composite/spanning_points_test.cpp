// The points that span a manifold: of rows, of rectangles, and of any points, against their reach in all directions.
#include "composite/spanning_points.hpp"

#include <gtest/gtest.h>

#include "common/specimen.hpp"

namespace graze::testing {
namespace {

/// A point of a plane with coordinates (u, v), as deep as `depth` says, off its place by rounding.
struct Placed {
  double u, v, depth;
};

/// The manifold of points on the plane across a normal, each of them twice, as both triangles of an edge find it.
Manifold<double> manifold_of(const std::vector<Placed>& places, const Vec3d& normal, Random& random) {
  Manifold<double> manifold;
  manifold.normal = normal;
  const Vec3d u = normalized(any_perpendicular(normal)), v = cross(normal, u);
  for (int copy = 0; copy < 2; ++copy)
    for (const Placed& p : places) {
      const Vec3d a = u * p.u + v * p.v + converted<double>(random_vector(random, 1)) * 2e-16;
      manifold.points.push_back({a, a - normal * p.depth, -p.depth * (1 + 1e-16 * copy)});
    }
  return manifold;
}

/// How many of a manifold's points are at a place.
std::size_t count_at(const Manifold<double>& manifold, const Placed& place, const Vec3d& normal) {
  const Vec3d u = normalized(any_perpendicular(normal)), v = cross(normal, u);
  return static_cast<std::size_t>(std::count_if(manifold.points.begin(), manifold.points.end(), [&](const auto& p) {
    return length(p.a - u * place.u - v * place.v) < 1e-12;
  }));
}

/// As for the points of one piece.
void leave_out_spanned(Manifold<double>& manifold) {
  PointNames names;
  names.take(manifold, {});
  keep_spanning(manifold, 1.0, names);
  names.give(manifold);
}

Vec3d random_direction(Random& random) { return normalized(converted<double>(random_vector(random, 1))); }

// An edge that stands across the first of the two directions in which points are compared: the order of its points
// along that direction is rounding.
TEST(KeepSpanning, ARowKeepsBothOfItsEnds) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d normal = random_direction(random);
    const Placed row[] = {{0, 0, 0.1}, {0, 0.25, 0.1}, {0, 1, 0.1}, {0, 0.5, 0.1}};
    Manifold<double> manifold = manifold_of({std::begin(row), std::end(row)}, normal, random);
    leave_out_spanned(manifold);
    ASSERT_EQ(manifold.points.size(), 2u);
    EXPECT_EQ(count_at(manifold, row[0], normal), 1u);
    EXPECT_EQ(count_at(manifold, row[2], normal), 1u);
  }
}

TEST(KeepSpanning, ARectangleKeepsItsFourCorners) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d normal = random_direction(random);
    std::vector<Placed> places;
    for (int x = 0; x <= 3; ++x)
      for (int y = 0; y <= 3; ++y) places.push_back({x / 3.0, y / 2.0, 0.1 + x * 0.01});
    std::shuffle(places.begin(), places.end(), random);
    Manifold<double> manifold = manifold_of(places, normal, random);
    leave_out_spanned(manifold);
    ASSERT_EQ(manifold.points.size(), 4u);
    for (const double x : {0.0, 1.0})
      for (const double y : {0.0, 1.5}) EXPECT_EQ(count_at(manifold, {x, y, 0}, normal), 1u);
  }
}

// Of points that differ by rounding any may be left: its number is not to depend on which.
TEST(KeepSpanning, APointHasTheNumberOfTheLowestPieceAtItsPlace) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d normal = random_direction(random);
    Manifold<double> manifold = manifold_of({{0, 0, 0.1}, {1, 0, 0.1}, {1, 1, 0.1}, {0, 1, 0.1}}, normal, random);
    PointNames names;
    Manifold<double> all;
    all.normal = normal;
    for (std::uint32_t k = 0; k < 8; ++k) {
      Manifold<double> piece;
      piece.points.push_back(manifold.points[k]);
      piece.points[0].feature = k;
      names.take(piece, {k < 4 ? 2u : 1u, 0});
      all.points.push_back(piece.points[0]);
    }
    keep_spanning(all, 1.0, names);
    names.give(all);
    ASSERT_EQ(all.points.size(), 4u);
    for (const ContactPoint<double>& p : all.points) EXPECT_GE(p.feature, 4u);
  }
}

// What is deeper than those around it stays, once; what is as deep as they are there, or less, does not.
TEST(KeepSpanning, DeeperPointsInsideStay) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d normal = random_direction(random);
    const Placed deeper{0.5, 0.5, 0.3}, less{0.25, 0.75, 0.05}, same{0.75, 0.5, 0.1};
    std::vector<Placed> places{{0, 0, 0.1}, {1, 0, 0.1}, {1, 1, 0.1}, {0, 1, 0.1}, deeper, less, same};
    std::shuffle(places.begin(), places.end(), random);
    Manifold<double> manifold = manifold_of(places, normal, random);
    leave_out_spanned(manifold);
    ASSERT_EQ(manifold.points.size(), 5u);
    EXPECT_EQ(count_at(manifold, deeper, normal), 1u);
  }
}

// Any points: no direction finds a dropped one beyond those that are left, and no place is held twice.
TEST(KeepSpanning, NothingIsLeftOutThatReachesFurther) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d normal = random_direction(random);
    std::vector<Placed> places;
    const auto count = 2 + random() % 12;
    // On a lattice half of the time, so that many lie in rows.
    const bool lattice = random() % 2 == 0;
    for (std::uint64_t k = 0; k < count; ++k) {
      const auto u = static_cast<double>(uniform(random, 0, 1)), v = static_cast<double>(uniform(random, 0, 1));
      places.push_back(lattice ? Placed{std::round(u * 4), std::round(v * 4), 0.1} : Placed{u, v, 0.1});
    }
    Manifold<double> manifold = manifold_of(places, normal, random);
    const Manifold<double> all = manifold;
    leave_out_spanned(manifold);
    for (int k = 0; k < 64; ++k) {
      const Vec3d along = random_direction(random), across = along - normal * dot(along, normal);
      const auto reach = [&](const Manifold<double>& m) {
        double most = -1e300;
        for (const auto& p : m.points) most = greatest(most, dot(p.a, across));
        return most;
      };
      ASSERT_NEAR(reach(manifold), reach(all), 1e-9);
    }
    for (const auto& p : manifold.points)
      for (const auto& q : manifold.points) ASSERT_TRUE(&p == &q || length(p.a - q.a) > 1e-9);
  }
}

}  // namespace
}  // namespace graze::testing
