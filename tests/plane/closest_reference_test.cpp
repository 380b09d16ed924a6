// The nearest point of a surface against extended precision, for all kinds of shapes.
#include <gtest/gtest.h>

#include "plane/moving_figures.hpp"
#include "plane/wide_outline.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneClosestReference : public ::testing::Test {};
using ClosestScalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneClosestReference, ClosestScalars);

/// How far a distance may be off, relative to the size.
template <class T>
constexpr double closest_error = double(tolerance<T>);
template <>
constexpr double closest_error<float> = 4e-6;

/// Asks for the nearest points of many; `expected(p)` is the signed distance of a point. `pieces`: where rounded pieces
/// lie over each other, the surface is that of the piece in which the point is deepest.
template <class T, class F>
void expect_closest(const Shape<T>& shape, const Pose2<T>& pose, double scale, std::mt19937& random, const F& expected,
                    bool pieces = false) {
  const auto number = [&] { return static_cast<T>(3 * scale * std::uniform_real_distribution<double>(-1, 1)(random)); };
  const std::string name = std::string(shape.name()) + " of " + std::to_string(scale);
  for (int i = 0; i < 12; ++i) {
    const T x = number();
    const Vec2<T> p = i % 3 == 0 ? Vec2<T>{x, number()} : pose.translation + Vec2<T>{x, number()} * T(0.2);
    const Closest<T> found = closest(shape, pose, p);
    const Wide truth = expected(p), allowed = closest_error<T> * scale + Wide(found.error);
    ASSERT_EQ(found.status, Status::converged) << name;
    ASSERT_NEAR(double((Wide(found.distance) - truth) / scale), 0, double(allowed / scale)) << name;
    ASSERT_NEAR(std::hypot(double(found.normal.x), double(found.normal.y)), 1,
                8 * double(std::numeric_limits<T>::epsilon()))
        << name;
    // The point is on the surface, and the normal leads from it to the point that was asked for.
    const double place = 8 * double(std::numeric_limits<T>::epsilon()) * 8;
    const Vec2<T> back = p - found.normal * found.distance;
    ASSERT_NEAR(double(std::hypot(Wide(back.x) - Wide(found.point.x), Wide(back.y) - Wide(found.point.y)) / scale), 0,
                double(allowed / scale) + place)
        << name;
    if (pieces && truth < 0) continue;
    ASSERT_NEAR(double(expected(found.point) / scale), 0, 2 * double(allowed / scale) + place) << name;
  }
}

constexpr double closest_scales[] = {1e-4, 1, 1e5};

TYPED_TEST(PlaneClosestReference, OfConvexShapes) {
  using T = TypeParam;
  std::mt19937 random(71);
  const Figure<T> spot{Circle<T>(0), [](Wide, Wide) { return Wide(0); }};
  for (const double scale : closest_scales)
    for (int round = 0; round < 8 * figure_kinds; ++round) {
      const Figure<T> figure = random_figure<T>(round % figure_kinds, scale, random);
      const Pose2<T> pose = random_pose<T>(scale, random);
      expect_closest(figure.shape, pose, scale, random, [&](const Vec2<T>& p) {
        return swept_distance(figure, wide(pose), spot, WidePose{p.x, p.y});
      });
      if (::testing::Test::HasFatalFailure()) return;
    }
}

TYPED_TEST(PlaneClosestReference, OfHalfPlanes) {
  using T = TypeParam;
  std::mt19937 random(72);
  for (const double scale : closest_scales)
    for (int round = 0; round < 20; ++round) {
      const T rounding = round % 2 ? static_cast<T>(0.2 * scale) : T(0);
      const Pose2<T> pose = random_pose<T>(scale, random);
      expect_closest({HalfPlane<T>(), rounding}, pose, scale, random,
                     [&](const Vec2<T>& p) { return into_frame(wide(pose), p).y - Wide(rounding); });
      if (::testing::Test::HasFatalFailure()) return;
    }
}

/// Points around a centre in the order of their angles, at distances that make most outlines concave.
template <class T>
std::vector<Vec2<T>> points_of_star(std::size_t count, double scale, std::mt19937& random) {
  std::uniform_real_distribution<double> reach(0.2, 1);
  std::vector<Vec2<T>> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::acos(-1.0) * double(i) / double(count), r = scale * reach(random);
    out.push_back({static_cast<T>(r * std::cos(angle)), static_cast<T>(r * std::sin(angle))});
  }
  return out;
}

TYPED_TEST(PlaneClosestReference, OfPolygonsAndChains) {
  using T = TypeParam;
  std::mt19937 random(73);
  for (const double scale : closest_scales)
    for (int round = 0; round < 40; ++round) {
      const auto points = points_of_star<T>(3 + random() % 30, scale, random);
      const T rounding = round % 3 == 0 ? static_cast<T>(0.1 * scale) : T(0);
      const Pose2<T> pose = random_pose<T>(scale, random);
      const bool closed = round % 2 == 0;
      const WideOutline solid(points, true), line(points, closed);
      expect_closest({Polygon<T>(points), T(0)}, pose, scale, random,
                     [&](const Vec2<T>& p) { return solid.signed_distance(into_frame(wide(pose), p)); });
      const ChainSides sides = round % 5 == 0 ? ChainSides::one : ChainSides::both;
      expect_closest(
          {Chain<T>(points, closed, sides), rounding}, pose, scale, random,
          [&](const Vec2<T>& p) { return line.to_edges(into_frame(wide(pose), p)) - Wide(rounding); }, true);
      if (::testing::Test::HasFatalFailure()) return;
    }
}

TYPED_TEST(PlaneClosestReference, OfCompounds) {
  using T = TypeParam;
  std::mt19937 random(74);
  const Figure<T> spot{Circle<T>(0), [](Wide, Wide) { return Wide(0); }};
  for (const double scale : closest_scales)
    for (int round = 0; round < 12; ++round) {
      // Children that do not overlap: the nearest of them has the nearest point.
      std::vector<Figure<T>> figures;
      std::vector<Pose2<T>> places;
      std::vector<Placed<T>> children;
      for (int k = 0; k < 3; ++k) {
        figures.push_back(random_figure<T>((round + 3 * k) % figure_kinds, 0.3 * scale, random));
        places.push_back({{static_cast<T>((k - 1) * 1.2 * scale), T(0)}, random_pose<T>(1, random).rotation});
        children.push_back({figures.back().shape, places.back()});
      }
      expect_closest<T>(Compound<T>(children), {}, scale, random, [&](const Vec2<T>& p) {
        Wide nearest = std::numeric_limits<Wide>::infinity();
        for (std::size_t k = 0; k < figures.size(); ++k)
          nearest = std::min(nearest, swept_distance(figures[k], wide(places[k]), spot, WidePose{p.x, p.y}));
        return nearest;
      });
      if (::testing::Test::HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace graze::plane
