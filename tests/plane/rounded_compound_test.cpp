// A compound with a rounding is the compound of its children, each with that rounding beside its own.
#include <gtest/gtest.h>

#include <random>

#include "graze/plane/cast.hpp"
#include "graze/plane/mass.hpp"
#include "graze/plane/proximity.hpp"
#include "graze/plane/query.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneRoundedCompound : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneRoundedCompound, Scalars);

/// A multiple of 1/1024, of which sums are exact in both precisions.
template <class T>
T coarse(std::mt19937& random, int low, int high) {
  return static_cast<T>(low + static_cast<int>(random() % static_cast<unsigned>(high - low))) / T(1024);
}

template <class T>
Shape<T> child(std::mt19937& random, T rounding) {
  const auto size = [&] { return coarse<T>(random, 100, 900); };
  switch (random() % 9) {
  case 0: return {Circle<T>(size()), rounding};
  case 1: return {Box<T>({size(), size()}), rounding};
  case 2: return {Capsule<T>(size(), size(), size()), rounding};
  case 3: return {Segment<T>({-size(), 0}, {size(), size()}), rounding};
  case 4: return {ConvexPolygon<T>(std::vector<Vec2<T>>{{-size(), -size()}, {size(), 0}, {0, size()}}), rounding};
  case 5: return {Ellipse<T>({size(), size()}), rounding};
  case 6: return {Polygon<T>(std::vector<Vec2<T>>{{-1, -1}, {1, -1}, {1, 1}, {0, 0}, {-1, 1}}), rounding};
  case 7: return {Chain<T>(std::vector<Vec2<T>>{{-1, -size()}, {0, 0}, {1, -size()}}), rounding};
  default: return {HalfPlane<T>(), rounding};
  }
}

template <class T>
struct Both {
  Shape<T> rounded;  ///< the compound with the rounding
  Shape<T> grown;    ///< the compound of grown children
};

/// The same children twice, some within one or two more compounds that have roundings of their own.
template <class T>
Both<T> both(std::mt19937& random, int depth) {
  const T rounding = coarse<T>(random, 0, 400);
  std::vector<Placed<T>> plain, grown;
  const unsigned count = 1 + random() % 4;
  for (unsigned i = 0; i < count; ++i) {
    const Pose2<T> pose{{coarse<T>(random, -2000, 2000), coarse<T>(random, -2000, 2000)},
                        Rot2<T>::from_angle(coarse<T>(random, -3000, 3000))};
    if (depth > 0 && random() % 3 == 0) {
      const Both<T> inner = both<T>(random, depth - 1);
      std::vector<Placed<T>> leaves;
      for (const Placed<T>& leaf : inner.grown.template as<Compound<T>>()->children())
        leaves.push_back(
            {leaf.shape.visit([&](const auto& c) { return Shape<T>(c, leaf.shape.rounding() + rounding); }),
             leaf.pose});
      plain.push_back({inner.rounded, pose}), grown.push_back({Compound<T>(leaves), pose});
    } else {
      const std::mt19937 same = random;
      plain.push_back({child<T>(random, T(1) / T(64)), pose});
      random = same;
      grown.push_back({child<T>(random, T(1) / T(64) + rounding), pose});
    }
  }
  return {{Compound<T>(plain), rounding}, Compound<T>(grown)};
}

template <class T>
bool same(const Manifolds<T>& a, const Manifolds<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i].normal == b[i].normal) || a[i].piece_a != b[i].piece_a || a[i].points.size() != b[i].points.size())
      return false;
    for (std::size_t k = 0; k < a[i].points.size(); ++k) {
      const ContactPoint<T>&p = a[i].points[k], &q = b[i].points[k];
      if (!(p.a == q.a) || !(p.b == q.b) || p.distance != q.distance || p.feature != q.feature) return false;
    }
  }
  return true;
}

TYPED_TEST(PlaneRoundedCompound, AnswersLikeGrownChildren) {
  using T = TypeParam;
  std::mt19937 random(11);
  int overlaps = 0, hits = 0, casts = 0;
  for (int i = 0; i < 3000; ++i) {
    const Both<T> a = both<T>(random, 2);
    const Shape<T> b = child<T>(random, 0);
    const Pose2<T> pose_a{{T(3), T(-2)}, Rot2<T>::from_angle(T(0.3))},
        pose_b{{coarse<T>(random, -2000, 8000), coarse<T>(random, -6000, 2000)}, Rot2<T>::from_angle(T(i))};
    SCOPED_TRACE(i);
    const Aabb2<T> box = bounds(a.rounded, pose_a), expected_box = bounds(a.grown, pose_a);
    EXPECT_TRUE(box.lower == expected_box.lower && box.upper == expected_box.upper);
    for (const bool swapped : {false, true}) {
      const auto ask = [&](const Shape<T>& compound, const auto& query) {
        return swapped ? query(b, pose_b, compound, pose_a) : query(compound, pose_a, b, pose_b);
      };
      const auto distances = [](const auto&... all) { return distance<T>(all...); };
      const Distance<T> d = ask(a.rounded, distances), e = ask(a.grown, distances);
      EXPECT_TRUE(d.distance == e.distance && d.normal == e.normal && d.a == e.a && d.b == e.b);
      overlaps += d.distance <= 0;
      Manifolds<T> found, expected;
      const auto all = [](Manifolds<T>& out) {
        return [&out](const auto&... of) { return contacts<T>(of..., T(0.1), out); };
      };
      EXPECT_EQ(ask(a.rounded, all(found)), ask(a.grown, all(expected)));
      EXPECT_TRUE(same(found, expected));
      if (b.template as<HalfPlane<T>>()) continue;
      const Velocity<T> still{}, moves{{T(-2), T(1)}, T(0.5)};
      const auto first = [&](const Shape<T>& one, const Pose2<T>& at, const Shape<T>& other, const Pose2<T>& there) {
        return cast<T>(one, at, swapped ? moves : still, other, there, swapped ? still : moves, T(2));
      };
      if (i % 10 != 0) continue;
      const auto hit = ask(a.rounded, first), expected_hit = ask(a.grown, first);
      ASSERT_EQ(hit.has_value(), expected_hit.has_value());
      if (!hit) continue;
      EXPECT_EQ(hit->t, expected_hit->t);
      ++casts;
    }
    const Ray<T> ray{pose_b.translation, pose_a.translation - pose_b.translation};
    const auto hit = raycast<T>(a.rounded, pose_a, ray), expected_hit = raycast<T>(a.grown, pose_a, ray);
    ASSERT_EQ(hit.has_value(), expected_hit.has_value());
    hits += hit.has_value();
    EXPECT_TRUE(!hit || (hit->t == expected_hit->t && hit->normal == expected_hit->normal));
    const MassProperties<T> mass = mass_properties(a.rounded), expected_mass = mass_properties(a.grown);
    EXPECT_TRUE(mass.area == expected_mass.area && mass.inertia == expected_mass.inertia);
  }
  EXPECT_GT(overlaps, 1000);
  EXPECT_GT(hits, 1000);
  EXPECT_GT(casts, 50);
}

/// Compounds that are nested too deep are taken apart, with all the roundings on the way.
TYPED_TEST(PlaneRoundedCompound, KeepsRoundingsOfDeepNests) {
  using T = TypeParam;
  Shape<T> nest = Circle<T>(T(1));
  for (int i = 0; i < 100; ++i) nest = {Compound<T>({{nest, {{T(1) / T(16), T(0)}, {}}}}), T(1) / T(64)};
  const Shape<T> spot = Circle<T>(T(0));
  const T expected = T(20) - T(100) / T(16) - T(1) - T(100) / T(64);
  EXPECT_NEAR(double(distance<T>(nest, {}, spot, {{T(20), T(0)}, {}}).distance), double(expected), 1e-5);
  EXPECT_GE(bounds(nest, Pose2<T>{}).upper.x, T(20) - expected);
  EXPECT_NEAR(double(bounds(nest, Pose2<T>{}).upper.x), double(T(20) - expected), 1e-4);
}

TYPED_TEST(PlaneRoundedCompound, RefusesWhatIsNoRadius) {
  using T = TypeParam;
  const Compound<T> one({{Circle<T>(T(1)), {}}});
  for (const T radius : {T(-1), std::numeric_limits<T>::infinity(), std::numeric_limits<T>::quiet_NaN()})
    EXPECT_THROW(Shape<T>(one, radius), InvalidValue);
  EXPECT_EQ(Shape<T>(one, T(2)).rounding(), T(2));
}

}  // namespace
}  // namespace graze::plane
