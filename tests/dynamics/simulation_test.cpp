// Simulations against closed forms: falls, slopes, rebounds, rolling, stacks that stand, sleep.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "dynamics/simulated.hpp"

namespace graze::testing {
namespace {

template <class T>
class SimulationOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SimulationOf, Scalars);

TYPED_TEST(SimulationOf, FallsAsGalileoSays) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  const BodyId ball = s.add({Sphere<T>(T(0.5)), {{T(1), T(100), T(2)}, {}}, {T(3), T(0), T(0)}});
  for (int i = 0; i < 128; ++i) s.step(T(dt));
  const Vec3<T> at = s.poses()[ball.index].translation;
  const T rounding = T(200) * std::numeric_limits<T>::epsilon() * T(100);
  EXPECT_NEAR(at.x, T(7), rounding);
  EXPECT_NEAR(at.y, T(80), rounding);
  EXPECT_EQ(at.z, T(2));
}

TYPED_TEST(SimulationOf, KeepsAngularMomentumBitForBit) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  const BodyId book = s.add({Box<T>({T(1), T(2), T(0.2)}), {{T(0), T(1000), T(0)}, {}}, {}, {T(0.01), T(0.02), T(10)}});
  const Vec3<T> before = s.angular_momentum(book);
  const T energy = s.report().kinetic_energy;
  Vec3<T> linear = s.motion(book).linear;
  for (int i = 0; i < 200; ++i) s.step(T(dt));
  EXPECT_EQ(s.angular_momentum(book), before);
  linear = s.motion(book).linear;
  const T falling = s.mass(book) * length_squared(linear) / T(2);
  EXPECT_NEAR((s.report().kinetic_energy - falling) / energy, T(1), T(1e-3));
}

/// A box slides down a slope of 30 degrees with g (sin - friction cos), and stays where friction suffices.
TYPED_TEST(SimulationOf, SlidesDownASlope) {
  using T = TypeParam;
  const double angle = 0.5235987755982988;
  const Quat<T> tilt = Quat<T>::from_axis_angle({T(0), T(0), T(1)}, static_cast<T>(angle));
  for (const double part : {0.5, 0.98, 1.02}) {
    const double friction = part * std::tan(angle);
    const Material<T> m{static_cast<T>(friction), static_cast<T>(friction)};
    Simulation<T> s(settings<T>());
    add_floor<T>(s, m, tilt);
    const BodyId box =
        s.add({Box<T>({T(1), T(0.25), T(1)}), {rotate(tilt, Vec3<T>{T(0), T(0.125), T(0)}), tilt}}, {}, m);
    const Vec3<T> start = s.poses()[box.index].translation;
    for (int i = 0; i < 128; ++i) s.step(T(dt));
    const double speed = static_cast<double>(length(s.motion(box).linear));
    const double way = static_cast<double>(length(s.poses()[box.index].translation - start));
    const double exact = 10 * (std::sin(angle) - friction * std::cos(angle));
    if (part < 1) {
      EXPECT_NEAR(speed / (exact * 2), 1, 0.005) << part;
      EXPECT_NEAR(way / (exact * 2), 1, part < 0.9 ? 0.005 : 0.05) << part;
    } else {
      EXPECT_LT(way, 1e-3) << part;
      EXPECT_LT(speed, 1e-4) << part;
    }
  }
}

/// What slides on a level floor stops after v² / (2 μ g).
TYPED_TEST(SimulationOf, StopsWhereFrictionEndsIt) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_floor(s);
  const BodyId plate = s.add({Box<T>({T(2), T(0.1), T(2)}), {{T(0), T(0.05), T(0)}, {}}, {T(6), T(0), T(0)}});
  for (int i = 0; i < 128; ++i) s.step(T(dt));
  EXPECT_NEAR(s.poses()[plate.index].translation.x, T(3), T(0.01));
  EXPECT_LT(length(s.motion(plate).linear), T(1e-4));
}

/// A ball that slides begins to roll: five sevenths of its speed are left (Coriolis 1835).
TYPED_TEST(SimulationOf, SlidingBallsRoll) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_floor<T>(s);
  const BodyId ball = s.add({Sphere<T>(T(0.5)), {{T(0), T(0.5), T(0)}, {}}, {T(7), T(0), T(0)}});
  for (int i = 0; i < 128; ++i) s.step(T(dt));
  EXPECT_NEAR(s.motion(ball).linear.x, T(5), T(0.025));
  EXPECT_NEAR(s.motion(ball).angular.z, T(-10), T(0.05));
}

/// Rolling friction of a length c turns a ball back by c m g: with the inertia 2/5 m r² it slows down by 5 c g / 7 r.
TYPED_TEST(SimulationOf, RollingFrictionSlowsABallDown) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  Material<T> m;
  m.rolling_friction = T(0.07);
  add_floor<T>(s, m);
  const BodyId ball =
      s.add({Sphere<T>(T(0.5)), {{T(0), T(0.5), T(0)}, {}}, {T(4), T(0), T(0)}, {T(0), T(0), T(-8)}}, {}, m);
  for (int i = 0; i < 128; ++i) s.step(T(dt));
  EXPECT_NEAR(s.motion(ball).linear.x, T(2), T(0.02));
  EXPECT_NEAR(s.motion(ball).angular.z, T(-4), T(0.04));
  for (int i = 0; i < 4 * 64; ++i) s.step(T(dt));
  EXPECT_LT(length(s.motion(ball).linear), T(1e-4));
}

/// What rolls stops on a slope that rolling friction can hold, and stays: its torque is there when a step begins. Had
/// it to be found anew in each, the wheel would creep by half a millimetre a second on the slope of 1 : 20.
TYPED_TEST(SimulationOf, RollingFrictionHoldsWheelsOnASlope) {
  using T = TypeParam;
  for (const T slope : {T(0.05), T(0.1)})
    for (const Shape<T>& shape : {Shape<T>(Sphere<T>(T(0.5))), Shape<T>(Cylinder<T>(T(1), T(0.5))),
                                  Shape<T>(Cylinder<T>(T(0.2), T(0.5))), Shape<T>(Capsule<T>(T(1), T(0.5)))}) {
      SimulationSettings<T> four = settings<T>();
      four.most_sub_steps = four.sub_steps;
      Simulation<T> s(four);
      Material<T> m;
      m.rolling_friction = T(0.5) * std::tan(slope) * T(1.5);
      const Quat<T> tilt = Quat<T>::from_axis_angle({T(0), T(0), T(1)}, -slope);
      add_floor<T>(s, m, tilt);
      const Quat<T> lying = Quat<T>::from_axis_angle({T(1), T(0), T(0)}, std::numbers::pi_v<T> / T(2));
      const BodyId wheel = s.add({shape, {rotate(tilt, Vec3<T>{T(0), T(0.5), T(0)}), tilt * lying}}, {}, m);
      for (int i = 0; i < 64; ++i) s.step(T(dt));
      const Vec3<T> stopped = s.poses()[wheel.index].translation;
      EXPECT_LT(length(stopped), T(0.502)) << shape.name();
      for (int i = 0; i < 9 * 64; ++i) s.step(T(dt));
      EXPECT_LT(length(s.poses()[wheel.index].translation - stopped), T(1e-6)) << shape.name() << " " << slope;
    }
}

/// One point alone has no twist: its impulse bears the weight and nothing else, in every step. The centre of pressure
/// is that point but for rounding, which an impulse across the slope would be made of.
TYPED_TEST(SimulationOf, OnePointBearsTheWeightAlone) {
  using T = TypeParam;
  SimulationSettings<T> four = settings<T>();
  four.most_sub_steps = four.sub_steps;
  Simulation<T> s(four);
  Material<T> m;
  m.rolling_friction = T(0.1);
  const Quat<T> tilt = Quat<T>::from_axis_angle({T(0), T(0), T(1)}, T(-0.1));
  add_floor<T>(s, m, tilt);
  constexpr int balls = 40;
  for (int i = 0; i < balls; ++i) {
    const T radius = T(0.5) + T(i) / T(128);
    s.add({Sphere<T>(radius), {rotate(tilt, Vec3<T>{T(0), radius, T(3 * i)}), tilt}}, {}, m);
  }
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  for (int i = 0; i < 4 * 64; ++i) {
    s.step(T(dt));
    const auto& contacts = s.world().contacts();
    ASSERT_EQ(contacts.points.size(), std::size_t{balls});
    for (const ContactPair<T>& pair : contacts.pairs) {
      const Vec3<T> weight{T(0), s.mass(s.world().bodies().id(pair.b)) * T(10) * T(dt), T(0)};
      const Vec3<T>& impulse = contacts.points_of(contacts.manifolds_of(pair)[0])[0].impulse;
      ASSERT_LT(length(impulse - weight), T(1e-4) * length(weight)) << pair.b << " " << i;
    }
  }
}

/// A blow keeps the angular momentum of two free bodies about a fixed point, and their momentum, to rounding: both have
/// flown to the time at which they meet. Balls meet at one point, whatever their friction.
TYPED_TEST(SimulationOf, BlowsOfBallsKeepAngularMomentum) {
  using T = TypeParam;
  constexpr T rounding = T(64) * std::numeric_limits<T>::epsilon();
  int blows = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<T>(random() % 1024) / T(512) - T(1); };
    const auto vector = [&] {
      const T x = number(), y = number();
      return Vec3<T>{x, y, number()};
    };
    Simulation<T> s(settings<T>(T(0)));
    Material<T> m;
    m.restitution = seed % 2 == 0 ? T(1) : T(0.5);
    const Vec3<T> off{number() * T(0.3), number() * T(0.3), T(0)};
    for (const T side : {T(-1), T(1)}) {
      const Vec3<T> at = Vec3<T>{T(0), T(0), side * T(2)} + off * side;
      s.add({Sphere<T>(T(0.5)), {at, {}}, vector() - Vec3<T>{T(0), T(0), T(5) * side}, vector()}, {}, m);
    }
    const auto before = s.report();
    for (int i = 0; i < 64; ++i) s.step(T(dt));
    const auto after = s.report();
    const T scale = s.mass(s.world().bodies().id(0)) * T(6);
    EXPECT_LT(length(after.momentum - before.momentum), rounding * scale) << seed;
    EXPECT_LT(length(after.angular_momentum - before.angular_momentum), T(8) * rounding * scale) << seed;
    if (length(s.motion(s.world().bodies().id(0)).linear) > T(0) && after.kinetic_energy < before.kinetic_energy)
      ++blows;
  }
  EXPECT_GT(blows, 30);
}

/// A coin that turns on its base is slowed by friction all over it. Contacts stand on its rim, which bears what the
/// whole face would: the torque is μ m g r, and with the inertia m r² / 2 the rate falls by 2 μ g / r. Pressure spread
/// evenly would slow it by two thirds of that.
TYPED_TEST(SimulationOf, TwistSlowsWhatTurnsOnItsBase) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  Material<T> m{T(0.3), T(0.3)};
  add_floor<T>(s, m);
  const BodyId coin = s.add({Cylinder<T>(T(0.2), T(1)), {{T(0), T(0.1), T(0)}, {}}, {}, {T(0), T(12), T(0)}}, {}, m);
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  const T lost = T(12) - s.motion(coin).angular.y;
  EXPECT_NEAR(lost, T(6), T(0.03));
  EXPECT_LT(length(s.motion(coin).linear), T(1e-3));
  for (int i = 0; i < 3 * 64; ++i) s.step(T(dt));
  EXPECT_LT(std::abs(s.motion(coin).angular.y), T(1e-3));
}

/// Static friction holds up to its cone; what slides is held back by the dynamic one: on a slope of 1 : 2 by
/// (1/2 - 1/4) g / sqrt(5/4).
TYPED_TEST(SimulationOf, StaticFrictionHoldsWhatDynamicLetsGo) {
  using T = TypeParam;
  const T root = std::sqrt(T(5)) / T(2);
  const Quat<T> tilt = normalized(Quat<T>{T(0), T(0), T(-1), std::sqrt(T(5)) + T(2)});  // by atan 1/2 about -z
  const Vec3<T> down = rotate(tilt, Vec3<T>{T(1), T(0), T(0)}), up = rotate(tilt, Vec3<T>{T(0), T(1), T(0)});
  Material<T> m;
  m.static_friction = T(0.6);
  m.dynamic_friction = T(0.25);
  for (const T speed : {T(0), T(1)}) {
    Simulation<T> s(settings<T>());
    add_floor<T>(s, m, tilt);
    const BodyId box = s.add({Box<T>({T(2), T(0.5), T(2)}), {up * T(0.25), tilt}, down * speed}, {}, m);
    for (int i = 0; i < 128; ++i) s.step(T(dt));
    const T expected = speed == T(0) ? T(0) : speed + T(0.25) / root * T(10) * T(2);
    EXPECT_NEAR(dot(s.motion(box).linear, down), expected, T(0.02) * (T(1) + expected)) << speed;
  }
}

/// A box that rests moves once more than static friction pushes it, and from then on dynamic friction holds it back;
/// pushed by less, it stays.
TYPED_TEST(SimulationOf, WhatBeginsToSlideSlides) {
  using T = TypeParam;
  Material<T> m;
  m.static_friction = T(0.5);
  m.dynamic_friction = T(0.3);
  for (const T height : {T(0.2), T(1)})
    for (const T part : {T(0.99), T(1.02), T(1.2)}) {
      Simulation<T> s(settings<T>());
      add_floor<T>(s, m);
      const BodyId box = s.add({Box<T>({T(1), height, T(1)}), {{T(0), height / T(2), T(0)}, {}}}, {}, m);
      for (int i = 0; i < 64; ++i) s.step(T(dt));
      for (int i = 0; i < 128; ++i) {
        s.apply_force(box, {part * T(0.5) * s.mass(box) * T(10), T(0), T(0)});
        s.step(T(dt));
      }
      const T exact = part < T(1) ? T(0) : (part * T(0.5) - T(0.3)) * T(10) * T(2);
      EXPECT_NEAR(s.motion(box).linear.x, exact, exact * T(0.1) + T(0.01)) << height << ", " << part;
    }
}

/// A belt carries what lies on it for as long as it runs, however slowly.
TYPED_TEST(SimulationOf, WhatABeltCarriesStaysAwake) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(10), true));
  Material<T> belt;
  belt.surface_velocity = {T(0.005), T(0), T(0)};
  add_floor<T>(s, belt);
  const BodyId crate = s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(0.5), T(0)}, {}}});
  for (int i = 0; i < 10 * 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.poses()[crate.index].translation.x, T(0.05), T(0.001));
}

/// A box that is put on a slope of 3 : 4 slips until its weight rests on the contact, and then stays by static
/// friction.
TYPED_TEST(SimulationOf, WhatIsPutDownGentlyStays) {
  using T = TypeParam;
  const Quat<T> tilt = normalized(Quat<T>{T(0), T(0), T(-1), T(3)});
  for (const double friction : {0.8, 0.9, 1.2})
    for (const double gap : {-1e-4, -1e-7, 0.0, 1e-8, 1e-6, 1e-5, 1e-4}) {
      const Material<T> m{static_cast<T>(friction), T(0.25)};
      Simulation<T> s(settings<T>());
      add_floor<T>(s, m, tilt);
      const Vec3<T> center = rotate(tilt, Vec3<T>{T(0), static_cast<T>(0.25 + gap), T(0)});
      const BodyId box = s.add({Box<T>({T(2), T(0.5), T(2)}), {center, tilt}}, {}, m);
      for (int i = 0; i < 128; ++i) s.step(T(dt));
      EXPECT_LT(length(s.motion(box).linear), T(1e-4)) << friction << ", " << gap;
    }
}

/// A ball that falls from h rebounds to e² h, and with e = 1 keeps its energy.
TYPED_TEST(SimulationOf, Rebounds) {
  using T = TypeParam;
  for (const double e : {0.5, 0.8, 1.0}) {
    Material<T> m;
    m.restitution = static_cast<T>(e);
    Simulation<T> s(settings<T>());
    add_floor<T>(s, m);
    const BodyId ball = s.add({Sphere<T>(T(0.5)), {{T(0), T(5.5), T(0)}, {}}}, {}, m);
    T highest(0);
    bool risen = false;
    for (int i = 0; i < 4 * 64; ++i) {
      s.step(T(dt));
      const T v = s.motion(ball).linear.y;
      if (risen && v < T(0)) break;
      risen = risen || v > T(0);
      if (risen) highest = greatest(highest, s.poses()[ball.index].translation.y - T(0.5));
    }
    EXPECT_NEAR(static_cast<double>(highest) / (e * e * 5), 1, 0.005) << e;
  }
}

/// The blow passes through touching balls: the last leaves with the speed of the first.
TYPED_TEST(SimulationOf, NewtonsCradle) {
  using T = TypeParam;
  SimulationSettings<T> level = settings<T>(T(0));
  Simulation<T> s(level);
  Material<T> m;
  m.restitution = T(1);
  std::vector<BodyId> balls;
  for (int i = 0; i < 5; ++i) balls.push_back(s.add({Sphere<T>(T(0.5)), {{T(i), T(0), T(0)}, {}}}, {}, m));
  const BodyId first = s.add({Sphere<T>(T(0.5)), {{T(-2), T(0), T(0)}, {}}, {T(5), T(0), T(0)}}, {}, m);
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.motion(balls[4]).linear.x, T(5), T(0.01));
  for (const BodyId ball : {first, balls[0], balls[1], balls[2], balls[3]})
    EXPECT_NEAR(length(s.motion(ball).linear), T(0), T(0.01));
}

template <class T>
std::vector<BodyId> add_tower(Simulation<T>& s, int count, T size = T(1)) {
  add_floor(s);
  std::vector<BodyId> boxes;
  for (int i = 0; i < count; ++i)
    boxes.push_back(s.add({Box<T>({size, size, size}), {{T(0), size * (T(i) + T(0.5)), T(0)}, {}}}));
  return boxes;
}

TYPED_TEST(SimulationOf, TenBoxesStandAwake) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  const auto boxes = add_tower(s, 10);
  for (int i = 0; i < 5 * 64; ++i) s.step(T(dt));
  const Vec3<T> top = s.poses()[boxes.back().index].translation;
  EXPECT_NEAR(top.y, T(9.5), T(0.02));
  EXPECT_NEAR(std::hypot(top.x, top.z), T(0), T(0.02));
  EXPECT_LT(s.report().deepest, T(0.002));
  EXPECT_EQ(s.report().awake, 10u);
  EXPECT_EQ(s.report().islands, 1u);
}

/// Sixty boxes, each up to 2 cm beside its place: with contacts as soft as those of ten are they lean and fall, as a
/// column buckles. They take more sub-steps than ten, and keep them.
TYPED_TEST(SimulationOf, SixtyBoxesStandOutOfLine) {
  using T = TypeParam;
  constexpr int count = 60;
  Simulation<T> s(settings<T>());
  add_floor(s);
  std::vector<BodyId> boxes;
  for (int i = 0; i < count; ++i) {
    // Multiples of the golden ratio are spread evenly.
    const double x = std::fmod(i * 0.618033988749895, 1.0), z = std::fmod(i * i * 0.618033988749895, 1.0);
    boxes.push_back(s.add({Box<T>({T(1), T(1), T(1)}), {{T(0.04 * x - 0.02), T(i) + T(0.5), T(0.04 * z - 0.02)}, {}}}));
  }
  const auto placed = [&] { return s.poses()[boxes.back().index].translation; };
  const Vec3<T> put = placed();
  for (int i = 0; i < 15 * 64; ++i) s.step(T(dt));
  const Vec3<T> top = placed();
  EXPECT_NEAR(top.y, put.y, T(0.02));
  EXPECT_LT(std::hypot(top.x - put.x, top.z - put.z), T(0.03));
  EXPECT_GT(s.report().most_sub_steps, 16);
}

/// What the number of sub-steps changes must not change the number again: it settles, and the stack comes to rest.
TYPED_TEST(SimulationOf, SubStepsSettleUnderAHeavyBox) {
  using T = TypeParam;
  for (const T heavy : {T(3), T(5), T(12), T(16)}) {
    Simulation<T> s(settings<T>());
    add_floor(s);
    for (int i = 0; i <= 10; ++i) {
      Dynamics<T> dynamics;
      dynamics.mass = i == 10 ? heavy : T(1);
      s.add({Box<T>({1, 1, 1}), {{T(0), T(i) + T(0.5), T(0)}, {}}}, dynamics);
    }
    for (int i = 0; i < 5 * 64; ++i) s.step(T(dt));
    const int settled = s.report().most_sub_steps;
    T energy = 0;
    for (int i = 0; i < 5 * 64; ++i) {
      s.step(T(dt));
      ASSERT_EQ(s.report().most_sub_steps, settled) << heavy << ", " << i;
      energy = std::max(energy, s.report().kinetic_energy);
    }
    // A fall of them all by a thousandth of a box would give 0.1 J and more.
    EXPECT_LT(energy, T(1e-3)) << heavy;
  }
}

TYPED_TEST(SimulationOf, SleepsAndWakes) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(10), true));
  const auto boxes = add_tower(s, 3);
  for (int i = 0; i < 3 * 64; ++i) s.step(T(dt));
  for (const BodyId box : boxes) EXPECT_TRUE(s.asleep(box));
  EXPECT_EQ(s.report().awake, 0u);
  const T height = s.poses()[boxes[2].index].translation.y;
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  EXPECT_EQ(s.poses()[boxes[2].index].translation.y, height);
  s.remove(boxes[0]);  // what stood on it falls
  EXPECT_FALSE(s.asleep(boxes[1]));
  for (int i = 0; i < 4 * 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.poses()[boxes[2].index].translation.y, T(1.5), T(0.01));
  s.apply_impulse(boxes[2], {T(3000), T(0), T(0)}, s.poses()[boxes[2].index].translation);
  EXPECT_FALSE(s.asleep(boxes[2]));
  for (int i = 0; i < 32; ++i) s.step(T(dt));
  EXPECT_GT(s.poses()[boxes[2].index].translation.x, T(0.1));
}

/// What is put into a sleeper wakes it, also where nothing pushes it.
TYPED_TEST(SimulationOf, WhatIsPutIntoASleeperWakesIt) {
  using T = TypeParam;
  for (const bool kinematic : {false, true})
    for (const bool moved : {false, true}) {
      Simulation<T> s(settings<T>(T(10), true));
      add_floor(s);
      const BodyId box = s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(0.5), T(0)}, {}}});
      Dynamics<T> dynamics;
      dynamics.kinematic = kinematic;
      Body<T> other{Box<T>({T(1), T(1), T(1)}), {{T(0.8), T(0.5), T(0)}, {}}};
      other.fixed = !kinematic;
      if (moved) {
        other.pose.translation.x = T(5);
        const BodyId id = s.add(other, dynamics);
        for (int i = 0; i < 200; ++i) s.step(T(dt));
        ASSERT_TRUE(s.asleep(box));
        s.set_pose(id, {{T(0.8), T(0.5), T(0)}, {}});
      } else {
        for (int i = 0; i < 200; ++i) s.step(T(dt));
        ASSERT_TRUE(s.asleep(box));
        s.add(other, dynamics);
      }
      for (int i = 0; i < 128; ++i) s.step(T(dt));
      EXPECT_NEAR(s.poses()[box.index].translation.x, T(-0.2), T(0.01)) << kinematic << ", " << moved;
    }
}

/// What nothing holds, and what is driven, goes on, however slowly.
TYPED_TEST(SimulationOf, SlowMotionThatNothingEndsGoesOn) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(0), true));
  const BodyId drifting = s.add({Box<T>({T(1), T(1), T(1)}), {}, {T(0.004), T(0), T(0)}});
  Body<T> hook{Sphere<T>(T(0.1)), {{T(0), T(50), T(0)}, {}}};
  hook.fixed = true;
  const BodyId fixed = s.add(hook), driven = s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(60), T(0)}, {}}});
  Joint<T> joint = hinge_joint<T>(fixed, {{T(0), T(10), T(0)}, {}}, driven, {});
  JointDrive<T> drive;
  drive.space = JointSpace::angular;
  drive.velocity_target = T(0.009);
  drive.damping = T(1e7);
  joint.drives.push_back(drive);
  s.add(joint);
  for (int i = 0; i < 640; ++i) s.step(T(dt));
  EXPECT_NEAR(s.poses()[drifting.index].translation.x, T(0.04), T(1e-4));
  EXPECT_NEAR(T(2) * std::asin(s.poses()[driven.index].rotation.x), T(0.09), T(1e-3));
}

TYPED_TEST(SimulationOf, KinematicPlatformAndBelt) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  Dynamics<T> kinematic;
  kinematic.kinematic = true;
  const BodyId platform =
      s.add({Box<T>({T(40), T(1), T(4)}), {{T(0), T(-0.5), T(0)}, {}}, {T(0), T(1), T(0)}}, kinematic);
  const BodyId box = s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(0.5), T(0)}, {}}});
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.poses()[platform.index].translation.y, T(0.5), T(1e-4));
  EXPECT_NEAR(s.poses()[box.index].translation.y, T(1.5), T(0.005));
  s.set_velocity(platform, {});
  Material<T> belt;
  belt.surface_velocity = {T(2), T(0), T(0)};
  s.set_material(platform, belt);
  for (int i = 0; i < 2 * 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.motion(box).linear.x, T(2), T(0.01));
}

/// A surface that turns carries along the chord of the arc: along its tangent the box would be 7 cm further out, with a
/// spin of 1 rad/s and 64 steps a second.
TYPED_TEST(SimulationOf, WhatStandsOnATurntableStays) {
  using T = TypeParam;
  for (const bool above : {false, true}) {
    Simulation<T> s(settings<T>());
    Dynamics<T> kinematic;
    kinematic.kinematic = true;
    const Body<T> box{
        Box<T>({T(0.2), T(0.2), T(0.2)}), {{T(0.8), T(0.1), T(0)}, {}}, {T(0), T(0), T(-0.8)}, {T(0), T(1), T(0)}};
    // Either of the two is the first.
    const BodyId id = above ? s.add(box) : BodyId{};
    s.add({Cylinder<T>(T(1), T(1)), {{T(0), T(-0.5), T(0)}, {}}, {}, {T(0), T(1), T(0)}}, kinematic);
    const BodyId carried = above ? id : s.add(box);
    for (int i = 0; i < 10 * 64; ++i) s.step(T(dt));
    const Vec3<T> at = s.poses()[carried.index].translation;
    EXPECT_NEAR(std::hypot(at.x, at.z), T(0.8), T(1e-3));
    EXPECT_NEAR(std::atan2(-at.z, at.x), T(10 - 4 * std::numbers::pi), T(1e-2));
  }
}

/// What rocks on a round side is righted by a force at its point of contact: late by half a step, it rocked an
/// ellipsoid up from a tenth of a radian to six, and a ball with its weight below the middle over.
TYPED_TEST(SimulationOf, WhatRocksOnARoundSideComesToRest) {
  using T = TypeParam;
  for (const bool ball : {false, true})
    for (const T mu : {T(0), T(0.6)})
      for (const T lean : {T(0.02), T(0.1), T(0.3)}) {
        Simulation<T> s(settings<T>());
        Material<T> m;
        m.static_friction = m.dynamic_friction = mu;
        add_floor(s, m);
        const Shape<T> shape = ball ? Shape<T>(Sphere<T>(T(0.5))) : Ellipsoid<T>({T(1), T(0.5), T(0.8)});
        Dynamics<T> weight_below;
        if (ball) weight_below.center_of_mass = Vec3<T>{T(0), T(-0.25), T(0)};
        const BodyId body =
            s.add({shape, {{T(0), T(0.5), T(0)}, Quat<T>::from_axis_angle({T(0), T(0), T(1)}, lean)}}, weight_below, m);
        // An ellipsoid that leans stands higher; here it falls a little, and rocks on.
        T first(0), last(0);
        for (int i = 0; i < 60 * 64; ++i) {
          s.step(T(dt));
          const T leans = std::abs(T(2) * std::asin(s.poses()[body.index].rotation.z));
          if (i < 3 * 64) first = std::max(first, leans);
          if (i >= 57 * 64) last = std::max(last, leans);
        }
        EXPECT_LT(first, lean * T(1.1) + T(0.05)) << ball << ", " << mu;
        EXPECT_LT(last, first) << ball << ", " << mu << ", " << lean;
      }
}

/// v' = -c v: a speed v ends after the way v / c, and a fall has the speed g / c at last.
TYPED_TEST(SimulationOf, DampedBodiesGoAsFarAndFallAsFastAsTheyShould) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  Dynamics<T> damped;
  damped.linear_damping = damped.angular_damping = T(10);
  const BodyId falling = s.add({Sphere<T>(T(0.5)), {{T(50), T(0), T(0)}, {}}}, damped);
  damped.gravity_factor = T(0);
  const BodyId gliding = s.add({Sphere<T>(T(0.5)), {}, {T(2), T(0), T(0)}, {T(0), T(3), T(0)}}, damped);
  for (int i = 0; i < 4 * 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.motion(falling).linear.y / settings<T>().gravity.y, T(0.1), T(1e-6));
  EXPECT_NEAR(s.poses()[gliding.index].translation.x, T(0.2), T(1e-6));
  EXPECT_NEAR(T(2) * std::asin(s.poses()[gliding.index].rotation.y), T(0.3), T(1e-5));
}

TYPED_TEST(SimulationOf, BulletsStopAtAWallAndAtEachOther) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(0)));
  Body<T> wall{Box<T>({T(0.01), T(4), T(4)}), {{T(10.3), T(0), T(0)}, {}}};
  wall.fixed = true;
  s.add(wall);
  const BodyId bullet = s.add({Box<T>({T(0.2), T(0.2), T(0.2)}), {}, {T(300), T(0), T(0)}, {T(5), T(3), T(1)}});
  const BodyId left = s.add({Sphere<T>(T(0.1)), {{T(-10), T(8), T(0)}, {}}, {T(300), T(0), T(0)}});
  const BodyId right = s.add({Sphere<T>(T(0.1)), {{T(10), T(8), T(0)}, {}}, {T(-300), T(0), T(0)}});
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  EXPECT_LT(s.poses()[bullet.index].translation.x, T(10.3));
  EXPECT_LE(s.poses()[left.index].translation.x, s.poses()[right.index].translation.x);
}

/// Each body tells how many sub-steps its island took: many below something heavy, few in free flight.
TYPED_TEST(SimulationOf, BodiesTellTheSubStepsOfTheirIslands) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_floor<T>(s);
  Dynamics<T> heavy;
  heavy.mass = T(100000);
  const BodyId below = s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(0.5), T(0)}, {}}});
  const BodyId above = s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(1.5), T(0)}, {}}}, heavy);
  const BodyId flying = s.add({Sphere<T>(T(0.5)), {{T(9), T(90), T(0)}, {}}});
  EXPECT_EQ(s.sub_steps(flying), 0);
  for (int i = 0; i < 30; ++i) s.step(T(dt));
  EXPECT_EQ(s.sub_steps(below), s.sub_steps(above));
  EXPECT_EQ(s.sub_steps(below), s.report().most_sub_steps);
  EXPECT_LT(s.sub_steps(flying), s.sub_steps(below));
}

}  // namespace
}  // namespace graze::testing
