// Steps of different lengths: what stands stays standing, whatever a frame leaves over.
#include <gtest/gtest.h>

#include "dynamics/simulated.hpp"

namespace graze::testing {
namespace {

template <class T>
class UnevenSteps : public ::testing::Test {};
using ScalarsOfUnevenSteps = ::testing::Types<float, double>;
TYPED_TEST_SUITE(UnevenSteps, ScalarsOfUnevenSteps);

template <class T>
struct Tower {
  Simulation<T> s{settings<T>()};
  std::vector<BodyId> boxes;

  explicit Tower(int count) {
    add_floor(s);
    for (int i = 0; i < count; ++i)
      boxes.push_back(s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(i) + T(0.5), T(0)}, {}}}));
    for (int i = 0; i < 128; ++i) s.step(T(dt));
  }
  T fastest() const {
    T most(0);
    for (const BodyId box : boxes) most = std::max(most, length(s.motion(box).linear));
    return most;
  }
};

/// A step a sixteenth to a ten-thousandth as long as those before and after it.
TYPED_TEST(UnevenSteps, AShortOneThrowsNothingUp) {
  using T = TypeParam;
  for (const T part : {T(0.06), T(0.006), T(1e-4)}) {
    Tower<T> tower(5);
    tower.s.step(T(dt) * part);
    EXPECT_LT(tower.fastest(), T(0.02)) << part;
    for (int i = 0; i < 64; ++i) {
      tower.s.step(T(dt));
      ASSERT_LT(tower.fastest(), T(0.1)) << part << ", " << i;
    }
    EXPECT_NEAR(tower.s.poses()[tower.boxes.back().index].translation.y, T(4.5), T(0.01)) << part;
  }
}

TYPED_TEST(UnevenSteps, InTurnsTowersStand) {
  using T = TypeParam;
  Tower<T> tower(10);
  for (int i = 0; i < 600; ++i) tower.s.step(i % 2 == 0 ? T(dt) : T(dt) / T(16));
  EXPECT_LT(tower.fastest(), T(0.1));
  EXPECT_NEAR(tower.s.poses()[tower.boxes.back().index].translation.y, T(9.5), T(0.02));
}

/// A blow in a short step does not come again in the long one after it, as many times as strong.
TYPED_TEST(UnevenSteps, ABlowIsStruckOnce) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_floor(s);
  const BodyId box = s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(0.5), T(0)}, {}}, {T(0), T(-10), T(0)}});
  s.step(T(dt) / T(1024));
  for (int i = 0; i < 32; ++i) {
    s.step(T(dt));
    ASSERT_LT(std::abs(s.motion(box).linear.y), T(3)) << i;
  }
}

}  // namespace
}  // namespace graze::testing
