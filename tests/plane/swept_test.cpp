// What a shape of the plane sweeps, against the shape at the places it sweeps over.
#include "graze/plane/swept.hpp"

#include <gtest/gtest.h>

#include "graze/plane/support.hpp"
#include "plane/figures.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneSwept : public ::testing::Test {};
using SweptScalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneSwept, SweptScalars);

TYPED_TEST(PlaneSwept, OverlapsWhatTheMovingShapeHits) {
  using T = TypeParam;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-4, 4);
  // As near as a hit is known, and the rounding of the swept corners.
  constexpr T close = std::is_same_v<T, float> ? T(1e-4) : T(1e-8);
  int hits = 0, misses = 0;
  for (int i = 0; i < figure_kinds * figure_kinds * 30; ++i) {
    const Shape<T> a = random_figure<T>(i % figure_kinds, 1, random).shape,
                   b = random_figure<T>(i / figure_kinds % figure_kinds, 1, random).shape;
    const Pose2<T> at_a = random_pose<T>(1, random), at_b = random_pose<T>(1, random);
    const T x = static_cast<T>(uniform(random)), y = static_cast<T>(uniform(random));
    const T gap = distance(swept(a, at_a, {x, y}), at_a, b, at_b).distance;
    if (std::abs(gap) < close) continue;
    const bool hit = cast<T>(a, at_a, {{x, y}, T(0)}, b, at_b, {}, T(1)).has_value();
    ASSERT_EQ(hit, gap < T(0)) << gap << ", kinds " << i % figure_kinds << " and " << i / figure_kinds % figure_kinds;
    ++(hit ? hits : misses);
  }
  EXPECT_GT(hits, 300);
  EXPECT_GT(misses, 300);
}

TEST(PlaneSweptShapes, KeepStraightSidesAndRoundings) {
  const Pose2d pose{{1, 2}, {0.6, 0.8}};
  const Shaped of_circle = swept(Shaped(Circle<double>(0.5), 0.25), pose, {0, 3});
  EXPECT_NE(of_circle.as<Segment<double>>(), nullptr);
  EXPECT_EQ(of_circle.rounding(), 0.75);
  // Along (0, 3) in the world from (1, 2).
  const Shaped probe(Circle<double>(0));
  EXPECT_NEAR(distance(of_circle, pose, probe, Pose2d{{3, 4}, {}}).distance, 2 - 0.75, 1e-15);
  EXPECT_NEAR(distance(of_circle, pose, probe, Pose2d{{1, 7}, {}}).distance, 2 - 0.75, 1e-15);
  const Shaped of_box = swept(Shaped(Box<double>({1, 2}), 0.5), {}, {3, 4});
  ASSERT_NE(of_box.as<ConvexPolygon<double>>(), nullptr);
  EXPECT_EQ(of_box.as<ConvexPolygon<double>>()->vertices().size(), 6u);
  EXPECT_EQ(of_box.rounding(), 0.5);
  EXPECT_NE(swept(Shaped(Ellipse<double>({1, 2})), {}, {3, 4}).as<UserConvex<double>>(), nullptr);
}

TEST(PlaneSweptShapes, RefuseWhatIsNotConvexOrBounded) {
  const std::vector<Vec2d> line{{0, 0}, {1, 0}, {2, 1}};
  EXPECT_THROW(swept(Shaped(HalfPlane<double>()), {}, {1, 0}), InvalidValue);
  EXPECT_THROW(swept(Shaped(Chain<double>(line)), {}, {1, 0}), InvalidValue);
  EXPECT_THROW(swept(Shaped(Circle<double>(1)), {}, {std::nan(""), 0}), InvalidValue);
}

TEST(PlaneSupport, IsAsFarAsTheShapeReaches) {
  std::mt19937 random(8);
  for (int i = 0; i < figure_kinds * 200; ++i) {
    const Figure<double> figure = random_figure<double>(i % figure_kinds, 1, random);
    const double angle = std::uniform_real_distribution<double>(-4, 4)(random);
    const Vec2d n{std::cos(angle), std::sin(angle)};
    ASSERT_NEAR(dot(support(figure.shape, n * 3.0), n), double(figure.reach(n.x, n.y)), 1e-14) << i % figure_kinds;
  }
  EXPECT_EQ(support(Shaped(HalfPlane<double>()), {0, 1}), Vec2d{});
}

}  // namespace
}  // namespace graze::plane
