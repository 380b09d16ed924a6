#include <gtest/gtest.h>

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

}  // namespace
}  // namespace graze::plane
