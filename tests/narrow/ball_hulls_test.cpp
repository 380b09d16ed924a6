// The signed distance of tapered capsules in closed form, beside all directions one by one.
#include "narrow/depth/ball_hulls.hpp"

#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

/// The largest gap of many directions: no more than the distance, and little less.
double sampled(const BallHull& a, const BallHull& b) {
  double best = -std::numeric_limits<double>::infinity();
  constexpr int rings = 250;
  for (int i = 0; i <= rings; ++i)
    for (int k = 0; k < 2 * rings; ++k) {
      const double z = -1 + 2.0 * i / rings, r = std::sqrt(1 - z * z), angle = 3.14159265358979 * k / rings;
      const Vec3d n{r * std::cos(angle), z, r * std::sin(angle)};
      double least_gap = std::numeric_limits<double>::infinity();
      for (const Ball& p : a.ball)
        for (const Ball& q : b.ball) least_gap = least(least_gap, dot(q.center - p.center, n) - p.radius - q.radius);
      best = greatest(best, least_gap);
    }
  return best;
}

double gap(const BallHull& a, const BallHull& b, const Vec3d& n) {
  double least_gap = std::numeric_limits<double>::infinity();
  for (const Ball& p : a.ball)
    for (const Ball& q : b.ball) least_gap = least(least_gap, dot(q.center - p.center, n) - p.radius - q.radius);
  return least_gap;
}

/// How far a point is from a hull of two balls, itself by the closed form.
double outside(const Vec3d& point, const BallHull& hull) {
  const BallHull p{{{point, 0}, {point, 0}}};
  return distance_of(hull, p).distance;
}

void expect_right(const BallHull& a, const BallHull& b) {
  const CoreDistance<double> d = distance_of(a, b);
  EXPECT_NEAR(length(d.normal), 1, 1e-15);
  EXPECT_NEAR(d.distance, gap(a, b, d.normal), 1e-14);
  const double seen = sampled(a, b);
  EXPECT_GE(d.distance, seen - 1e-14);
  EXPECT_NEAR(d.distance, seen, 0.1);  // near the poles the samples lie up to an eighth of a radian apart
  EXPECT_LE(length(d.b - d.a - d.normal * d.distance), 1e-14);
  EXPECT_NEAR(outside(d.a, a), 0, 1e-9);
  EXPECT_NEAR(outside(d.b, b), 0, 1e-9);
  EXPECT_NEAR(distance_of(b, a).distance, d.distance, 1e-14);
}

TEST(BallHulls, AreAsFarApartAsTheBestDirectionSays) {
  testing::Random random(7);
  for (int i = 0; i < 100; ++i) {
    const auto ball = [&] {
      const Vec3d center = converted<double>(testing::random_vector(random, 1));
      return Ball{center, static_cast<double>(random() % 8) / 10};
    };
    expect_right({{ball(), ball()}}, {{ball(), ball()}});
  }
}

TEST(BallHulls, ThatAreAlikeInOnePlace) {
  const BallHull cone{{{{0, -0.5, 0}, 0.5}, {{0, 0.5, 0}, 0.3}}}, capsule{{{{0, -1, 0}, 0.25}, {{0, 1, 0}, 0.25}}},
      ball{{{{0, 0, 0}, 1}, {{0, 0, 0}, 1}}}, point{{{{0, 0, 0}, 0}, {{0, 0, 0}, 0}}},
      swallowed{{{{0, 0, 0}, 1}, {{0, 0.1, 0}, 0.2}}};
  for (const BallHull& a : {cone, capsule, ball, point, swallowed})
    for (const BallHull& b : {cone, capsule, ball, point, swallowed}) expect_right(a, b);
  EXPECT_DOUBLE_EQ(distance_of(cone, cone).distance, -1);
  EXPECT_DOUBLE_EQ(distance_of(capsule, capsule).distance, -0.5);
}

TEST(BallHulls, MakeTaperedCapsulesInEachOtherProven) {
  const Shape<double> cone = Capsule<double>(1, 0.5, 0.3);
  const Distance<double> d = distance(cone, Pose<double>{}, cone, Pose<double>{});
  EXPECT_EQ(d.status, Status::converged);
  EXPECT_DOUBLE_EQ(d.distance, -1);
}

}  // namespace
}  // namespace graze
