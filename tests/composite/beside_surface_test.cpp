// Contacts beside the pieces of a surface: bodies next to a rim, under a slope and over an edge, which the planes of
// triangles go on below and above, though the triangles do not.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "common/cube_mesh.hpp"
#include "graze/cast.hpp"
#include "graze/query.hpp"

namespace graze::testing {
namespace {

using SheetPoints = std::vector<Vec3d>;
using SheetTriangles = std::vector<Mesh<double>::Index>;

Manifolds<double> contacts_beside(const Shape<double>& a, const Shape<double>& b, const Posed& pose_b, double margin) {
  Manifolds<double> manifolds;
  contacts(a, Posed{}, b, pose_b, margin, manifolds);
  return manifolds;
}
double least_distance_of(const Manifolds<double>& manifolds) {
  double least_distance = std::numeric_limits<double>::infinity();
  for (const Manifold<double>& m : manifolds)
    for (const ContactPoint<double>& p : m.points) least_distance = std::min(least_distance, p.distance);
  return least_distance;
}

/// A cone whose base lies below a sheet's plane, beside the sheet: laid along the sheet's normal it was 0.14 deep.
TEST(BesideSurface, ABaseBelowASheetIsNoContact) {
  const Shape<double> sheet =
      Mesh<double>(SheetPoints{{-0.38, 0.01, -0.65}, {0, 0.01, -0.46}, {0, 0.01, -0.65}, {-0.4, 0, -0.5}},
                   SheetTriangles{{0, 1, 2}, {0, 3, 1}});
  const Shape<double> cone = Cylinder<double>(0.38, 0.11, 0.0);
  const Posed at{{-0.47, 0.06, -0.61}, {}};
  EXPECT_NEAR(distance(sheet, Posed{}, cone, at).distance, 0.012919, 1e-6);
  EXPECT_NEAR(least_distance_of(contacts_beside(sheet, cone, at, 0.03)), 0.012919, 1e-6);
}

/// A box beside the ridge of two triangles, apart from both: it was 0.2 deep.
TEST(BesideSurface, ABoxBesideARidgeIsApart) {
  const Shape<double> ridge =
      Mesh<double>(SheetPoints{{0.34, -0.9, 0.55}, {0.35, -0.49, 0.57}, {0.16, -0.72, 0.75}, {0, -0.64, 0.4}},
                   SheetTriangles{{0, 1, 2}, {0, 2, 3}});
  const Shape<double> box = Box<double>({0.45, 0.68, 0.89});
  const Posed at{{0.568, -1.072, 0.986},
                 {-0.6008988459116817, 0.023233459825380803, -0.5266493341600685, -0.600850449076397}};
  EXPECT_GT(distance(ridge, Posed{}, box, at).distance, 0.005);
  EXPECT_GT(least_distance_of(contacts_beside(ridge, box, at, 0.01)), 0);
}

/// A hull that hardly touches a pyramid is as deep whatever the margin: with one of 0.03 it was 0.11 deep.
TEST(BesideSurface, AMarginMakesNothingDeeper) {
  const Shape<double> hull = ConvexHull<double>(
      SheetPoints{{-0.05, -0.24, -0.23}, {0.15, 0.21, 0.27}, {-0.19, -0.07, -0.35}, {0.21, 0.12, 0.27}});
  const Shape<double> pyramid = Mesh<double>(SheetPoints{{0, 0.3, 0}, {0, 0, 0.42}, {0.4, 0, 0}, {-0.4, 0, 0}},
                                             SheetTriangles{{0, 1, 2}, {0, 3, 1}});
  const Posed at{{-0.02, -0.14, -0.6}, {}};
  for (const double margin : {0.0, 0.03})
    EXPECT_NEAR(least_distance_of(contacts_beside(hull, pyramid, at, margin)), -0.0017945, 1e-6) << margin;
}

/// What touches a corner with no face of either opposite it has its point there, and not where it reaches lowest.
TEST(BesideSurface, TheLastResortStandsOnThePiece) {
  const Shape<double> pyramid = Mesh<double>(SheetPoints{{0, 0.5, 0}, {0, 0, 0.6}, {0.6, 0, 0}, {-0.6, 0, 0}},
                                             SheetTriangles{{0, 1, 2}, {0, 3, 1}});
  const Shape<double> cylinder = Cylinder<double>(0.25, 0.12, 0.12);
  const Posed at{{0.043, -0.159, 0.645},
                 {-0.15671306318089653, -0.17878476387131317, -0.22878972322293714, 0.9439980331459971}};
  const Manifolds<double> found = contacts_beside(pyramid, cylinder, at, 0);
  ASSERT_EQ(found.size(), 1u);
  for (const ContactPoint<double>& p : found[0].points) {
    EXPECT_LT(std::abs(closest(pyramid, Posed{}, p.a).distance), 1e-9);
    EXPECT_LT(std::abs(closest(cylinder, at, p.b).distance), 0.002);
    EXPECT_LT(max_abs(p.b - p.a - found[0].normal * p.distance), 1e-12);
  }
}

/// A box that stands over the edge of another by a hair keeps its points within the margin: from 1e-12 to 1e-5 beside
/// the edge there were none.
TEST(BesideSurface, AnEdgeOverAnEdgeIsNear) {
  const Shape<double> box = Box<double>({1, 1, 1}), child = Compound<double>({{box, {}}}),
                      sheet = Mesh<double>(
                          SheetPoints{{-0.5, 0.5, -0.5}, {-0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, -0.5}},
                          SheetTriangles{{0, 1, 2}, {0, 2, 3}});
  for (const Shape<double>& ground : {box, child, sheet})
    for (const double beside : {0.0, 1e-12, 1e-9, 1e-6, 9e-6, 1e-4}) {
      const Posed at{{1 + beside, 1.05, 0}, {}};
      EXPECT_NEAR(least_distance_of(contacts_beside(ground, box, at, 0.1)), 0.05, 1e-6)
          << ground.name() << ", " << beside;
    }
}

/// A compound of which one ball is inside a solid and another one touches it: `cast` tells the depth that `distance`
/// has.
TEST(BesideSurface, ACastFromInsideHasTheDepthOfTheDeepestChild) {
  const Shape<double> solid = cube_mesh(2.0, true);
  const Shape<double> balls = Compound<double>({{Sphere<double>(0.5), {}}, {Sphere<double>(0.5), {{0, 2.4, 0}, {}}}});
  const auto hit = cast(solid, Posed{}, {}, balls, Posed{}, {{0, 1, 0}, {}}, 1.0);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 0);
  EXPECT_NEAR(hit->depth, -distance(solid, Posed{}, balls, Posed{}).distance, 1e-12);
}

}  // namespace
}  // namespace graze::testing
