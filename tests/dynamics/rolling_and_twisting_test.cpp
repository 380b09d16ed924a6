// Bodies that roll and twist: the depth of what is round while it turns, and friction that slides and twists at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/simulated.hpp"
#include "graze/plane/simulation.hpp"

namespace graze::testing {
namespace {

template <class T>
class Rolling : public ::testing::Test {};
using ScalarsOfRolling = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Rolling, ScalarsOfRolling);

/// What turns in a step by up to three radians about the axis of its side stays as deep as at rest, and rolls on as
/// fast as it did: the height of a ball's surface does not depend on how the ball is turned.
TYPED_TEST(Rolling, RoundBodiesDoNotSink) {
  using T = TypeParam;
  const T r = static_cast<T>(0.03);
  const Quat<T> lying = Quat<T>::from_axis_angle({T(1), T(0), T(0)}, T(1.5707963267948966));
  const std::pair<Shape<T>, Quat<T>> bodies[] = {
      {Sphere<T>(r), {}},
      {Capsule<T>(T(0.1), r), lying},
      {Cylinder<T>(T(0.1), r), lying},
      {Shape<T>(LineSegment<T>({T(0), T(-0.05), T(0)}, {T(0), T(0.05), T(0)}), r), lying}};
  for (const auto& [shape, turned] : bodies)
    for (const double speed : {0.5, 2.0, 5.0}) {
      Simulation<T> s(settings<T>());
      add_floor(s);
      Dynamics<T> dynamics;
      dynamics.mass = T(0.1);
      Body<T> body{shape, {{T(0), r, T(0)}, turned}, {T(speed), T(0), T(0)}, {T(0), T(0), T(-speed) / r}};
      const BodyId id = s.add(body, dynamics);
      T lowest = r;
      for (int i = 0; i < 128; ++i) {
        s.step(T(dt));
        lowest = std::min(lowest, s.motion(id).center.y);
      }
      EXPECT_GT(lowest, T(0.995) * r) << speed;
      EXPECT_NEAR(s.motion(id).linear.x, speed, 0.01 * speed);
    }
}

TYPED_TEST(Rolling, DiscsOfThePlaneDoNotSink) {
  using T = TypeParam;
  const T r = static_cast<T>(0.03);
  for (const plane::Shape<T>& shape :
       {plane::Shape<T>(plane::Circle<T>(r)), plane::Shape<T>(plane::Ellipse<T>({r, r}))}) {
    plane::Simulation<T> s;
    plane::Body<T> ground{plane::HalfPlane<T>()};
    ground.fixed = true;
    s.add(ground);
    const BodyId id = s.add({shape, {{T(0), r}, {}}, {T(5), T(0)}, T(-5) / r});
    for (int i = 0; i < 128; ++i) s.step(T(dt));
    EXPECT_GT(s.motion(id).center.y, T(0.99) * r);
    EXPECT_NEAR(s.motion(id).linear.x, 5, 0.05);
  }
}

/// A disc that slides at 10 m/s and turns slowly goes on turning: at each place friction acts against the velocity
/// there, nearly all of which is the sliding. Of even pressure 2.4 % of the spin are gone in a tenth of a second; of
/// pressure at the rim, where the points of contact are, some more.
TYPED_TEST(Rolling, WhatSlidesFastHardlyResistsATwist) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_floor(s);
  const BodyId disc =
      s.add({Cylinder<T>(T(0.02), T(0.5)), {{T(0), T(0.01), T(0)}, {}}, {T(10), T(0), T(0)}, {T(0), T(2), T(0)}});
  for (int i = 0; i < 6; ++i) s.step(T(dt));
  EXPECT_GT(s.motion(disc).angular.y, T(1.75));
  EXPECT_LT(s.motion(disc).angular.y, T(1.97));
}

/// And what spins fast is no longer held on a slope that it stood on at rest.
TYPED_TEST(Rolling, WhatSpinsFastSlidesDown) {
  using T = TypeParam;
  const auto way = [](T spin) {
    SimulationSettings<T> slope = settings<T>();
    slope.gravity = {T(3), T(-10), T(0)};  // friction of 0.6 holds what stands
    Simulation<T> s(slope);
    add_floor(s);
    const BodyId disc = s.add({Cylinder<T>(T(0.02), T(0.5)), {{T(0), T(0.01), T(0)}, {}}, {}, {T(0), spin, T(0)}});
    for (int i = 0; i < 32; ++i) s.step(T(dt));
    return s.motion(disc).center.x;
  };
  EXPECT_LT(way(T(0)), T(0.002));
  EXPECT_GT(way(T(60)), T(0.1));
}

/// Two blocks side by side, held together, one on ice and one on felt, slide at 3 m/s: friction on the one alone turns
/// both about the middle, as fast as its moment says.
TYPED_TEST(Rolling, ASledWithOneSkidOnFeltTurns) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_floor(s);
  Material<T> ice, felt;
  ice.static_friction = ice.dynamic_friction = T(0);
  felt.static_friction = felt.dynamic_friction = T(0.5);
  ice.friction_combine = felt.friction_combine = Combine::minimum;
  const auto skid = [&](T z, const Material<T>& material) {
    return s.add({Box<T>({T(1), T(0.2), T(0.4)}), {{T(0), T(0.1), z}, {}}, {T(3), T(0), T(0)}}, {}, material);
  };
  const BodyId on_ice = skid(T(0.5), ice), on_felt = skid(T(-0.5), felt);
  s.add(fixed_joint<T>(on_ice, {{T(0), T(0), T(-0.5)}, {}}, on_felt, {{T(0), T(0), T(0.5)}, {}}));
  for (int i = 0; i < 13; ++i) s.step(T(dt));
  const double mass = 80, inertia = 2 * (mass / 12 * 1.16 + mass * 0.25), torque = 0.5 * mass * 10 * 0.5;
  const double yaw = torque * 13 * dt / inertia;
  EXPECT_NEAR(s.motion(on_felt).angular.y, yaw,
              0.12 * yaw);  // the load shifts, and the felt resists the twist a little
}

/// What touches or is joined in empty space, and nothing immovable holds, keeps its momentum however slow it is.
TYPED_TEST(Rolling, WhatDriftsTogetherGoesOn) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(0), true));
  const Box<T> box({T(1), T(1), T(1)});
  const BodyId a = s.add({box, {}, {T(0.005), T(0), T(0)}}),
               b = s.add({box, {{T(1), T(0), T(0)}, {}}, {T(0.005), T(0), T(0)}});
  s.add(fixed_joint<T>(a, {{T(0.5), T(0), T(0)}, {}}, b, {{T(-0.5), T(0), T(0)}, {}}));
  for (int i = 0; i < 6400; ++i) s.step(T(dt));
  EXPECT_FALSE(s.asleep(a));
  EXPECT_NEAR(s.motion(a).center.x, 0.5, 1e-3);
}

}  // namespace
}  // namespace graze::testing
