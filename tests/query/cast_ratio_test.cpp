// Casts of bodies of very different sizes, straight and turning, against a search for the first time of contact that
// knows nothing but the distance.
//
// A translation makes the signed distance a convex function of time: its least value is found by section, the time of
// contact by bisection. Bodies that turn are sampled. The distance is the library's, in double.
#include <gtest/gtest.h>

#include <cmath>

#include "common/asked_number.hpp"
#include "common/specimen.hpp"
#include "graze/cast.hpp"

namespace graze::testing {
namespace {

struct Moving {
  PlacedSpecimen placed;
  Velocity<float> velocity{};
  Shape<double> shape;
  double reach;

  Moving(const PlacedSpecimen& p, const Velocity<float>& v) : placed(p), velocity(v), shape(build<double>(p.specimen)) {
    reach = shape.rounding() + shape.visit([](const auto& c) {
      if constexpr (requires { c.core_radius(); })
        return c.core_extent() + c.core_radius();
      else
        return 0.0;
    });
  }
  template <class T>
  Velocity<T> velocity_in() const {
    return {converted<T>(velocity.linear), converted<T>(velocity.angular)};
  }
  Posed at(double t) const { return pose_at(pose_of<double>(placed), velocity_in<double>(), t); }
};

/// A large shape, and a small one some of its own sizes away that flies at a point of its surface.
std::pair<Moving, Moving> large_and_small(Kind ka, Kind kb, float ratio, bool turning, Random& random) {
  const auto point = [&](float reach) { return converted<double>(random_vector(random, reach)); };
  Moving a({random_specimen(ka, ratio, random), random_vector(random, ratio), random_rotation(random)}, {});
  Moving b({random_specimen(kb, 1, random), {}, random_rotation(random)}, {});
  const Shape<double> speck{Sphere<double>(0)};
  const Posed afar{a.at(0).translation + normalized(point(1), Vec3d{1, 0, 0}) * (10 * a.reach), {}};
  const Distance<double> seen = distance(a.shape, a.at(0), speck, afar);
  const Vec3d start = seen.a + (seen.normal * 1.2 + point(0.7f)) * (b.reach * 1.5);
  b.placed.translation = converted<float>(start);
  // Half of them go a few of their own sizes, half of them a few of the large one's.
  const double step = static_cast<double>(uniform(random, 2, 6) * (random() % 2 ? 1 : ratio)) * b.reach;
  const Vec3f common = random_vector(random, 1);
  a.velocity.linear = common;
  b.velocity.linear =
      common + converted<float>(normalized(seen.a + point(0.6f) * b.reach - start, Vec3d{1, 0, 0}) * step);
  if (turning) b.velocity.angular = random_vector(random, 6);
  return {a, b};
}

template <class T>
class RatioCase {
 public:
  RatioCase(const Moving& a, const Moving& b) : a_(a), b_(b) {
    const auto scale = [](double size) { return static_cast<double>(cast_tolerance<T>) * size; };
    const double path = length(converted<double>(b.velocity.linear)) + length(a.at(0).translation) + a.reach;
    tolerance_ = 4 * scale(least(a.reach, b.reach)) + 1e-9 * a.reach +
                 4 * static_cast<double>(std::numeric_limits<T>::epsilon()) * path;
    for (const Moving* m : {&a, &b})
      if (m->placed.specimen.kind == Kind::user) tolerance_ += 4 * scale(m->reach);
  }
  void check(bool swapped) {
    const auto plain = ask(Separating::hit, swapped), ignoring = ask(Separating::ignored, swapped);
    const double first = first_contact();
    ASSERT_TRUE(plain || first > 1) << "missed the hit at " << first << text();
    unknown = plain && plain->status != Status::converged;
    if (!plain || unknown) return;
    hits = 1;
    if (plain->t > T(0)) {
      ASSERT_NEAR(apart(static_cast<double>(plain->t)), 0, tolerance_) << plain->t << text();
    }
    if (first <= 1 && apart(0) > tolerance_ && least_ < -0.01 * b_.reach - 4 * tolerance_) {
      ASSERT_TRUE(ignoring) << "passed, " << least_ << " deep" << text();
      if (ignoring->status == Status::converged) {
        ASSERT_GE(ignoring->t, plain->t) << text();
        ASSERT_GE(apart(static_cast<double>(ignoring->t)), -tolerance_ - 0.01 * b_.reach) << ignoring->t << text();
      }
    }
  }
  int hits = 0, unknown = 0;

 private:
  std::optional<CastHit<T>> ask(Separating separating, bool swapped) const {
    const Moving &p = swapped ? b_ : a_, &q = swapped ? a_ : b_;
    return cast(build<T>(p.placed.specimen), pose_of<T>(p.placed), p.velocity_in<T>(), build<T>(q.placed.specimen),
                pose_of<T>(q.placed), q.velocity_in<T>(), T(1), CastOptions{separating});
  }
  double apart(double t) const { return distance(a_.shape, a_.at(t), b_.shape, b_.at(t)).distance; }

  /// A time at which they surely touch, the first that is found; 2 when there is none.
  double first_contact() {
    if (b_.velocity.angular != Vec3f{}) {
      double first = 2;
      for (int i = 0; i <= 200; ++i) {
        const double d = apart(i / 200.0);
        least_ = least(least_, d);
        if (d < -tolerance_) first = least(first, i / 200.0);
      }
      return first;
    }
    double low = 0, high = 1;
    for (int i = 0; i < 120; ++i) {
      const double p = low + (high - low) * 0.382, q = low + (high - low) * 0.618;
      (apart(p) < apart(q) ? high : low) = apart(p) < apart(q) ? q : p;
    }
    least_ = least(apart(low), least(apart(0), apart(1)));
    if (!(least_ < -tolerance_)) return 2;
    double before = 0, after = apart(low) == least_ ? low : apart(0) < apart(1) ? 0 : 1;
    for (int i = 0; i < 80; ++i) {
      const double middle = (before + after) / 2;
      (apart(middle) > 0 ? before : after) = middle;
    }
    return after;
  }
  std::string text() const {
    return " tolerance " + std::to_string(tolerance_) + "\n" + describe(a_.placed) + "\n" + describe(b_.placed);
  }

  const Moving &a_, &b_;
  double tolerance_, least_ = std::numeric_limits<double>::infinity();
};

template <class T>
void check_ratios(bool turning) {
  Random random(turning ? 8 : 7);
  const int count = asked_number("GRAZE_TEST_CASTS", 60) * 8;
  int asked = 0, hits = 0, unknown = 0;
  while (asked < count) {
    const auto kind = [&] { return static_cast<Kind>(random() % bounded_kinds); };
    const Kind ka = kind(), kb = kind();
    // Between a curved shape and one a thousand times as large the distance itself is not known to a billionth.
    if (std::is_same_v<T, double> && (curved(ka) || curved(kb))) continue;
    const float ratio = std::pow(10.0f, uniform(random, 0, 4));
    const auto [a, b] = large_and_small(ka, kb, ratio, turning, random);
    RatioCase<T> c(a, b);
    c.check(asked++ % 2 == 1);
    if (::testing::Test::HasFatalFailure()) return;
    hits += c.hits;
    unknown += c.unknown;
  }
  EXPECT_GT(hits, count / 2);
  EXPECT_LE(unknown, 1 + count / 500);
}

TEST(CastRatios, StraightInFloat) { check_ratios<float>(false); }
TEST(CastRatios, StraightInDouble) { check_ratios<double>(false); }
TEST(CastRatios, TurningInFloat) { check_ratios<float>(true); }
TEST(CastRatios, TurningInDouble) { check_ratios<double>(true); }

}  // namespace
}  // namespace graze::testing
