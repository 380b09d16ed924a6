#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "graze/plane/query.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneContactMargin : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneContactMargin, Scalars);

TYPED_TEST(PlaneContactMargin, IsAHundredthOfTheSmallerShapeEitherWayRound) {
  using T = TypeParam;
  // Powers of two scale every answer without rounding.
  for (const T scale : {T(1) / T(8192), T(1), T(131072)}) {
    const Shape<T> circle(Circle<T>(T(2) * scale)), box(Box<T>({T(6) * scale, T(8) * scale}));
    EXPECT_EQ(contact_margin(circle, box), T(2) / T(100) * scale);
    EXPECT_EQ(contact_margin(box, circle), T(2) / T(100) * scale);
    EXPECT_EQ(contact_margin(box, box), T(5) / T(100) * scale);
    const Shape<T> rounded(Box<T>({T(6) * scale, T(8) * scale}), scale);
    EXPECT_EQ(contact_margin(rounded, rounded), T(6) / T(100) * scale);
  }
}

TYPED_TEST(PlaneContactMargin, OfAHalfPlaneTheOtherShapeDecides) {
  using T = TypeParam;
  const Shape<T> circle(Circle<T>(T(2))), ground(HalfPlane<T>{}), rounded(HalfPlane<T>{}, T(3));
  EXPECT_EQ(contact_margin(circle, ground), T(2) / T(100));
  EXPECT_EQ(contact_margin(rounded, circle), T(2) / T(100));
  EXPECT_EQ(contact_margin(ground, rounded), T(0));
}

TYPED_TEST(PlaneContactMargin, OfACompoundDoesNotGrowWithItsDistanceFromItsOrigin) {
  using T = TypeParam;
  const Shape<T> large(Circle<T>(T(1000)));
  const auto boxes_at = [](T x) {
    const Shape<T> box(Box<T>({T(3), T(8)}));
    return Shape<T>(Compound<T>({{box, {{x, T(0)}, {}}}, {box, {{x + T(3), T(0)}, {}}}}));
  };
  for (const T x : {T(0), T(512)}) {
    EXPECT_NEAR(contact_margin(boxes_at(x), large), T(5) / T(100), T(1e-5));
    EXPECT_NEAR(contact_margin(large, boxes_at(x)), T(5) / T(100), T(1e-5));
  }
}

/// Three boxes and triangles in places of tenths.
template <class T>
Shape<T> crossed(std::mt19937& random) {
  const auto tenth = [&] { return T(static_cast<int>(random() % 21) - 10) / T(10); };
  std::vector<Placed<T>> children;
  while (children.size() < 3) {
    const Pose2<T> pose{{tenth(), tenth()}, Rot2<T>::from_angle(tenth())};
    if (random() % 2 == 0) {
      children.push_back({Shape<T>(Box<T>({T(0.6), T(0.4)})), pose});
      continue;
    }
    const Vec2<T> p{tenth(), tenth()}, q{tenth(), tenth()}, r{tenth(), tenth()};
    if (std::abs(cross(q - p, r - p)) > T(0.1))
      children.push_back({Shape<T>(ConvexPolygon<T>(std::vector<Vec2<T>>{p, q, r})), pose});
  }
  return Compound<T>(std::move(children));
}

// What is only near is told besides what touches, and never in its place.
TYPED_TEST(PlaneContactMargin, TakesNoPointAwayThatTouches) {
  using T = TypeParam;
  std::mt19937 random(5);
  int touching = 0;
  for (int i = 0; i < 8000; ++i) {
    const Shape<T> a = crossed<T>(random), b = crossed<T>(random);
    const Pose2<T> here{}, there{{T(static_cast<int>(random() % 21) - 10) / T(10), T(0.3)}, {}};
    if (!overlap(a, here, b, there)) continue;
    ++touching;
    for (const T margin : {T(0), T(0.05), T(0.3)}) {
      Manifolds<T> manifolds;
      EXPECT_TRUE(contacts(a, here, b, there, margin, manifolds));
      T deepest(1);
      for (const auto& m : manifolds)
        for (const auto& p : m.points) deepest = std::min(deepest, p.distance);
      EXPECT_LE(deepest, T(0)) << "pair " << i << ", margin " << margin;
    }
  }
  EXPECT_GT(touching, 5000);
}

}  // namespace
}  // namespace graze::plane
