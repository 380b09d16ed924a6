// Casts against extended precision: no contact is missed, none is late, and at a hit the shapes touch.
#include <gtest/gtest.h>

#include "plane/moving_figures.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneCastReference : public ::testing::Test {};
using CastScalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneCastReference, CastScalars);

/// How far a cast may be off, and a depth at its start: relative to the size of the pair.
template <class T>
constexpr double cast_error = 1e-8;
template <>
constexpr double cast_error<float> = 2e-5;
template <class T>
constexpr double start_error = 1e-11;
template <>
constexpr double start_error<float> = 4e-6;

struct CastCounts {
  int hits = 0, at_start = 0, misses = 0, not_proven = 0;
};

/// How far places on the way of a pair, and times, may be rounded.
template <class T>
Wide rounding_of_way(const MovingFigures<T>& moving, Wide between) {
  return 2 * Wide(std::numeric_limits<T>::epsilon()) * (moving.way() + between);
}

/// A cast from time 0 to 1, against the reference.
template <class T>
void expect_first_contact(const Figure<T>& a, const Pose2<T>& pose_a, const Velocity<T>& of_a, const Figure<T>& b,
                          const Pose2<T>& pose_b, const Velocity<T>& of_b, CastCounts& counts) {
  const auto hit = cast<T>(a.shape, pose_a, of_a, b.shape, pose_b, of_b, T(1));
  const MovingFigures<T> moving(a, pose_a, of_a, b, pose_b, of_b);
  const Wide size = std::max(furthest_reach(a), furthest_reach(b)),
             rounding = rounding_of_way(
                 moving, std::hypot(moving.b_at(0).x - moving.a_at(0).x, moving.b_at(0).y - moving.a_at(0).y)),
             near = Wide(cast_error<T>) * size + rounding;
  if (hit && hit->t == 0) {
    ++counts.at_start;
    const Wide start = moving.distance_at(0);
    ASSERT_LE(double(start / size), double(near / size));
    ASSERT_NEAR(double((std::max(-start, Wide(0)) - Wide(hit->depth)) / size), 0, start_error<T>);
  } else {
    Wide met_at = 0;
    const Apart apart = moving.stay_apart(hit ? Wide(hit->t) : 1, near, met_at);
    ASSERT_NE(apart, Apart::met) << (hit ? "late, at " : "missed, at ") << double(met_at);
    counts.not_proven += apart == Apart::not_proven;
    ++(hit ? counts.hits : counts.misses);
    if (!hit) return;
    ASSERT_EQ(double(hit->depth), 0);
    ASSERT_NEAR(double(moving.distance_at(hit->t) / size), 0, double(near / size));
  }
  ASSERT_EQ(hit->status, Status::converged);
  // The normal is one along which they touch, and the point lies on both.
  const Wide t = hit->t, gap = moving.distance_at(t);
  ASSERT_NEAR(double((moving.separation_at(t, hit->normal) - gap) / size), 0, double(near / size));
  if (hit->t == 0) return;
  const Figure<T> spot{Circle<T>(0), [](Wide, Wide) { return Wide(0); }};
  const WidePose there{hit->point.x, hit->point.y};
  const Wide place = 2 * Wide(std::numeric_limits<T>::epsilon()) * std::hypot(there.x, there.y);
  ASSERT_NEAR(double(swept_distance(a, moving.a_at(t), spot, there) / size), 0, double((near + place) / size));
  ASSERT_NEAR(double(swept_distance(b, moving.b_at(t), spot, there) / size), 0, double((near + place) / size));
}

template <class T>
void expect_casts_as_by_reference(bool turning) {
  std::mt19937 random(turning ? 63 : 62);
  std::uniform_real_distribution<double> uniform(-1, 1);
  CastCounts counts;
  for (const double scale : {1e-4, 0.01, 1.0, 1e5})
    for (int i = 0; i < figure_kinds; ++i)
      for (int j = 0; j < figure_kinds; ++j) {
        const auto a = random_figure<T>(i, scale, random), b = random_figure<T>(j, scale, random);
        const Pose2<T> pose_a = random_pose<T>(scale, random), pose_b = random_pose<T>(2 * scale, random);
        const auto velocity = [&](const Pose2<T>& from, const Pose2<T>& to) {
          const Vec2<T> towards = to.translation - from.translation;
          const auto aside = [&] { return static_cast<T>(1.6 * scale * uniform(random)); };
          const T x = towards.x + aside(), y = towards.y + aside();
          return Velocity<T>{{x, y}, turning ? static_cast<T>(3 * uniform(random)) : T(0)};
        };
        const Velocity<T> of_a = velocity(pose_a, pose_b), of_b = velocity(pose_b, pose_a);
        expect_first_contact(a, pose_a, of_a, b, pose_b, of_b, counts);
        if (::testing::Test::HasFatalFailure())
          FAIL() << a.shape.name() << " and " << b.shape.name() << " of " << scale;
      }
  EXPECT_GT(counts.hits, 100);
  EXPECT_GT(counts.misses, 25);
  EXPECT_GT(counts.at_start, 15);
  EXPECT_LE(counts.not_proven, 3);
}

TYPED_TEST(PlaneCastReference, OfBodiesThatDoNotTurn) { expect_casts_as_by_reference<TypeParam>(false); }
TYPED_TEST(PlaneCastReference, OfBodiesThatTurn) { expect_casts_as_by_reference<TypeParam>(true); }

/// A half-plane below a line, and a figure: how far the figure is above it.
template <class T>
Wide height_above(const Figure<T>& figure, const WidePose& at, Wide rounding, const WidePose& ground) {
  const Wide x = -ground.sine, y = ground.cosine;
  return (at.x - ground.x) * x + (at.y - ground.y) * y - rounding -
         figure.reach(-(at.cosine * x + at.sine * y), -(at.cosine * y - at.sine * x));
}

TYPED_TEST(PlaneCastReference, OfHalfPlanes) {
  using T = TypeParam;
  std::mt19937 random(64);
  const auto number = [&](double scale) {
    return static_cast<T>(scale * std::uniform_real_distribution<double>(-1, 1)(random));
  };
  int hits = 0, misses = 0;
  for (int round = 0; round < 40 * figure_kinds; ++round) {
    const double scale = std::vector<double>{1e-4, 0.01, 1, 1e5}[round % 4];
    const auto figure = random_figure<T>(round / 4 % figure_kinds, scale, random);
    const T rounding = round % 5 == 0 ? static_cast<T>(0.2 * scale) : T(0);
    const Pose2<T> pose = random_pose<T>(3 * scale, random), pose_of_ground = random_pose<T>(scale, random);
    const bool turning = round % 3 != 0;
    const auto velocity = [&] {
      const T x = number(4 * scale), y = number(4 * scale);
      return Velocity<T>{{x, y}, turning ? number(3) : T(0)};
    };
    const Velocity<T> of_figure = velocity(), of_ground = velocity();
    const auto hit =
        cast<T>({HalfPlane<T>(), rounding}, pose_of_ground, of_ground, figure.shape, pose, of_figure, T(1));
    const auto distance_at = [&](Wide t) {
      return height_above(figure, wide_at(pose, of_figure, t), rounding, wide_at(pose_of_ground, of_ground, t));
    };
    // The half-plane has no end: how fast its boundary comes near depends on how far away the figure is.
    const Wide size = furthest_reach(figure), between = 5 * scale + 8 * scale, way = 12 * scale,
               speed = way + std::abs(Wide(of_figure.angular)) * size +
                       std::abs(Wide(of_ground.angular)) * (between + way + size),
               near = Wide(cast_error<T>) * size + 4 * Wide(std::numeric_limits<T>::epsilon()) * speed;
    if (hit && hit->t == 0) {
      ASSERT_LE(double(distance_at(0) / size), double(near / size)) << round;
      continue;
    }
    Wide met_at = 0;
    ASSERT_EQ(stay_apart([&](Wide t, Wide) { return distance_at(t); }, hit ? Wide(hit->t) : 1, speed, near, met_at),
              Apart::proven)
        << figure.shape.name() << ", " << (hit ? "late, at " : "missed, at ") << double(met_at);
    ++(hit ? hits : misses);
    if (!hit) continue;
    ASSERT_EQ(hit->status, Status::converged) << round;
    ASSERT_NEAR(double(distance_at(hit->t) / size), 0, double(near / size)) << figure.shape.name();
  }
  EXPECT_GT(hits, 40);
  EXPECT_GT(misses, 40);
}

}  // namespace
}  // namespace graze::plane
