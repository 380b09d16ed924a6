// The nearest point of an ellipse, against its definition in extended precision: no other point of the ellipse is
// nearer.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "graze/plane/query.hpp"

namespace graze::plane {
namespace {

/// The distance of a point from an ellipse, negative inside: the least over the angle, by a fine grid and then by
/// thirds.
double least_distance(const Vec2d& radii, const Vec2d& at) {
  const auto far = [&](long double angle) {
    return std::hypot(radii.x * std::cos(angle) - at.x, radii.y * std::sin(angle) - at.y);
  };
  constexpr int grid = 2000;
  constexpr long double turn = 2 * std::numbers::pi_v<long double> / grid;
  int best = 0;
  for (int i = 1; i < grid; ++i)
    if (far(i * turn) < far(best * turn)) best = i;
  long double low = (best - 1) * turn, high = (best + 1) * turn;
  for (int i = 0; i < 200; ++i) {
    const long double p = low + (high - low) / 3, q = high - (high - low) / 3;
    (far(p) < far(q) ? high : low) = far(p) < far(q) ? q : p;
  }
  const bool inside = std::hypot(at.x / radii.x, at.y / radii.y) < 1;
  return static_cast<double>(inside ? -far(low) : far(low));
}

double found_distance(const Vec2d& radii, const Vec2d& at) {
  const Distance<double> d = distance<double>(Ellipse<double>(radii), {}, Circle<double>(0), {at, {}});
  EXPECT_EQ(d.status, Status::converged);
  // What was found lies on the ellipse, the normal is its own, and both agree with the distance.
  const Vec2d gradient{d.a.x / (radii.x * radii.x), d.a.y / (radii.y * radii.y)};
  const double size = std::max(radii.x, radii.y);
  EXPECT_NEAR(std::hypot(d.a.x / radii.x, d.a.y / radii.y), 1, 1e-14);
  EXPECT_GE(dot(gradient, d.normal) / length(gradient), 1 - 1e-14);
  EXPECT_LE(length(d.b - d.a - d.normal * d.distance), 1e-14 * (size + length(at)));
  return d.distance;
}

TEST(PlaneNearestEllipse, IsRightForAnyRatioInsideAndOutside) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.5, 1.5), ratios(-4, 4);
  for (int i = 0; i < 400; ++i) {
    const Vec2d radii{1, i % 4 == 0 ? 1 + 1e-3 * any(random) : std::pow(10, ratios(random))};
    const Vec2d at{any(random) * radii.x, any(random) * radii.y};
    const double size = std::max(radii.x, radii.y);
    EXPECT_NEAR(found_distance(radii, at), least_distance(radii, at), 1e-14 * (size + length(at)))
        << radii.y << " at " << at.x << ", " << at.y;
  }
}

TEST(PlaneNearestEllipse, IsRightOnTheAxesAndAtTheCentre) {
  for (const double short_radius : {1.0, 0.999, 0.999999999999, 0.5, 1e-3, 1e-9})
    for (const double along : {0.0, 1e-300, 1e-9, 0.3, 0.74, 0.75, 0.999, 1.0, 1.5})
      for (const bool on_long : {true, false})
        for (const bool upright : {true, false}) {
          const double place = along * (on_long ? 1 : short_radius);
          Vec2d radii{1, short_radius}, at = on_long ? Vec2d{place, 0} : Vec2d{0, place};
          if (upright) std::swap(radii.x, radii.y), std::swap(at.x, at.y);
          EXPECT_NEAR(found_distance(radii, at), least_distance(radii, at), 1e-14)
              << short_radius << " at " << at.x << ", " << at.y;
        }
}

// Against a disc the centre of a nearly round ellipse used to be off by 1.4e-5 of the size, and said so.
TEST(PlaneNearestEllipse, ADiscInTheMiddleOfANearCircle) {
  const Distance<double> d = distance<double>(Ellipse<double>({1, 0.999}), {}, Circle<double>(0.25), {});
  EXPECT_EQ(d.status, Status::converged);
  EXPECT_NEAR(d.distance, -1.249, 1e-15);
}

}  // namespace
}  // namespace graze::plane
