// Sizes times a power of two: answers are the same bits, times that power.
#include <gtest/gtest.h>

#include "plane/figures.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneScale : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneScale, Scalars);

template <class T>
Vec2<T> point(double scale, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-3, 3);
  const double x = uniform(random), y = uniform(random);
  return {static_cast<T>(scale * x), static_cast<T>(scale * y)};
}

/// What every query answers about two shapes of about the size `scale`: lengths, divided by that, and the rest.
template <class T>
std::vector<T> answers(int kind_a, int kind_b, double scale, unsigned seed) {
  std::mt19937 random(seed);
  const Shape<T> a = random_figure<T>(kind_a, scale, random).shape, b = random_figure<T>(kind_b, scale, random).shape;
  const Pose2<T> at_a = random_pose<T>(scale / 2, random), at_b = random_pose<T>(scale / 2, random);
  const T unit = static_cast<T>(scale);
  std::vector<T> out;
  const auto add_length = [&](T v) { out.push_back(v / unit); };
  const auto add_point = [&](const Vec2<T>& v) { add_length(v.x), add_length(v.y); };
  const auto add_normal = [&](const Vec2<T>& v) { out.push_back(v.x), out.push_back(v.y); };
  const Distance<T> d = distance(a, at_a, b, at_b);
  add_length(d.distance), add_point(d.a), add_point(d.b), add_normal(d.normal);
  Manifolds<T> manifolds;
  out.push_back(contacts(a, at_a, b, at_b, unit / T(8), manifolds) ? T(1) : T(0));
  for (const Manifold<T>& m : manifolds) {
    add_normal(m.normal);
    for (const ContactPoint<T>& p : m.points)
      add_point(p.a), add_point(p.b), add_length(p.distance), out.push_back(static_cast<T>(p.feature));
  }
  const Vec2<T> from = point<T>(scale, random), along = point<T>(1, random), way = point<T>(scale, random);
  const Closest<T> c = closest(a, at_a, from);
  add_length(c.distance), add_point(c.point), add_normal(c.normal);
  if (const auto hit = raycast<T>(a, at_a, {from, along}))
    add_length(hit->t), add_point(hit->point), add_normal(hit->normal);
  for (const T turn : {T(0), T(1)})
    if (const auto hit = cast<T>(a, at_a, {}, b, {at_b.translation - way, at_b.rotation}, {way, turn}, T(2)))
      out.push_back(hit->t), add_point(hit->point), add_normal(hit->normal), add_length(hit->depth);
  return out;
}

TYPED_TEST(PlaneScale, OfTwoKeepsEveryBit) {
  using T = TypeParam;
  std::size_t numbers = 0;
  for (int kind_a = 0; kind_a < figure_kinds; ++kind_a)
    for (int kind_b = 0; kind_b < figure_kinds; ++kind_b)
      for (unsigned seed = 0; seed < 20; ++seed) {
        const std::vector<T> plain = answers<T>(kind_a, kind_b, 1, seed);
        numbers += plain.size();
        // A tenth of a millimetre where the plain ones are a metre, and a hundred kilometres.
        for (const double scale : {0x1p-13, 0x1p17})
          ASSERT_EQ(answers<T>(kind_a, kind_b, scale, seed), plain)
              << "kinds " << kind_a << " and " << kind_b << ", seed " << seed << ", scale " << scale;
      }
  EXPECT_GT(numbers, 30000u);
}

}  // namespace
}  // namespace graze::plane
