#include <gtest/gtest.h>

#include "plane/figures.hpp"

namespace graze::plane {
namespace {

constexpr int looks = 64;

template <class F>
void for_moving_pairs(bool turning, const F& f) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double scale : {1e-4, 1.0, 1e5, 0.01, 30.0, 1e3})
    for (int i = 0; i < figure_kinds; ++i)
      for (int j = 0; j < figure_kinds; ++j) {
        const auto a = random_figure<double>(i, scale, random), b = random_figure<double>(j, scale, random);
        const Pose2d pose_a = random_pose<double>(scale, random), pose_b = random_pose<double>(2 * scale, random);
        const auto velocity = [&] {
          return Velocity<double>{{4 * scale * uniform(random), 4 * scale * uniform(random)},
                                  turning ? uniform(random) : 0};
        };
        f(a, pose_a, velocity(), b, pose_b, velocity(), scale);
      }
}

/// No contact is missed and none is passed: shapes are apart before a hit and touch there.
void expect_first_contacts(bool turning) {
  int hits = 0, misses = 0;
  for_moving_pairs(turning, [&](const auto& a, const auto& pose_a, const auto& of_a, const auto& b, const auto& pose_b,
                                const auto& of_b, double scale) {
    const auto hit = cast<double>(a.shape, pose_a, of_a, b.shape, pose_b, of_b, 1);
    const auto apart = [&](double t) {
      return distance(a.shape, pose_at(pose_a, of_a, t), b.shape, pose_at(pose_b, of_b, t)).distance;
    };
    const std::string pair = std::string(a.shape.name()) + " and " + b.shape.name() + " of " + std::to_string(scale);
    const double near = 10 * cast_tolerance<double> * scale;
    if (hit) {
      ASSERT_EQ(hit->status, Status::converged) << pair;
    }
    const double until = hit ? hit->t : 1;
    for (int k = 0; k < looks; ++k)
      if (!hit || hit->t > 0) {
        ASSERT_GT(apart(until * k / looks), 0) << pair << " at " << until * k / looks;
      }
    ++(hit ? hits : misses);
    if (!hit) return;
    if (hit->t > 0) {
      ASSERT_NEAR(apart(hit->t), 0, near) << pair;
    } else {
      ASSERT_LE(apart(0), near) << pair;
    }
    if (hit->t > 0) {
      ASSERT_LE(std::abs(closest(a.shape, pose_at(pose_a, of_a, hit->t), hit->point).distance), near) << pair;
    }
  });
  EXPECT_GT(hits, 20);
  EXPECT_GT(misses, 40);
}

TEST(PlaneCast, TranslationsHitAtTheFirstContact) { expect_first_contacts(false); }

/// Bit for bit, though a cast of two shapes that do not turn and begin apart has a way of its own.
template <class T>
void expect_casts_are_the_first_of_all() {
  std::mt19937 random(17);
  std::uniform_real_distribution<T> uniform(-1, 1);
  const auto size = [&] { return T(0.6) + T(0.4) * uniform(random); };
  const auto shape = [&]() -> Shape<T> {
    const T s = size(), other = size(), rounding = random() % 2 ? T(0.1) : T(0);
    switch (random() % 5) {
    case 0: return Circle<T>(s);
    case 1: return Shape<T>(Box<T>({s, other}), rounding);
    case 2: return Capsule<T>(s, other / 2);
    case 3: return Shape<T>(Segment<T>({-s, 0}, {s, other}), rounding);
    default:
      return Shape<T>(ConvexPolygon<T>(std::vector<Vec2<T>>{{s, 0}, {0, other}, {-s, 0}, {0, -s}, {s, -s}}), rounding);
    }
  };
  int hits = 0, misses = 0;
  for (int round = 0; round < 4000; ++round) {
    const Shape<T> a = shape(), b = shape();
    const Pose2<T> pose_a = converted<T>(random_pose<T>(1, random));
    Pose2<T> pose_b = converted<T>(random_pose<T>(1, random));
    pose_b.translation = pose_a.translation + pose_b.translation * (T(4) / length(pose_b.translation));
    const Vec2<T> way = (pose_a.translation - pose_b.translation) * T(2);
    const T x = uniform(random), y = uniform(random);
    const Velocity<T> of_a{{x, y}, 0}, of_b{way + Vec2<T>{-way.y, way.x} * (y / 2), 0};
    constexpr T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const T durations[] = {1, 1, 1, 1, 1, 0, inf, nan}, duration = durations[round % 8];
    const auto hit = cast<T>(a, pose_a, of_a, b, pose_b, of_b, duration);
    std::vector<CastHit<T>> all;
    cast_all<T>(a, pose_a, of_a, b, pose_b, of_b, duration, all);
    ASSERT_EQ(hit.has_value(), !all.empty()) << round;
    ++(hit ? hits : misses);
    if (!hit) continue;
    ASSERT_EQ(hit->t, all[0].t) << round;
    ASSERT_EQ(hit->point, all[0].point) << round;
    ASSERT_EQ(hit->normal, all[0].normal) << round;
    ASSERT_EQ(hit->depth, all[0].depth) << round;
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(misses, 1000);
}
TEST(PlaneCast, IsTheFirstOfAllContacts) {
  expect_casts_are_the_first_of_all<float>();
  expect_casts_are_the_first_of_all<double>();
}

TEST(PlaneCast, TurningBodiesHitAtTheFirstContact) { expect_first_contacts(true); }

/// Half-planes that turn, as A and as B, by up to half a turn: shapes are apart before a hit and touch there, and those
/// that are not hit never touch.
TEST(PlaneCast, TurningHalfPlanesAreNeitherMissedNorPassed) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> u(-1, 1);
  int hits = 0, misses = 0;
  for (int round = 0; round < 60 * figure_kinds; ++round) {
    const double scale = round % 3 == 0 ? 1e-3 : round % 3 == 1 ? 1 : 1e4;
    const auto figure = random_figure<double>(round % figure_kinds, scale, random);
    const Shaped ground{HalfPlane<double>(), round % 4 == 0 ? 0.2 * scale : 0};
    const Pose2d pose_g = random_pose<double>(scale, random), pose_f = random_pose<double>(3 * scale, random);
    const double turn = round % 5 == 0 ? 0.3 : 3;
    Velocity<double> of_g, of_f;
    of_g = {{scale * u(random), 0}, turn * u(random)};
    of_f = {{0, scale * u(random)}, round % 2 == 0 ? 0 : 4 * u(random)};
    const bool swapped = round % 7 < 3;
    const auto hit = swapped ? cast<double>(figure.shape, pose_f, of_f, ground, pose_g, of_g, 1)
                             : cast<double>(ground, pose_g, of_g, figure.shape, pose_f, of_f, 1);
    const auto apart = [&](double t) {
      return distance(ground, pose_at(pose_g, of_g, t), figure.shape, pose_at(pose_f, of_f, t)).distance;
    };
    const double near = 10 * cast_tolerance<double> * scale, until = hit ? hit->t : 1;
    ++(hit ? hits : misses);
    for (int k = 0; k < 4 * looks; ++k)
      if (!hit || hit->t > 0) {
        ASSERT_GT(apart(until * k / (4 * looks)), 0) << round << " at " << until * k / (4 * looks);
      }
    if (!hit) continue;
    ASSERT_EQ(hit->status, Status::converged) << round;
    ASSERT_LE(apart(hit->t), near) << round;
    if (hit->t > 0) {
      ASSERT_NEAR(apart(hit->t), 0, near) << round;
    }
  }
  EXPECT_GT(hits, 200);
  EXPECT_GT(misses, 80);
}

/// Half of the pairs start in contact. Where separating ones are ignored, no hit means that nothing got deeper than it
/// was at the start by more than it may sink, and a hit that it did, from that time on.
void expect_pressing_only(bool turning) {
  int hits = 0, slides = 0, later = 0, i = 0;
  for_moving_pairs(turning, [&](const auto& a, const auto& pose_a, const auto& of_a, const auto& b,
                                const auto& pose_of_b, const auto& of_b, double scale) {
    Pose2d pose_b = pose_of_b;
    if (++i % 2 == 0) {
      const auto d = distance(a.shape, pose_a, b.shape, pose_b);
      pose_b.translation += d.normal * ((i % 4 == 0 ? -0.01 * scale : 0) - d.distance);
    }
    const auto depth_at = [&](double t) {
      return -distance(a.shape, pose_at(pose_a, of_a, t), b.shape, pose_at(pose_b, of_b, t)).distance;
    };
    const double size = std::max(extent(a.shape), extent(b.shape)), near = 10 * cast_tolerance<double> * size;
    const double start = std::max(depth_at(0), 0.0);
    const double may_sink = 1.5 * sinking * cast_tolerance<double> * size;
    const std::string pair = std::string(a.shape.name()) + " and " + b.shape.name() + " of " + std::to_string(scale);
    const auto hit = cast<double>(a.shape, pose_a, of_a, b.shape, pose_b, of_b, 1, CastOptions{Separating::ignored});
    double deepest = 0;
    for (int k = 0; k <= looks; ++k) {
      const double t = double(k) / looks, depth = depth_at(t);
      if (!hit || t < hit->t) {
        ASSERT_LE(depth, start + (hit ? near : may_sink)) << pair << " at " << t;
      } else {
        deepest = std::max(deepest, depth);
      }
    }
    if (!hit) return static_cast<void>(++slides);
    ++hits;
    later += hit->t > 0;
    EXPECT_EQ(hit->status, Status::converged) << pair;
    if (hit->t > 0) {
      EXPECT_LE(depth_at(hit->t), start + near) << pair;
    }
  });
  EXPECT_GT(hits, 100);
  EXPECT_GT(later, 15);
  EXPECT_GT(slides, 100);
}
TEST(PlaneCast, IgnoresSeparatingTranslations) { expect_pressing_only(false); }
TEST(PlaneCast, IgnoresSeparatingBodiesThatTurn) { expect_pressing_only(true); }

/// A box slides over a chain's seams and along a wall, and is stopped by a step.
TEST(PlaneCast, SlidesOverSeams) {
  const CastOptions ignored{Separating::ignored};
  const std::vector<Vec2d> points{{-5, 0}, {-1, 0}, {0, 0}, {2, 0}, {2, 0.25}, {5, 0.25}};
  const Shaped chain = Chain<double>(points), box = Box<double>({1, 1});
  for (const double y : {0.5, 0.5 - 1e-7, 0.5 + 1e-13}) {
    const auto flat = cast<double>(chain, {}, {}, box, {{-3, y}, {}}, {{4, 0}, 0}, 1, ignored);
    EXPECT_FALSE(flat) << y;
    const auto step = cast<double>(chain, {}, {}, box, {{-3, y}, {}}, {{8, 0}, 0}, 1, ignored);
    ASSERT_TRUE(step) << y;
    EXPECT_NEAR(step->t, 4.5 / 8, 1e-8);
    EXPECT_NEAR(step->normal.x, -1, 1e-9);
    EXPECT_FALSE(cast<double>(chain, {}, {}, box, {{-3, y}, {}}, {{1, 3}, 0}, 1, ignored));
    const auto down = cast<double>(chain, {}, {}, box, {{-3, y}, {}}, {{1, -3}, 0}, 1, ignored);
    ASSERT_TRUE(down);
    EXPECT_LT(down->t, 1e-12);
  }
}

/// Each segment beside a vertex leaves a thin body that stands over it to one side; the chain does not.
template <class T>
void expect_no_sliding_into_seams() {
  const std::vector<Vec2<T>> points{{-2, 0}, {-1, 0}, {0, 0}, {1, T(0.5)}, {2, T(0.5)}};
  const Shape<T> thin[] = {Segment<T>({0, T(-0.5)}, {0, T(0.5)}), Box<T>({0, 1}), Box<T>({T(1e-5), 1}),
                           Capsule<T>(1, 0, 0), Box<T>({T(1e-3), 1})};
  const Shape<T> chain = Chain<T>(points);
  for (const Shape<T>& body : thin)
    for (const T above : {T(0), T(1e-6), T(0.5)})
      for (const std::size_t i : {1u, 2u, 3u}) {
        const Pose2<T> pose{points[i] + Vec2<T>{T(0), T(0.5) + above}, {}};
        const auto hit = cast<T>(chain, {}, {}, body, pose, {{0, T(-1)}, 0}, T(1), CastOptions{Separating::ignored});
        ASSERT_TRUE(hit) << body.name() << " above " << above << " at vertex " << i;
        EXPECT_NEAR(hit->t, above, 2e-3);
      }
}
TEST(PlaneCast, ThinBodiesDoNotSlideIntoSeams) {
  expect_no_sliding_into_seams<float>();
  expect_no_sliding_into_seams<double>();
}

/// A solid arch is cut where its top has vertices over those of its opening: what falls edgewise into the plane of a
/// cut is stopped by the top as elsewhere, at rest upon it and from above, turning or not.
template <class T>
void expect_no_falling_into_cuts() {
  const Shape<T> arch = Polygon<T>(std::vector<Vec2<T>>{{-2, -2},
                                                        {T(-0.5), -2},
                                                        {T(-0.5), -1},
                                                        {T(0.5), -1},
                                                        {T(0.5), -2},
                                                        {2, -2},
                                                        {2, 0},
                                                        {T(0.5), 0},
                                                        {T(-0.5), 0},
                                                        {-2, 0}});
  for (const Separating separating : {Separating::hit, Separating::ignored})
    for (const T height : {T(1), T(0.01)})
      for (const T width : {T(0), T(1e-3)})
        for (const T above : {T(0), T(1e-7), T(0.3)})
          for (const T angular : {T(0), T(1e-3)})
            for (const T x : {T(0.5), T(0.5) + width / 2, T(-0.5), T(0.3)}) {
              const T half = height / 2;
              const Shape<T> falling =
                  width > 0 ? Shape<T>(Box<T>({width, height})) : Shape<T>(Segment<T>({0, -half}, {0, half}));
              const auto hit =
                  cast<T>(arch, {}, {}, falling, {{x, half + above}, {}}, {{0, -3}, angular}, T(1), {separating});
              ASSERT_TRUE(hit) << height << " x " << width << " at " << x << ", " << above << " above";
              ASSERT_NEAR(hit->t, above / 3, 1e-3);
            }
}
TEST(PlaneCast, ThinBodiesDoNotFallIntoCutsOfPolygons) {
  expect_no_falling_into_cuts<float>();
  expect_no_falling_into_cuts<double>();
}

/// Polygons that spin several times on their way, from near and from far away: where both turn at the same rate about
/// each other nothing helps but small steps, and all else must not pass a corner that comes round.
TEST(PlaneCast, SpinningPolygonsAreNeitherMissedNorPassed) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> u(-1, 1);
  int hits = 0, misses = 0;
  for (int round = 0; round < 120; ++round) {
    const auto shape = [&]() -> Shaped {
      if (round % 3 == 0) return {Box<double>({0.2 + std::abs(u(random)), 2}), round % 2 ? 0.1 : 0};
      std::vector<Vec2d> points;
      for (int i = 0; i < 5; ++i) points.push_back({u(random), u(random)});
      return ConvexPolygon<double>(points);
    };
    const Shaped a = shape(), b = shape();
    const double far = round % 4 == 0 ? 1e6 : 4, spin = round % 5 == 0 ? 40 : 6;
    // B passes A's origin by less than both reach, in the middle of the time.
    const Vec2d way = rotate(Rot2<double>::from_angle(3 * u(random)), {2 * far, 0});
    const Vec2d start = way * -0.5 + left(normalized(way)) * (2 * u(random));
    const Velocity<double> of_a{{}, spin * u(random)}, of_b{way, spin * u(random)};
    const Pose2d pose_a{{}, Rot2<double>::from_angle(u(random))}, pose_b{start, Rot2<double>::from_angle(u(random))};
    const auto hit = cast(a, pose_a, of_a, b, pose_b, of_b, 1.0);
    ++(hit ? hits : misses);
    const auto apart = [&](double t) {
      return distance(a, pose_at(pose_a, of_a, t), b, pose_at(pose_b, of_b, t)).distance;
    };
    const double near = far < 10 ? 1e-8 : 1e-6;
    if (hit) {
      ASSERT_EQ(hit->status, Status::converged) << round;
      ASSERT_NEAR(apart(hit->t), 0, near) << round;
    }
    // The time in which they are near each other, and no further than to the hit.
    const double from = 0.5 - 2.5 / far, until = hit ? hit->t : 0.5 + 2.5 / far;
    for (int k = 0; k < 300; ++k)
      if (const double t = from + (until - from) * k / 300; t >= 0 && t < until) {
        ASSERT_GT(apart(t), -near) << round << " at " << t;
      }
  }
  EXPECT_GT(hits, 40);
  EXPECT_GT(misses, 20);
}

/// A point at its body's origin that turns has no reach, and is met as one that does not turn.
TEST(PlaneCast, PointsThatTurnAreNotMissed) {
  const Shape<double> carried(Compound<double>({{Circle<double>(1), {{-2, 0}, {}}}})), point(Circle<double>(0));
  const Velocity<double> turning{{}, -3};
  for (const double spin : {0.0, 2.0, -5.0}) {
    const auto hit = cast(carried, Pose2<double>{}, turning, point, {{1, 2}, {}}, {{}, spin}, 1.0);
    ASSERT_TRUE(hit) << spin;
    EXPECT_NEAR(hit->t, std::acos(-1) / 6, 1e-8) << spin;
  }
}

TEST(PlaneCast, KnownTimes) {
  const Shaped box = Box<double>({2, 2}), circle = Circle<double>(0.5);
  const auto hit = cast<double>(box, {}, {}, circle, {{5.5, 0.5}, {}}, {{-8, 0}, 0}, 1);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 0.5);
  EXPECT_EQ(hit->normal, (Vec2d{1, 0}));
  EXPECT_FALSE(cast<double>(box, {}, {}, circle, {{5.5, 1.6}, {}}, {{-9, 0}, 0}, 1));
  // End on: two segments on one line.
  const Shaped piece = Segment<double>({-1, 0}, {1, 0});
  const auto met = cast<double>(piece, {}, {}, piece, {{5, 0}, {}}, {{-6, 0}, 0}, 1);
  ASSERT_TRUE(met);
  EXPECT_NEAR(met->t, 0.5, 1e-15);
}

TEST(PlaneRaycast, HitsAreOnTheSurfaceAndFirst) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int hits = 0;
  for (const double scale : {1e-4, 1.0, 1e5})
    for (int round = 0; round < 120; ++round)
      for (int kind = 0; kind < figure_kinds; ++kind) {
        const auto figure = random_figure<double>(kind, scale, random);
        const Pose2d pose = random_pose<double>(scale, random);
        const Ray<double> ray{{4 * scale * uniform(random), 4 * scale * uniform(random)},
                              {uniform(random), uniform(random)}};
        const auto hit = raycast(figure.shape, pose, ray, 8 * scale);
        const Vec2d along = normalized(ray.direction);
        const auto apart = [&](double t) { return closest(figure.shape, pose, ray.origin + along * t).distance; };
        const double until = hit ? hit->t : 8 * scale;
        for (int k = 0; k < looks; ++k)
          if (!hit || hit->t > 0) {
            ASSERT_GT(apart(until * k / looks), 0) << figure.shape.name();
          }
        if (!hit) continue;
        ++hits;
        if (hit->t == 0) {
          ASSERT_LE(apart(0), 0);
          continue;
        }
        ASSERT_NEAR(apart(hit->t), 0, 4 * tolerance<double> * scale) << figure.shape.name();
        ASSERT_LE(dot(hit->normal, along), 1e-7) << figure.shape.name();
      }
  EXPECT_GT(hits, 150);
}

/// Without a length a ray goes on for ever; what it passes by it misses.
TEST(PlaneRaycast, AnEndlessRayMissesWhatItPasses) {
  std::mt19937 random(5);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Shape<double> shape = random_figure<double>(i % figure_kinds, 1, random).shape;
    const Pose2d pose = random_pose<double>(1, random);
    const Ray<double> ray{random_pose<double>(4, random).translation, random_pose<double>(1, random).translation};
    const auto endless = raycast(shape, pose, ray), long_enough = raycast(shape, pose, ray, 1000.0);
    ASSERT_EQ(endless.has_value(), long_enough.has_value()) << shape.name();
    if (!endless) continue;
    ++hits;
    EXPECT_EQ(endless->t, long_enough->t);
  }
  EXPECT_GT(hits, 20);
  EXPECT_LT(hits, 360);
}

TEST(PlaneRaycast, ThroughEveryCornerOfAPolygon) {
  std::vector<Vec2d> points;
  for (int i = 0; i < 7; ++i) points.push_back({std::cos(0.9 * i), std::sin(0.9 * i)});
  const ConvexPolygon<double> polygon(points);
  for (const Vec2d& corner : polygon.vertices())
    for (const double angle : {0.0, 0.3, -0.3}) {
      const Vec2d from = rotate(Rot2<double>::from_angle(angle), corner) * 3.0;
      const auto hit = raycast<double>(polygon, {}, {from, corner - from});
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->t, length(corner - from), 1e-12);
    }
}

TEST(PlaneCompound, DeepNestingNeedsNoStack) {
  Shaped nested = Box<double>({1, 1});
  for (int i = 0; i < 20000; ++i) nested = Compound<double>({{nested, {{0.0001, 0}, {}}}});
  const Shaped beside = nested;
  EXPECT_NEAR(distance(nested, {}, beside, {{4, 0}, {}}).distance, 3, 1e-9);
  Manifolds<double> manifolds;
  contacts(nested, {}, beside, {{0, 0.75}, {}}, 0.0, manifolds);
  ASSERT_EQ(manifolds.size(), 1u);
  EXPECT_EQ(manifolds[0].points.size(), 2u);
  const auto met = cast<double>(nested, {}, {}, beside, {{9, 0}, {}}, {{-16, 0}, 0}, 1);
  ASSERT_TRUE(met);
  EXPECT_NEAR(met->t, 0.5, 1e-8);
}

TEST(PlaneCompound, AnswersAsItsChildren) {
  const Shaped two = Compound<double>({{Box<double>({1, 1}), {{-3, 0}, {}}}, {Circle<double>(1), {{3, 0}, {}}}});
  EXPECT_EQ(closest<double>(two, {}, {3, 2}).distance, 1);
  EXPECT_EQ(closest<double>(two, {}, {-3, 0.25}).distance, -0.25);
  const auto hit = raycast<double>(two, {}, {{3, 5}, {0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->piece, 1u);
  EXPECT_EQ(hit->t, 4);
  const auto met = cast<double>(two, {}, {}, Circle<double>(0.5), {{-3, 5}, {}}, {{0, -8}, 0}, 1);
  ASSERT_TRUE(met);
  EXPECT_EQ(met->t, 0.5);
  EXPECT_EQ(met->piece_a, 0u);
}

}  // namespace
}  // namespace graze::plane
