// Curved shapes that touch exactly or up to rounding: the way between their nearest points has no direction there, and
// the normal is one along which their separation is their distance.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "figures.hpp"

namespace graze::plane {
namespace {

using Shaped = Shape<double>;
using Posed2 = Pose2<double>;

/// The normals of a pair that touches, from every query that has one, are `expected`: within the root of the goal of
/// the search, 1e-11, as everywhere.
void expect_normal(const Shaped& a, const Posed2& pose_a, const Shaped& b, const Posed2& pose_b, const Vec2d& expected,
                   const std::string& pair) {
  constexpr double allowed = 1e-5;
  const auto off = [&](const Vec2d& normal) { return length(normal - expected); };
  const Distance<double> d = distance(a, pose_a, b, pose_b);
  EXPECT_LE(std::abs(d.distance), 1e-11) << pair;
  EXPECT_EQ(d.status, Status::converged) << pair;
  EXPECT_LE(off(d.normal), allowed) << pair;
  Manifolds<double> touching;
  contacts(a, pose_a, b, pose_b, 1e-6, touching);
  ASSERT_EQ(touching.size(), 1u) << pair;
  EXPECT_LE(off(touching[0].normal), allowed) << pair;
  const auto hit = cast<double>(a, pose_a, {}, b, pose_b, {-expected, 0}, 1);
  ASSERT_TRUE(hit) << pair;
  EXPECT_LE(hit->t, 1e-5) << pair;
  EXPECT_LE(off(hit->normal), allowed) << pair;
}

TEST(PlaneTouching, HasTheNormalOfAnEllipseOnWhatItLiesOn) {
  const Shaped box = Box<double>({0.5, 0.5}), segment = Segment<double>({-0.3, 0}, {0.25, 0}),
               polygon = ConvexPolygon<double>(std::vector<Vec2d>{{-0.25, 0.25}, {0, -0.5}, {0.5, 0.25}}),
               ellipse = Ellipse<double>({0.5, 0.25}), rounded(Ellipse<double>({0.25, 0.125}), 0.125);
  struct Below {
    const Shaped& shape;
    double top;
    const char* name;
  };
  for (const Below& below : {Below{box, 0.25, "box"},
                             {segment, 0, "segment"},
                             {polygon, 0.25, "polygon"},
                             {ellipse, 0.25, "ellipse"},
                             {rounded, 0.25, "rounded ellipse"}})
    for (const Below& above : {Below{ellipse, 0.25, "ellipse"}, {rounded, 0.25, "rounded ellipse"}})
      for (const double turn : {0.0, 1.5707963267948966, 0.7, 3.0}) {
        const Rot2<double> rotation = Rot2<double>::from_angle(turn);
        const Vec2d up = rotate(rotation, Vec2d{0, 1});
        const std::string pair = std::string(below.name) + " and " + above.name + " at " + std::to_string(turn);
        expect_normal(below.shape, {up * -below.top, rotation}, above.shape, {up * above.top, rotation}, up, pair);
        expect_normal(above.shape, {up * above.top, rotation}, below.shape, {up * -below.top, rotation}, -up, pair);
      }
}

// The Minkowski difference is thinner than it is known: its nearest edge may be that of its other side.
TEST(PlaneTouching, LooksAtTheSideOfAThinDifferenceThatFacesTheOrigin) {
  const Shaped segment = Segment<double>({-1, 0}, {1, 0});
  for (const double size : {1e-10, 1e-12, 1e-14, 1e-17}) {
    const Shaped speck = Capsule<double>(size, size / 3, size / 5);
    for (int i = 0; i < 400; ++i) {
      const Rot2<double> turn = Rot2<double>::from_angle(i);
      const double above = i % 2 == 0 ? 0.1 : -0.1, along = 0.8 * std::sin(2.0 * i);
      const Vec2d at = rotate(turn, Vec2d{along, above}), normal = rotate(turn, Vec2d{0, above < 0 ? -1.0 : 1.0});
      const Distance<double> d = distance<double>(segment, {{}, turn}, speck, {at, Rot2<double>::from_angle(3 * i)});
      EXPECT_NEAR(d.distance, 0.1, 1e-9) << size << " " << i;
      EXPECT_LE(length(d.normal - normal), 1e-5) << size << " " << i;
    }
  }
}

template <class T>
class PlaneTouchingPairs : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneTouchingPairs, Scalars);

bool curved(int kind) { return kind == 3 || kind >= 6; }

// Moved along their own normal until they touch, and then apart or into each other by gaps from rounding to far above.
TYPED_TEST(PlaneTouchingPairs, HaveTheirDistanceAlongTheirNormal) {
  using T = TypeParam;
  std::mt19937 random(7);
  for (int kind_a = 0; kind_a < figure_kinds; ++kind_a)
    for (int kind_b = 0; kind_b < figure_kinds; ++kind_b) {
      if (!curved(kind_a) && !curved(kind_b)) continue;
      for (int i = 0; i < 60; ++i) {
        const double scale = std::pow(10.0, i % 5 - 2);
        const Figure<T> a = random_figure<T>(kind_a, scale, random), b = random_figure<T>(kind_b, scale, random);
        const Pose2<T> pose_a = random_pose<T>(scale, random);
        Pose2<T> pose_b = random_pose<T>(scale, random);
        for (const double gap : {0.0, 0.0, 1e-16, -1e-15, 1e-12, -1e-11, 2e-11, -1e-10, 1e-8, -1e-6, 1e-4}) {
          const Distance<T> before = distance(a.shape, pose_a, b.shape, pose_b);
          pose_b.translation += before.normal * (static_cast<T>(gap * scale) - before.distance);
          const Distance<T> d = distance(a.shape, pose_a, b.shape, pose_b);
          const std::string pair = std::string(a.shape.name()) + " and " + b.shape.name() + " " + std::to_string(i) +
                                   " by " + std::to_string(gap);
          ASSERT_EQ(d.status, Status::converged) << pair;
          const Wide x = d.normal.x, y = d.normal.y, l = std::hypot(x, y);
          const Wide along = separation_of(a, pose_a, b, pose_b)(x / l, y / l);
          const double allowed = double(tolerance<T>) * double(extent(a.shape) + extent(b.shape));
          ASSERT_NEAR(double(along), double(d.distance), allowed) << pair;
        }
      }
    }
}

}  // namespace
}  // namespace graze::plane
