// Caps of cylinders, cones and truncated cones that stand: how far their points reach, and that they keep their names.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "graze/query.hpp"

namespace graze::testing {
namespace {

constexpr double pi = 3.14159265358979323846;

/// How far the points of a manifold reach along a horizontal direction.
template <class T>
double reach(const Manifold<T>& manifold, const Vec3<T>& direction) {
  double most = -1;
  for (const auto& p : manifold.points) most = std::max(most, static_cast<double>(dot(p.b, direction)));
  return most;
}

template <class T>
class StandingCaps : public ::testing::Test {
 protected:
  static constexpr T radius = T(0.5);
  const Shape<T> floors[3] = {Box<T>({8, 2, 8}), HalfSpace<T>(), Rectangle<T>(8, 8)};
  const Shape<T> bodies[4] = {Cylinder<T>(1, radius), Cylinder<T>(1, radius, T(0.2)), Cylinder<T>(1, radius, 0),
                              Shape<T>(Cylinder<T>(1, radius - T(0.05)), T(0.05))};

  /// A body with its lowest point at y = 0, whose cap is lowest at the angle `towards` by a lean.
  Manifold<T> standing(const Shape<T>& floor, const Shape<T>& body, double lean, double towards, double turned,
                       T margin) const {
    const Quatd leans = Quatd::from_axis_angle({std::sin(towards), 0, -std::cos(towards)}, lean);
    Pose<T> pose{{}, converted<T>(normalized(leans * Quatd::from_axis_angle({0, 1, 0}, turned)))};
    pose.translation.y = -bounds(body, pose).lower.y;
    const T top = floor.template as<Box<T>>() ? T(1) : T(0);
    Manifolds<T> manifolds;
    contacts(floor, Pose<T>{{0, -top, 0}, {}}, body, pose, margin, manifolds);
    return manifolds.size() == 1 ? manifolds[0] : Manifold<T>{};
  }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(StandingCaps, Scalars);

TYPED_TEST(StandingCaps, ReachTheWholeRadiusWhereTheyLeanAndNineTenthsAllAround) {
  using T = TypeParam;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for (const Shape<T>& floor : this->floors)
    for (const Shape<T>& body : this->bodies)
      for (const double lean : {0.0, 1e-6, 1e-4, 1.1e-3, 3e-3, 0.01, 0.03})
        for (int i = 0; i < 40; ++i) {
          const double towards = angle(random);
          // All points of the cap are within the margin.
          const Manifold<T> m = this->standing(floor, body, lean, towards, angle(random), T(0.05));
          SCOPED_TRACE(::testing::Message() << floor.name() << ' ' << body.name() << " leaning " << lean);
          ASSERT_EQ(m.points.size(), 8u);
          // The flat part of the cap: what is rounded is left out. Its middle moves with the lean, by half its height.
          const double flat = static_cast<double>(this->radius - body.rounding()), moved = 0.6 * lean;
          const auto along = [](double a) { return Vec3<T>{T(std::cos(a)), 0, T(std::sin(a))}; };
          if (lean >= 1e-3) {
            EXPECT_GT(reach(m, along(towards)), flat * (1 - 1e-5) - moved);
          }
          for (double a = 0; a < 2 * pi; a += 0.1)
            EXPECT_GT(reach(m, along(a)), flat * (std::cos(pi / 8) - 1e-5) - moved) << a;
        }
}

TYPED_TEST(StandingCaps, KeepTheirNamesHoweverTheyLean) {
  using T = TypeParam;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> angle(-pi, pi), milliradians(0, 2e-3);
  for (const Shape<T>& floor : this->floors)
    for (const Shape<T>& body : this->bodies) {
      std::set<std::uint32_t> first;
      for (int i = 0; i < 200; ++i) {
        const Manifold<T> m =
            this->standing(floor, body, i == 0 ? 0 : milliradians(random), angle(random), 0.3, T(0.01));
        std::set<std::uint32_t> now;
        for (const auto& p : m.points) now.insert(p.feature);
        if (i == 0) first = now;
        ASSERT_EQ(now, first) << floor.name() << ' ' << body.name() << ' ' << i;
      }
    }
}

}  // namespace
}  // namespace graze::testing
