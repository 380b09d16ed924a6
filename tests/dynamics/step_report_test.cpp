// The report of a step: depths and the approach that the solver left, against what they are made of.
#include <gtest/gtest.h>

#include <algorithm>

#include "dynamics/simulated.hpp"

namespace graze::testing {
namespace {

template <class T>
class StepReports : public ::testing::Test {};
using ScalarsOfStepReports = ::testing::Types<float, double>;
TYPED_TEST_SUITE(StepReports, ScalarsOfStepReports);

template <class T>
BodyId add_cube(Simulation<T>& s, T x, T bottom, T density = T(1000)) {
  Dynamics<T> dynamics;
  dynamics.density = density;
  return s.add({Box<T>({T(1), T(1), T(1)}), {{x, bottom + T(0.5), T(0)}, {}}}, dynamics);
}

/// Two cubes stand in a floor, by 1/64 and by 3/64, and a third one a little above it: the depths are those at the
/// beginning of the step, and what is apart has none.
TYPED_TEST(StepReports, DepthsAreThoseOfTheStepsBeginning) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_floor(s);
  add_cube(s, T(-4), T(-1) / T(64));
  add_cube(s, T(0), T(-3) / T(64));
  add_cube(s, T(4), T(1) / T(1024));
  EXPECT_EQ(s.report().deepest, T(0));
  EXPECT_EQ(s.report().mean_depth, T(0));
  s.step(T(dt));
  const T rounding = std::numeric_limits<T>::epsilon();
  EXPECT_NEAR(s.report().deepest, T(3) / T(64), rounding);
  EXPECT_NEAR(s.report().mean_depth, T(2) / T(64), rounding);
}

/// The fastest approach that is left is that of the bodies' velocities at the points that push: far from nothing in the
/// first steps of a heavy box on two light ones, and close to it when they have come to rest.
TYPED_TEST(StepReports, ResidualIsTheApproachThatIsLeft) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_floor(s);
  add_cube(s, T(0), T(0));
  add_cube(s, T(0), T(1));
  add_cube(s, T(0), T(2), T(100000));
  const auto speed_at = [&](std::uint32_t body, const Vec3<T>& point) {
    const Motion<T> m = s.motion(s.world().bodies().id(body));
    return m.linear + cross(m.angular, point - m.center);
  };
  const auto fastest_approach = [&] {
    T fastest(0);
    const auto& contacts = s.world().contacts();
    for (const ContactPair<T>& pair : contacts.pairs)
      for (const auto& m : contacts.manifolds_of(pair))
        for (const auto& p : contacts.points_of(m))
          if (dot(p.impulse, m.normal) > T(0))
            fastest = std::max(fastest, dot(speed_at(pair.a, p.a) - speed_at(pair.b, p.b), m.normal));
    return fastest;
  };
  T early(0);
  for (int i = 0; i < 4; ++i) {
    s.step(T(dt));
    const T approach = fastest_approach();
    EXPECT_NEAR(s.report().residual, approach, T(0.02) * approach + T(100) * std::numeric_limits<T>::epsilon()) << i;
    early = std::max(early, s.report().residual);
  }
  EXPECT_GT(early, T(1e-3));
  poses_after(s, 256);
  EXPECT_LT(s.report().residual, T(0.02) * early);
}

/// What nothing touches leaves nothing.
TYPED_TEST(StepReports, NothingIsLeftOfWhatFlies) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_cube(s, T(0), T(0));
  s.step(T(dt));
  EXPECT_EQ(s.report().residual, T(0));
  EXPECT_EQ(s.report().contacts, 0u);
}

}  // namespace
}  // namespace graze::testing
