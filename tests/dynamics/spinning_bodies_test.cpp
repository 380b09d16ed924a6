// Spinning bodies in a whole simulation: a heavy top on its pivot, and a book that flips.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/simulated.hpp"

namespace graze::testing {
namespace {

template <class T>
class SpinningBodies : public ::testing::Test {};
using ScalarsOfSpinningBodies = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SpinningBodies, ScalarsOfSpinningBodies);

/// A disc of 0.5 m on an axle of 1 m that is level and turns about a pivot at its other end. A level axle goes round
/// steadily at exactly m g l / (I w), with w the spin and I the inertia about the axle, and neither rises nor falls.
TYPED_TEST(SpinningBodies, AHeavyTopPrecesses) {
  using T = TypeParam;
  constexpr double gravity = 10, radius = 0.5, arm = 1, spin = 40;
  const double inertia_of_unit_mass = radius * radius / 2, rate = gravity * arm / (inertia_of_unit_mass * spin);
  Simulation<T> s(settings<T>(T(gravity)));
  Body<T> post{Sphere<T>(T(0.1))};
  post.fixed = true;
  const BodyId pivot = s.add(post);
  const auto along_x = Quat<T>::from_axis_angle({T(0), T(0), T(1)}, -std::numbers::pi_v<T> / T(2));
  Body<T> disc{Cylinder<T>(T(0.1), T(radius)), {{T(arm), T(0), T(0)}, along_x}};
  disc.angular = {T(spin), T(rate), T(0)};
  disc.linear = {T(0), T(0), T(-rate * arm)};
  const BodyId top = s.add(disc);
  s.add(ball_joint<T>(pivot, {}, top, {{T(0), T(-arm), T(0)}, {}}));
  for (int i = 1; i <= 256; ++i) {
    s.step(T(dt));
    const double angle = rate * dt * i;
    const Vec3d at = converted<double>(s.poses()[top.index].translation);
    ASSERT_LT(length(at - Vec3d{arm * std::cos(angle), 0, -arm * std::sin(angle)}), 0.002) << i;
  }
}

/// A box of edges as of a book, whose moments are as 0.417 : 0.337 : 0.087, spun about its middle axis: in 20 s it
/// flips nine times, as Euler's equations have it, and keeps its angular momentum bit for bit. It goes by where it
/// could stay upright with a millionth of its energy to spare, of which rounding in float takes a part each time:
/// its first five flips are right.
TYPED_TEST(SpinningBodies, ABookFlipsNineTimes) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(0)));
  Body<T> book{Box<T>({std::sqrt(T(0.007)), std::sqrt(T(0.167)), std::sqrt(T(0.667))})};
  book.angular = {T(0.01), T(10), T(0)};
  const BodyId id = s.add(book);
  const Vec3<T> momentum = s.angular_momentum(id);
  int flips = 0;
  bool upright = true;
  const int right = sizeof(T) == sizeof(float) ? 5 : 9, seconds = sizeof(T) == sizeof(float) ? 10 : 20;
  for (int i = 0; i < 60 * seconds; ++i) {
    s.step(T(1) / T(60));
    const bool now = rotate(conjugate(s.poses()[id.index].rotation), s.motion(id).angular).y > T(0);
    flips += now != upright;
    upright = now;
  }
  EXPECT_EQ(flips, right);
  EXPECT_EQ(s.angular_momentum(id), momentum);
}

}  // namespace
}  // namespace graze::testing
