// What the tests of casts throw at each other, in float and in double.
#pragma once

#include <gtest/gtest.h>

#include "graze/cast.hpp"

namespace graze {

template <class T>
class CastTest : public ::testing::Test {
 protected:
  using V = Vec3<T>;
  const Shape<T> ball{Sphere<T>(T(1))}, cube{Box<T>({T(2), T(2), T(2)})}, ground{HalfSpace<T>()};

  std::optional<CastHit<T>> thrown(const Shape<T>& a, const V& at_a, const Shape<T>& b, const V& at_b, const V& vb,
                                   T duration = T(1), Separating separating = Separating::hit) {
    return cast(a, {at_a, {}}, {}, b, {at_b, {}}, {vb, {}}, duration, {separating});
  }
};

/// For answers in closed form: four tolerances of a cast.
template <class T>
inline constexpr T near_enough = T(4) * cast_tolerance<T>;

}  // namespace graze
