// Casts whose answers are known in closed form, and the ones that break such code: grazing, sliding, receding, resting,
// bullets, many turns, giants.
#include <numbers>

#include "cast_fixture.hpp"

namespace graze {
namespace {

template <class T>
class CastCases : public CastTest<T> {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(CastCases, Scalars);

TYPED_TEST(CastCases, BallsHeadOn) {
  using T = TypeParam;
  const auto hit = this->thrown(this->ball, {}, this->ball, {T(10), 0, 0}, {T(-16), 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, T(0.5), near_enough<T>);
  EXPECT_NEAR(hit->point.x, T(1), near_enough<T>);
  EXPECT_NEAR(hit->normal.x, T(1), near_enough<T>);
  EXPECT_LE(hit->depth, near_enough<T>);
  EXPECT_EQ(hit->status, Status::converged);
}

TYPED_TEST(CastCases, TheEndOfTheDurationCounts) {
  using T = TypeParam;
  EXPECT_TRUE(this->thrown(this->ball, {}, this->ball, {T(10), 0, 0}, {T(-8), 0, 0}));
  EXPECT_FALSE(this->thrown(this->ball, {}, this->ball, {T(10), 0, 0}, {T(-8), 0, 0}, T(0.999)));
  EXPECT_FALSE(this->thrown(this->ball, {}, this->ball, {T(10), 0, 0}, {T(-80), 0, 0}, T(0)));
}

TYPED_TEST(CastCases, WithoutMotionOnlyWhatTouchesHits) {
  using T = TypeParam;
  EXPECT_FALSE(this->thrown(this->cube, {}, this->ball, {T(3), 0, 0}, {}));
  const auto hit = this->thrown(this->cube, {}, this->ball, {T(2), 0, 0}, {});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, T(0));
  // Moving together is standing still.
  EXPECT_FALSE(cast(this->cube, {}, {{T(9), 0, 0}, {}}, this->ball, {{T(3), 0, 0}, {}}, {{T(9), 0, 0}, {}}, T(1)));
}

TYPED_TEST(CastCases, OverlapAtTheStartHitsAtOnceWithItsDepth) {
  using T = TypeParam;
  for (const T away : {T(-1), T(0), T(1)}) {
    const auto hit = this->thrown(this->cube, {}, this->cube, {T(1.5), 0, 0}, {away, 0, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, T(0));
    EXPECT_NEAR(hit->depth, T(0.5), near_enough<T>);
    EXPECT_NEAR(hit->normal.x, T(1), near_enough<T>);
  }
}

TYPED_TEST(CastCases, RecedingMisses) {
  using T = TypeParam;
  EXPECT_FALSE(this->thrown(this->cube, {}, this->cube, {T(3), 0, 0}, {T(5), T(1), 0}));
  EXPECT_FALSE(this->thrown(this->ground, {}, this->cube, {0, T(1.5), 0}, {T(100), T(0), 0}));
}

TYPED_TEST(CastCases, SeparatingFromContactIsNoHitWhenIgnored) {
  using T = TypeParam;
  const auto move = [&](const Vec3<T>& start, const Vec3<T>& v) {
    return this->thrown(this->ground, {}, this->cube, start, v, T(1), Separating::ignored);
  };
  EXPECT_FALSE(move({0, T(1), 0}, {0, T(1), 0}));          // leaves
  EXPECT_FALSE(move({0, T(1), 0}, {T(3), 0, T(4)}));       // slides
  EXPECT_FALSE(move({0, T(0.9), 0}, {T(3), 0, T(4)}));     // slides, sunk in
  EXPECT_FALSE(move({0, T(0.9), 0}, {T(3), T(0.5), 0}));   // leaves, sunk in
  EXPECT_TRUE(move({0, T(1), 0}, {T(3), T(-0.1), T(4)}));  // pushes on
  EXPECT_TRUE(move({0, T(2), 0}, {T(3), T(-2), T(4)}));    // arrives
}

TYPED_TEST(CastCases, TurningInContactIsNoHitWhenIgnored) {
  using T = TypeParam;
  const auto turn = [&](const Vec3<T>& angular, T up) {
    return cast(this->ground, {}, {}, this->cube, {{0, T(1), 0}, {}}, {{0, up, 0}, angular}, T(1),
                {Separating::ignored});
  };
  EXPECT_FALSE(turn({0, T(30), 0}, T(0)));  // spins where it stands
  ASSERT_TRUE(turn({0, 0, T(1)}, T(0)));    // tips over an edge that has to go down
  EXPECT_EQ(turn({0, 0, T(1)}, T(0))->t, T(0));
  // Leaves fast enough for its corners: these reach sqrt(2) sin(45 degrees + t) down, whose greatest rate is 1.
  EXPECT_FALSE(turn({0, 0, T(1)}, T(1.001)));
}

TYPED_TEST(CastCases, AWheelRollsOnTheGround) {
  using T = TypeParam;
  const Shape<T> wheel{Sphere<T>(T(1))};
  EXPECT_FALSE(cast(this->ground, {}, {}, wheel, {{0, T(1), 0}, {}}, {{T(5), 0, 0}, {0, 0, T(-5)}}, T(10),
                    {Separating::ignored}));
}

TYPED_TEST(CastCases, GrazingPassesAreToldApartByTheTolerance) {
  using T = TypeParam;
  const T d = cast_tolerance<T>;
  for (const T gap : {T(64) * d, T(-64) * d}) {
    const bool meets = gap < T(0);
    const Vec3<T> along{T(20), 0, 0};
    EXPECT_EQ(this->thrown(this->ball, {}, this->ball, {T(-10), T(2) + gap, 0}, along).has_value(), meets);
    EXPECT_EQ(this->thrown(this->cube, {}, this->ball, {T(-10), T(2) + gap, 0}, along).has_value(), meets);
    EXPECT_EQ(this->thrown(this->cube, {}, this->cube, {T(-10), T(2) + gap, 0}, along).has_value(), meets);
    EXPECT_EQ(this->thrown(this->ground, {}, this->cube, {T(-10), T(1) + gap, 0}, along).has_value(), meets);
  }
}

TYPED_TEST(CastCases, BulletsDoNotTunnel) {
  using T = TypeParam;
  const Shape<T> bullet{Sphere<T>(T(0.005))}, sheet{Rectangle<T>(T(1), T(1))};
  const Quat<T> tilted = Quat<T>::from_axis_angle(normalized(Vec3<T>{T(1), T(2), T(3)}), T(0.7));
  const Vec3<T> up = rotate(tilted, Vec3<T>{0, T(1), 0});
  for (int i = 0; i < 100; ++i) {
    const Vec3<T> target = rotate(tilted, Vec3<T>{T(0.009) * T(i) - T(0.45), 0, T(0.3)});
    const Vec3<T> from = target + up * T(50) + Vec3<T>{T(0.4) * T(i), 0, 0};
    const auto hit = cast(sheet, {{}, tilted}, {}, bullet, {from, {}}, {(target - from) * T(20), {}}, T(1));
    ASSERT_TRUE(hit) << i;
    EXPECT_NEAR(hit->t, T(0.05), T(0.001));
    EXPECT_NEAR(length(hit->normal - up), T(0), (std::is_same_v<T, float> ? T(1e-5) : T(1e-9)));
  }
}

TYPED_TEST(CastCases, ARodSweepsRound) {
  using T = TypeParam;
  // A segment 4 long turns about its middle and meets a ball on its circle, turns later if it starts that late.
  const Shape<T> rod{LineSegment<T>({T(-2), 0, 0}, {T(2), 0, 0})}, pea{Sphere<T>(T(0.001))};
  const T pi = std::numbers::pi_v<T>;
  const auto hit = cast(rod, {}, {{}, {0, 0, pi}}, pea, {{0, T(1.5), 0}, {}}, {}, T(1));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, T(0.5) - std::asin(T(0.001) / T(1.5)) / pi, T(4) * near_enough<T>);
  EXPECT_NEAR(hit->point.y, T(1.5), T(1e-5));

  // A hundred turns a unit of time, out of reach until the ball has come near.
  const auto late = cast(rod, {}, {{}, {0, 0, T(200) * pi}}, pea, {{0, T(10), 0}, {}}, {{0, T(-1), 0}, {}}, T(20));
  ASSERT_TRUE(late);
  EXPECT_EQ(late->status, Status::converged);
  EXPECT_GT(late->t, T(7.998));
  EXPECT_LT(late->t, T(8.01));
}

TYPED_TEST(CastCases, AWheelTurnsAThousandTimesAHairAboveTheGround) {
  using T = TypeParam;
  const Shape<T> wheel{Cylinder<T>(T(0.5), T(1), T(1))}, road{Box<T>({T(100), T(1), T(100)})};
  const Quat<T> lying = Quat<T>::from_axis_angle({T(1), 0, 0}, std::numbers::pi_v<T> / T(2));
  const T above = T(20) * cast_tolerance<T> * T(71);  // the road reaches 71 far
  const auto roll = [&](const Shape<T>& ground, const Pose<T>& at, T fall) {
    return cast(ground, at, {}, wheel, {{T(-40), T(1) + above, 0}, lying}, {{T(80), -fall, 0}, {0, 0, T(-6283)}}, T(1));
  };
  EXPECT_FALSE(roll(road, {{0, T(-0.5), 0}, {}}, T(0)));
  EXPECT_FALSE(roll(this->ground, {}, T(0)));
  for (const auto& hit : {roll(road, {{0, T(-0.5), 0}, {}}, T(1)), roll(this->ground, {}, T(1))}) {
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->status, Status::converged);
    EXPECT_NEAR(hit->t, above, above / T(2));
    EXPECT_NEAR(hit->normal.y, T(1), T(1e-5));
  }
}

// The faster a body turns the more often it comes by: each turn is a chance to miss it.
TYPED_TEST(CastCases, ABladeIsCaughtInTheFirstTurnThatReaches) {
  using T = TypeParam;
  const Shape<T> blade{Box<T>({T(4), T(0.01), T(0.2)})}, pea{Sphere<T>(T(0.01))};
  for (const T rate : {T(10), T(100), T(1000)}) {
    // The pea falls along the blade's plane of turning, towards its axis, at 1 a unit of time.
    const auto hit = cast(blade, {}, {{}, {0, 0, rate}}, pea, {{T(0.1), T(3), 0}, {}}, {{0, T(-1), 0}, {}}, T(3));
    ASSERT_TRUE(hit) << rate;
    ASSERT_EQ(hit->status, Status::converged) << rate;
    EXPECT_GT(hit->t, T(0.98));                        // not before the pea is within the blade's reach
    EXPECT_LT(hit->t, T(1) + T(3.15) / rate) << rate;  // half a turn after it can
    EXPECT_GT(length(hit->point), T(1.5));
  }
}

TYPED_TEST(CastCases, FarFromTheOriginIsTheSame) {
  using T = TypeParam;
  const Vec3<T> far{T(1 << 20), T(-(1 << 20)), T(1 << 19)};
  const auto here = this->thrown(this->cube, {}, this->ball, {T(8), T(1.5), T(1.25)}, {T(-16), 0, 0});
  const auto there = this->thrown(this->cube, far, this->ball, far + Vec3<T>{T(8), T(1.5), T(1.25)}, {T(-16), 0, 0});
  ASSERT_TRUE(here && there);
  EXPECT_EQ(here->t, there->t);
  EXPECT_TRUE(here->normal == there->normal);
}

TYPED_TEST(CastCases, GiantsAreHitWithinTheSameRelativeTolerance) {
  using T = TypeParam;
  for (const T giant : {T(500), T(5000), T(50000)}) {
    const Shape<T> huge{Box<T>({giant, giant, giant})}, small{Box<T>({T(1), T(1), T(1)})};
    const T start = giant / T(2) + T(8);
    const auto hit = this->thrown(huge, {}, small, {T(3), start, giant / T(4)}, {T(2), T(-15), 0});
    ASSERT_TRUE(hit) << giant;
    const double d = static_cast<double>(cast_tolerance<T>) * static_cast<double>(giant);
    EXPECT_NEAR(static_cast<double>(hit->t), 0.5, (d / 15 + (std::is_same_v<T, float> ? 1e-7 : 0.0))) << giant;
    EXPECT_NEAR(hit->normal.y, T(1), T(1e-6));
  }
}

TYPED_TEST(CastCases, ABoxTumblesOntoAGiant) {
  using T = TypeParam;
  for (const T giant : {T(500), T(5000), T(50000)}) {
    const Shape<T> huge{Box<T>({giant, giant, giant})}, small{Box<T>({T(1), T(1), T(1)})};
    const Pose<T> start{{giant / T(3), giant / T(2) + T(8), T(5)}, {}};
    const Velocity<T> fall{{T(1), T(-15), T(2)}, {T(3), T(1), T(-2)}};
    const auto hit = cast(huge, {}, {}, small, start, fall, T(1));
    ASSERT_TRUE(hit) << giant;
    EXPECT_EQ(hit->status, Status::converged);
    // How low the turned box reaches: the sum of its half edges' heights.
    const Mat3<T> turned = rotation_matrix(pose_at(start, fall, hit->t).rotation);
    const T low = (std::abs(turned.row[1].x) + std::abs(turned.row[1].y) + std::abs(turned.row[1].z)) / T(2);
    EXPECT_NEAR(T(8) - T(15) * hit->t - low, T(0), cast_tolerance<T> * giant + T(8e-6) * T(std::is_same_v<T, float>));
    EXPECT_NEAR(hit->normal.y, T(1), T(1e-5));
  }
}

TYPED_TEST(CastCases, PointsThatMeet) {
  using T = TypeParam;
  const Shape<T> point{Sphere<T>(T(0))};
  const auto hit = this->thrown(point, {}, point, {T(4), 0, 0}, {T(-8), 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, T(0.5), near_enough<T>);
  EXPECT_TRUE(this->thrown(point, {}, point, {}, {}));
  EXPECT_FALSE(this->thrown(point, {}, point, {T(4), T(1), 0}, {T(-8), 0, 0}));
}

TYPED_TEST(CastCases, HalfSpaces) {
  using T = TypeParam;
  const Quat<T> down{T(1), 0, 0, 0};
  const auto hit = cast(this->ground, {}, {}, this->ground, {{0, T(3), 0}, down}, {{T(7), T(-6), 0}, {}}, T(1));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, T(0.5), near_enough<T>);
  EXPECT_EQ(cast(this->ground, {}, {}, this->ground, {{0, T(3), 0}, {}}, {}, T(1))->status, Status::unbounded);
  // A plane that rises to a body that stands.
  const auto risen = cast(this->cube, {{0, T(3), 0}, {}}, {}, this->ground, {}, {{0, T(4), 0}, {}}, T(1));
  ASSERT_TRUE(risen);
  EXPECT_NEAR(risen->t, T(0.5), near_enough<T>);
  EXPECT_NEAR(risen->normal.y, T(-1), near_enough<T>);
  // One that turns about its edge below the cube, whose gap at the angle t is 2 cos t - sin t.
  const auto turned = cast(this->cube, {{0, T(3), 0}, {}}, {}, this->ground, {}, {{}, {T(1), 0, 0}}, T(2));
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->status, Status::converged);
  EXPECT_NEAR(turned->t, T(std::atan(2.0)), near_enough<T>);
  EXPECT_FALSE(cast(this->cube, {{0, T(3), 0}, {}}, {}, this->ground, {}, {{}, {T(1), 0, 0}}, T(1.1)));
  // A ball aside, which the ground comes down upon when it is nearly turned over; about its own normal it never does.
  const Pose<T> aside{{T(-3), T(2), 0}, {}};
  const auto met = cast(this->ground, {}, {{}, {0, 0, T(1)}}, this->ball, aside, {}, T(3));
  ASSERT_TRUE(met);
  EXPECT_NEAR(met->t, T(std::acos(-1.0) - std::asin(1 / std::sqrt(13.0)) - std::atan2(2.0, 3.0)), near_enough<T>);
  EXPECT_FALSE(cast(this->ground, {}, {{}, {0, T(9), 0}}, this->ball, aside, {}, T(30)));
}

TYPED_TEST(CastCases, HalfSpacesThatMeetEachOther) {
  using T = TypeParam;
  // Opposite, tilted, far from the origin, rounded: the gap of 2 closes at 4, but for what is up and down the slope.
  const Quat<T> tilt = normalized(Quat<T>{T(0.2), T(-0.1), T(0.4), T(0.8)}), down{T(1), 0, 0, 0};
  const Vec3<T> up = rotate(tilt, Vec3<T>{0, T(1), 0}), aside = rotate(tilt, Vec3<T>{T(1), 0, 0});
  const Shape<T> thick{HalfSpace<T>(), T(0.25)};
  const Pose<T> lower{{T(30), T(-20), T(10)}, tilt}, upper{lower.translation + up * T(2.5) + aside * T(7), tilt * down};
  const auto move = [&](const Vec3<T>& v, T duration, Separating separating = Separating::hit) {
    return cast(thick, lower, {}, thick, upper, {v, {}}, duration, {separating});
  };
  const T near = T(64) * std::numeric_limits<T>::epsilon() * T(50);
  for (const Separating separating : {Separating::hit, Separating::ignored}) {
    const auto hit = move(up * T(-4) + aside * T(3), T(1), separating);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->status, Status::converged);
    EXPECT_NEAR(hit->t, T(0.5), near);
    EXPECT_NEAR(dot(hit->normal, up), T(1), near);
    EXPECT_NEAR(dot(hit->point - lower.translation, up), T(0.25), near);
  }
  EXPECT_FALSE(move(up * T(-4), T(0.49)));
  EXPECT_FALSE(move(up * T(4) + aside, T(9)));
  // Half a unit deep from the start.
  const Pose<T> sunk{lower.translation, tilt * down};
  const auto overlapping = cast(thick, lower, {}, thick, sunk, {up, {}}, T(1));
  ASSERT_TRUE(overlapping);
  EXPECT_EQ(overlapping->t, T(0));
  EXPECT_NEAR(overlapping->depth, T(0.5), near);
  EXPECT_FALSE(cast(thick, lower, {}, thick, sunk, {up, {}}, T(1), {Separating::ignored}));

  // All others overlap without end, whatever they do: at once, at a point of both.
  for (const Quat<T>& turned :
       {Quat<T>{}, normalized(Quat<T>{T(0.9), 0, 0, T(0.5)}), normalized(Quat<T>{T(1), 0, 0, T(1e-3)})}) {
    const Pose<T> other{{0, T(3), T(1)}, turned};
    const auto endless = cast(this->ground, {}, {}, this->ground, other, {{0, T(9), 0}, {}}, T(1));
    ASSERT_TRUE(endless);
    EXPECT_EQ(endless->t, T(0));
    EXPECT_EQ(endless->status, Status::unbounded);
    EXPECT_NEAR(length(endless->normal), T(1), near);
    for (const Pose<T>& plane : {Pose<T>{}, other})
      EXPECT_LE(dot(endless->point - plane.translation, rotate(plane.rotation, Vec3<T>{0, T(1), 0})), near * T(1000));
    EXPECT_FALSE(cast(this->ground, {}, {}, this->ground, other, {{0, T(9), 0}, {}}, T(1), {Separating::ignored}));
  }
}

TYPED_TEST(CastCases, IgnoringWhatSeparatesChangesNoHitThatIsArrivedAt) {
  using T = TypeParam;
  unsigned state = 9;
  const auto next = [&] {
    state = state * 1664525u + 1013904223u;
    return static_cast<T>(state >> 8) / T(1 << 24) * T(2) - T(1);
  };
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const Quat<T> q = normalized(Quat<T>{next(), next(), next(), next()});
    const Pose<T> start{{T(5), next(), next()}, q};
    const Velocity<T> v{{T(-4), next(), next()}, i % 2 ? Vec3<T>{next(), next(), next()} * T(4) : Vec3<T>{}};
    const Shape<T>& shape = i % 3 ? this->cube : this->ball;
    const auto plain = cast(this->cube, {}, {}, shape, start, v, T(1));
    const auto sliding = cast(this->cube, {}, {}, shape, start, v, T(1), {Separating::ignored});
    if (plain && sliding) {
      ++hits;
      EXPECT_NEAR(plain->t, sliding->t, T(16) * cast_tolerance<T>) << i;
    } else if (plain) {  // it only grazed, or came at the very end
      for (T t = plain->t; t < T(1); t += T(0.001))
        EXPECT_GT(distance(this->cube, Pose<T>{}, shape, pose_at(start, v, t)).distance,
                  T(-4) * T(sinking) * cast_tolerance<T>);
    } else {
      EXPECT_FALSE(sliding) << i;
    }
  }
  EXPECT_GT(hits, 100);
}

/// However long bodies fly on after they could have met: the tolerance goes with the way until then.
TYPED_TEST(CastCases, DurationsOfAnyLength) {
  using T = TypeParam;
  const T longest = sizeof(T) == 4 ? T(1e12) : T(1e16);
  const Shape<T> ball = Sphere<T>(T(0.5));
  for (const Shape<T>& other : {ball, Shape<T>(HalfSpace<T>())}) {
    const bool plane = &other != &ball && other.template as<HalfSpace<T>>();
    const T gap = plane ? T(1.5) : T(1);
    for (T duration(10); duration <= longest; duration *= T(1000)) {
      const auto meets = cast<T>(other, {}, {}, ball, {{T(0), T(2), T(0)}, {}}, {{T(0), T(-1), T(0)}, {}}, duration);
      ASSERT_TRUE(meets) << duration;
      EXPECT_NEAR(meets->t, gap, T(2) * cast_tolerance<T>) << duration;
      EXPECT_FALSE(cast<T>(other, {}, {}, ball, {{T(0), T(2), T(0)}, {}}, {{T(0), T(1), T(0)}, {}}, duration))
          << duration;
    }
  }
}

}  // namespace
}  // namespace graze
