// Faces that have sunk into a floor and lean: all of it that is under the floor is held, however much it leans. Points
// that a face loses with its lean leave it standing on one corner, which it turns about.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "graze/query.hpp"

namespace graze::testing {
namespace {

constexpr double base_depth = 0.15, reach = 0.2;

struct Floor {
  const char* name;
  Shaped shape;
  Posed pose;
};

/// Floors whose top is level at 0 and wider than what stands on them.
std::vector<Floor> floors() {
  const std::vector<Vec3d> corners{{-5, 0, -5}, {-5, 0, 5}, {5, 0, 5}, {5, 0, -5}};
  std::vector<Vec3d> block;
  for (const Vec3d& c : corners)
    for (const double y : {-1.0, 1.0}) block.push_back({c.x, y, c.z});
  return {{"half-space", HalfSpace<double>(), {}},
          {"box", Box<double>({10, 2, 10}), {{0, -1, 0}, {}}},
          {"hull", ConvexHull<double>(block), {{0, -1, 0}, {}}},
          {"rectangle", Rectangle<double>(10, 10), {}},
          {"mesh", Mesh<double>(corners, {{0, 1, 2}, {0, 2, 3}}), {}},
          {"height field", HeightField<double>(3, 3, std::vector<double>(9, 0), 4, 4), {}}};
}

/// The poses of a body whose base, `base_depth` below its origin, leans from the floor about several axes and lies
/// under it with everything within `reach` of its middle.
std::vector<Posed> sunk_leaning(double lean) {
  std::vector<Posed> out;
  for (int k = 0; k < 7; ++k) {
    const double around = 0.9 * k + 0.1, s = std::sin(lean / 2), c = std::cos(lean / 2);
    const double highest = -base_depth * std::cos(lean) + reach * std::sin(lean);
    out.push_back({{0.3, -highest - 0.01, 0.1}, {s * std::cos(around), 0, s * std::sin(around), c}});
  }
  return out;
}

std::vector<double> leans() { return {0.01, 0.03, 0.04, 0.1, 0.2, 0.35}; }

/// Calls `expect` with the points on the body, and its pose, for every floor and lean.
template <class Expect>
void with_every_lean(const Shaped& body, const Expect& expect) {
  for (const Floor& floor : floors())
    for (const double lean : leans())
      for (const Posed& pose : sunk_leaning(lean)) {
        SCOPED_TRACE(std::string(floor.name) + ", leaning by " + std::to_string(lean));
        Manifolds<double> found;
        contacts(floor.shape, floor.pose, body, pose, 0.0, found);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_GT(found[0].normal.y, 0.999);
        std::vector<Vec3d> points;
        for (const auto& p : found[0].points) points.push_back(p.b);
        expect(points, pose);
      }
}

/// A base of a cube's, of a box and of a hull: each of its corners is a point.
TEST(LeaningFaces, KeepTheirCorners) {
  const std::array<Vec3d, 4> base{Vec3d{-0.14, -base_depth, -0.14},
                                  {-0.14, -base_depth, 0.14},
                                  {0.14, -base_depth, 0.14},
                                  {0.14, -base_depth, -0.14}};
  std::vector<Vec3d> corners(base.begin(), base.end());
  for (const Vec3d& c : base) corners.push_back({c.x, base_depth, c.z});
  for (const Shaped& body : {Shaped(Box<double>({0.28, 0.3, 0.28})), Shaped(ConvexHull<double>(corners))})
    with_every_lean(body, [&](const std::vector<Vec3d>& points, const Posed& pose) {
      EXPECT_EQ(points.size(), 4u);
      for (const Vec3d& corner : base)
        EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                                [&](const Vec3d& p) { return length(p - transform(pose, corner)) < 1e-4; }))
            << corner.x << " " << corner.z;
    });
}

/// A pyramid of three sides, whose base is a triangle.
TEST(LeaningFaces, OfATetrahedronKeepTheirCorners) {
  const std::vector<Vec3d> corners{
      {0.2, -base_depth, 0}, {-0.1, -base_depth, 0.17}, {-0.1, -base_depth, -0.17}, {0, base_depth, 0}};
  with_every_lean(ConvexHull<double>(corners),
                  [&](const std::vector<Vec3d>& points, const Posed&) { EXPECT_EQ(points.size(), 3u); });
}

/// A cylinder and a cone: points all around the rim, the deepest among them.
TEST(LeaningFaces, OfCylindersAndConesKeepTheirRim) {
  for (const double top : {reach, 0.0})
    with_every_lean(Cylinder<double>(2 * base_depth, reach, top),
                    [&](const std::vector<Vec3d>& points, const Posed& pose) {
                      EXPECT_GE(points.size(), 4u);
                      double lowest = 0, widest = 0;
                      for (const Vec3d& p : points) {
                        lowest = std::min(lowest, p.y);
                        for (const Vec3d& q : points) widest = std::max(widest, length(p - q));
                      }
                      const Vec3d axis = rotate(pose.rotation, Vec3d{0, 1, 0});
                      const double across = std::sqrt(axis.x * axis.x + axis.z * axis.z);
                      EXPECT_NEAR(lowest, pose.translation.y - base_depth * axis.y - reach * across, 1e-4);
                      EXPECT_GT(widest, 1.9 * reach);
                    });
}

/// A capsule that lies: both of its ends.
TEST(LeaningFaces, OfCapsulesKeepTheirEnds) {
  for (const double lean : leans()) {
    const double s = std::sin(lean / 2 + 0.78539816339744831), c = std::cos(lean / 2 + 0.78539816339744831);
    const Posed pose{{0.3, 0.2 - 0.3 * std::sin(lean) - 0.01, 0.1}, {0, 0, s, c}};
    Manifolds<double> found;
    contacts(Shaped(HalfSpace<double>()), Posed{}, Shaped(Capsule<double>(0.6, 0.2)), pose, 0.0, found);
    ASSERT_EQ(found.size(), 1u) << lean;
    EXPECT_EQ(found[0].points.size(), 2u) << lean;
  }
}

}  // namespace
}  // namespace graze::testing
