// Continuous collision with what nothing stops, where fast kinematic bodies take along what they meet, and in crowds,
// where those behind are held back by those in front.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "dynamics/simulated.hpp"
#include "graze/plane/simulation.hpp"

namespace graze::testing {
namespace {

template <class T>
class Continuous : public ::testing::Test {};
using ScalarsOfContinuous = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Continuous, ScalarsOfContinuous);

template <class T>
Dynamics<T> kinematic() {
  Dynamics<T> d;
  d.kinematic = true;
  return d;
}

/// A plate of 2 cm that moves by up to 150 times that in a step, towards a ball that rests, awake or asleep: the ball
/// leaves with the plate, before it, from wherever the plate comes.
TYPED_TEST(Continuous, APlateTakesABallAlong) {
  using T = TypeParam;
  for (const T speed : {T(7), T(30), T(200)})
    for (const T radius : {T(0.05), T(1)})
      for (const bool asleep : {false, true})
        for (int offset = 0; offset < 4; ++offset) {
          Simulation<T> s(settings<T>(T(0), true));
          const BodyId ball = s.add({Sphere<T>(radius)});
          for (int i = 0; asleep && !s.asleep(ball); ++i) {
            s.step(T(dt));
            ASSERT_LT(i, 1000);
          }
          const T start = T(-5) - T(offset) * speed * T(dt) / T(4);
          const BodyId plate =
              s.add({Box<T>({T(0.02), T(2), T(2)}), {{start, T(0), T(0)}, {}}, {speed, T(0), T(0)}}, kinematic<T>());
          for (int i = 0; i < 128; ++i) s.step(T(dt));
          const T ahead = s.poses()[ball.index].translation.x - s.poses()[plate.index].translation.x;
          EXPECT_NEAR(s.motion(ball).linear.x, speed, speed * T(0.01)) << speed << ", " << radius << ", " << asleep;
          EXPECT_GT(ahead, radius) << speed << ", " << radius << ", " << asleep;
        }
}

/// A rod of 4 m that turns by 36 degrees in a step strikes a ball that rests beside its axis.
TYPED_TEST(Continuous, ARodThatTurnsStrikesABall) {
  using T = TypeParam;
  for (int offset = 0; offset < 16; ++offset) {
    Simulation<T> s(settings<T>(T(0)));
    const Quat<T> turned = Quat<T>::from_axis_angle({T(0), T(1), T(0)}, T(offset) * T(0.04));
    s.add({Box<T>({T(4), T(0.2), T(0.04)}), {{}, turned}, {}, {T(0), T(40), T(0)}}, kinematic<T>());
    const BodyId ball = s.add({Sphere<T>(T(0.1)), {{T(0), T(0), T(1.5)}, {}}});
    for (int i = 0; i < 16; ++i) s.step(T(dt));
    EXPECT_GT(length(s.motion(ball).linear), T(20)) << offset;
  }
}

/// What hard joints hold together is taken along together.
TYPED_TEST(Continuous, JoinedBodiesStayTogether) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(0)));
  const BodyId first = s.add({Sphere<T>(T(0.2))});
  const BodyId second = s.add({Sphere<T>(T(0.2)), {{T(0.5), T(0), T(0)}, {}}});
  s.add(fixed_joint<T>(first, {{T(0.5), T(0), T(0)}, {}}, second, {}));
  s.add({Box<T>({T(0.02), T(2), T(2)}), {{T(-3), T(0), T(0)}, {}}, {T(50), T(0), T(0)}}, kinematic<T>());
  for (int i = 0; i < 64; ++i) s.step(T(dt));
  EXPECT_NEAR(s.motion(first).linear.x, T(50), T(2));
  EXPECT_NEAR(s.motion(second).linear.x, T(50), T(2));
  EXPECT_NEAR(s.poses()[second.index].translation.x - s.poses()[first.index].translation.x, T(0.5), T(0.01));
}

/// Plates that tumble towards a wall without friction, and are held back by it time and again.
TEST(ContinuousTumbling, GivesNoEnergy) {
  std::mt19937 random(2);
  std::normal_distribution<double> number;
  Material<double> smooth;
  smooth.static_friction = smooth.dynamic_friction = 0;
  for (int k = 0; k < 20; ++k) {
    Simulation<double> s(settings<double>(0));
    Body<double> wall{Box<double>({20, 1, 20}), {{0, -0.5, 0}, {}}};
    wall.fixed = true;
    s.add(wall, {}, smooth);
    const Quatd turned = normalized(Quatd{number(random), number(random), number(random), number(random)});
    const Vec3d spin = normalized(Vec3d{number(random), number(random), number(random)}) * 30.0;
    s.add({Box<double>({1, 0.2, 0.4}), {{0, 2, 0}, turned}, {0, -1, 0}, spin}, {}, smooth);
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 180; ++i) {
      s.step(1.0 / 60);
      ASSERT_LT(s.report().kinetic_energy, 1.01 * last) << k << ", " << i;
      last = s.report().kinetic_energy;
    }
  }
}

/// What comes down on a corner at 60 or 100 m/s turns by several radians in a step: nothing goes through the ground,
/// nor stays in it.
TEST(ContinuousTumbling, WhatTurnsFastStaysAboveTheGround) {
  std::mt19937 random(3);
  std::normal_distribution<double> number;
  const Shape<double> shapes[] = {Box<double>({0.2, 0.2, 0.2}), Cylinder<double>(0.1, 0.2), Capsule<double>(0.05, 0.2),
                                  Box<double>({0.3, 0.04, 0.2})};
  for (const double speed : {60.0, 100.0})
    for (const bool field : {false, true})
      for (const Shape<double>& shape : shapes)
        for (int k = 0; k < 25; ++k) {
          Simulation<double> s(settings<double>());
          Body<double> ground{field ? Shape<double>(HeightField<double>(201, 201, std::vector<double>(201 * 201, 0.0)))
                                    : Shape<double>(HalfSpace<double>())};
          ground.fixed = true;
          s.add(ground);
          const Quatd turned = normalized(Quatd{number(random), number(random), number(random), number(random)});
          const BodyId body = s.add({shape, {{0, 3, 0}, turned}, {0, -speed, 0}});
          for (int i = 0; i < 120; ++i) s.step(1.0 / 60);
          EXPECT_GT(s.poses()[body.index].translation.y, 0) << field << ", " << speed << ", " << shape.name() << k;
        }
}

/// Ten thin plates fall on a floor behind each other, in a step further than the gaps between them: those behind do not
/// pass through those that the floor has stopped, until all have come to it.
TYPED_TEST(Continuous, PlatesThatFallBehindEachOtherStayInOrder) {
  using T = TypeParam;
  for (const T tilt : {T(0), T(0.01)}) {
    Simulation<T> s(settings<T>());
    add_floor(s);
    std::vector<BodyId> plates;
    for (int i = 0; i < 10; ++i) {
      const Quat<T> turned = Quat<T>::from_axis_angle({T(0), T(0), T(1)}, tilt * T(i % 3 - 1));
      const Pose<T> pose{{T(0), T(0.1) + T(0.05) * T(i), T(0)}, turned};
      plates.push_back(s.add({Box<T>({T(1), T(0.02), T(1)}), pose, {T(0), T(-5), T(0)}}));
    }
    const auto height = [&](std::size_t i) { return s.poses()[plates[i].index].translation.y; };
    for (int step = 0; step < 30; ++step) {
      s.step(T(1) / T(60));
      for (std::size_t i = 0; i + 1 < plates.size(); ++i)
        ASSERT_LT(height(i), height(i + 1)) << tilt << ", step " << step << ", plate " << i;
    }
  }
}

/// A house of cards of five storeys, each card two metres long and two centimetres thick, that falls when one is taken
/// away: cards fall on cards that fall, and cut into each other by little more than their thickness.
TEST(ContinuousCrowd, CardsThatFallOnCardsDoNotPassThrough) {
  constexpr double card = 2, thick = 0.02, lean = 0.4363323129985824;  // 25 degrees
  const double c = std::cos(lean), s = std::sin(lean), high = 2 * (c + thick / 2 * s), apart = card + 0.005;
  Material<double> rough;
  rough.static_friction = rough.dynamic_friction = 0.7;
  for (const std::size_t taken : {3, 6, 14, 20}) {
    Simulation<double> house(settings<double>());
    add_floor(house, rough);
    std::vector<BodyId> cards;
    const auto add = [&](double x, double y, double angle) {
      const Posed pose{{x, y, 0}, Quatd::from_axis_angle({0, 0, 1}, angle)};
      cards.push_back(house.add({Box<double>({thick, card, 1}), pose}, {}, rough));
    };
    double level = 0;
    for (int storey = 5; storey > 0; --storey) {
      for (int i = 0; i < storey; ++i)
        for (const double side : {-1.0, 1.0})
          add((i - 0.5 * (storey - 1)) * apart + side * (s + thick / 2 * c), level + high / 2, side * lean);
      for (int i = 0; i + 1 < storey; ++i)
        add((i - 0.5 * (storey - 2)) * apart, level + high + thick / 2, std::numbers::pi / 2);
      level += high + thick;
    }
    for (int i = 0; i < 40; ++i) house.step(1.0 / 60);
    house.remove(cards[taken]);
    double least_energy = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 180; ++i) {
      house.step(1.0 / 60);
      const StepReport<double> report = house.report();
      const double energy = report.kinetic_energy + report.potential_energy;
      EXPECT_LT(report.deepest, 0.2) << taken << ", step " << i;
      EXPECT_LT(energy, least_energy * 1.01) << taken << ", step " << i;
      least_energy = std::min(least_energy, energy);
    }
  }
}

/// Columns of boxes of the plane that fall by half their size in a step, a fifth of it apart: those below stop first,
/// and none of those above goes on into them once the lowest have come to rest.
TEST(ContinuousCrowd, ColumnsThatFallInThePlaneStayColumns) {
  constexpr double size = 0.25, apart = 0.3;
  constexpr int columns = 10, rows = 45;
  plane::Simulation<double> s(plane::SimulationSettings<double>{});
  const auto wall = [](double side) {
    return plane::Placed<double>{plane::Box<double>({1, 60}), {{side * (columns * apart / 2 + 0.6), 30}, {}}};
  };
  plane::Body<double> tray{plane::Compound<double>({{plane::Box<double>({40, 1}), {{0, -0.5}, {}}}, wall(-1), wall(1)}),
                           {}};
  tray.fixed = true;
  s.add(tray);
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k < rows; ++k)
      s.add({plane::Box<double>({size, size}), {{(i - 0.5 * (columns - 1)) * apart, 3 + k * apart}, {}}});
  for (int i = 0; i < 140; ++i) {
    s.step(1.0 / 60);
    if (i >= 79) {
      EXPECT_LT(s.report().deepest, 0.4 * size) << i;
    }
  }
}

/// A blade that turns by a radian and more in a step takes balls along and throws them off, wherever it meets them.
TEST(Continuous, ABladeThrowsOffWhatItMeets) {
  for (const double spin : {30.0, 80.0, 120.0})
    for (int k = 0; k < 40; ++k) {
      plane::SimulationSettings<double> weightless;
      weightless.gravity = {};
      plane::Simulation<double> s(weightless);
      plane::Dynamics<double> kinematic;
      kinematic.kinematic = true;
      plane::Body<double> blade{plane::Box<double>({2, 0.04}), {}};
      blade.angular = spin;
      s.add(blade, kinematic);
      const double r = 0.2 + 0.015 * k, turn = 0.3 + 0.06 * k;
      const BodyId ball = s.add({plane::Circle<double>(0.05), {{r * std::cos(turn), r * std::sin(turn)}, {}}});
      for (int i = 0; i < 30; ++i) s.step(1.0 / 60);
      EXPECT_GT(length(s.motion(ball).linear), 0.5 * spin * r) << spin << ", " << k;
    }
}

/// Of the plane, at a slant: a box on thin floors and on the solid half-plane.
TEST(ContinuousTumbling, WhatTurnsFastStaysAboveTheGroundOfThePlane) {
  const plane::Shape<double> floors[] = {plane::Segment<double>({-1000, 0}, {1000, 0}),
                                         plane::Box<double>({2000, 0.02}), plane::HalfPlane<double>()};
  for (const plane::Shape<double>& floor : floors)
    for (const double speed : {30.0, 60.0, 100.0})
      for (int k = 0; k < 50; ++k) {
        plane::Simulation<double> s(plane::SimulationSettings<double>{});
        plane::Body<double> ground{floor, {}};
        ground.fixed = true;
        s.add(ground);
        const auto turned = plane::Rot2<double>::from_angle(0.1256 * k);
        const BodyId body = s.add({plane::Box<double>({0.2, 0.05}), {{0, 2}, turned}, {speed, -speed}});
        for (int i = 0; i < 120; ++i) s.step(1.0 / 60);
        EXPECT_GT(s.poses()[body.index].translation.y, 0) << floor.name() << ", " << speed << ", " << k;
      }
}

/// Long, flat, pointed and round bodies, thrown down fast and turning, stay above a surface without thickness: also
/// those that a contact stops in the step in which they went through it, and those whose ends turn down beside it.
TEST(ContinuousTumbling, WhatIsThrownDownStaysAboveAMesh) {
  const std::vector<Vec3d> corners{{-5, 0, -5}, {-5, 0, 5}, {5, 0, 5}, {5, 0, -5}};
  const Mesh<double> ground(corners, {{0, 1, 2}, {0, 2, 3}});
  const std::vector<Vec3d> pyramid{{0.1, 0, 0}, {-0.1, 0.05, 0}, {-0.1, -0.05, 0.08}, {-0.1, -0.05, -0.08}};
  const std::pair<Shape<double>, double> thrown[] = {{Ellipsoid<double>({0.3, 0.05, 0.05}), 40},
                                                     {Box<double>({1, 0.05, 0.05}), 20},
                                                     {ConvexHull<double>(pyramid), 40},
                                                     {Capsule<double>(0.1, 0.025), 60}};
  for (const auto& [shape, speed] : thrown) {
    std::mt19937 random(5);
    const auto number = [&] { return static_cast<double>(random() % 4096) / 2048 - 1; };
    const auto vector = [&] {
      const double x = number(), y = number();
      return Vec3d{x, y, number()};
    };
    for (int k = 0; k < 60; ++k) {
      SimulationSettings<double> with_sleep = settings<double>(10, true);
      Simulation<double> s(with_sleep);
      Body<double> floor{ground};
      floor.fixed = true;
      s.add(floor);
      const Vec3d axis = vector();
      const Vec3d at = vector();
      const BodyId id = s.add({shape,
                               {{at.x, 3 + at.y, at.z}, normalized(Quatd{axis.x, axis.y, axis.z, 0.5})},
                               {0, -speed, 0},
                               vector() * 20.0});
      for (int i = 0; i < 120; ++i) s.step(1.0 / 60);
      const Vec3d c = s.motion(id).center;
      if (std::abs(c.x) < 4.5 && std::abs(c.z) < 4.5) {
        EXPECT_GT(c.y, 0) << speed << " m/s, " << k;
      }
    }
  }
}

}  // namespace
}  // namespace graze::testing
