// The descent on closed forms against GJK and EPA, and its proof against directions at random.
#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "narrow/depth/depth_certificate.hpp"
#include "narrow/depth/newton_depth.hpp"
#include "narrow/gjk/epa.hpp"
#include "narrow/gjk/gjk.hpp"

namespace graze::testing {
namespace {

constexpr Kind summed_kinds[] = {Kind::capsule, Kind::box, Kind::cylinder, Kind::ellipsoid};

struct DirectPair {
  Shaped a, b;
  Posed pose;
  ShapeCore<double> core_a{a}, core_b{b};
  MinkowskiDifference<ShapeCore<double>, ShapeCore<double>> difference{core_a, core_b, pose};

  DirectPair(const Specimen& sa, const Specimen& sb, const Posed& b_in_a)
      : a(build<double>(sa)), b(build<double>(sb)), pose(b_in_a) {}
  double overlap_along(const Vec3d& n) const { return -dot(difference.support(n).w, n); }
  std::optional<NewtonDepth> direct(double limit, Isa level = chosen_isa()) const {
    return GRAZE_KERNEL(level, newton_depth)(*core_a.summed(), *core_b.summed(), pose, limit);
  }
};

/// Calls `check` with many pairs of a round shape and any, some apart, some deep in each other.
template <class Check>
void for_round_pairs(std::uint64_t seed, int count, float spread, const Check& check) {
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const Kind a = i % 2 ? Kind::cylinder : Kind::ellipsoid, b = summed_kinds[random() % std::size(summed_kinds)];
    const DirectPair pair(
        random_specimen(a, 1, random), random_specimen(b, 1, random),
        {converted<double>(random_vector(random, spread)), normalized(converted<double>(random_rotation(random)))});
    check(pair, random);
  }
}

TEST(NewtonDepth, IsThatOfTheExpandingPolytope) {
  int overlapping = 0, answered = 0;
  for_round_pairs(1, 4000, 0.7f, [&](const DirectPair& pair, Random&) {
    const double size = pair.difference.size();
    const GjkResult g = gjk(pair.difference, {1e-13 * size});
    if (g.end != GjkEnd::touching) return;
    ++overlapping;
    const auto found = pair.direct(1e300);
    if (!found || found->lower < found->depth - 1e-11 * size) return;
    ++answered;
    EXPECT_NEAR(found->depth, epa(pair.difference, g.simplex, 1e-11 * size).upper, 1e-10 * size);
    EXPECT_NEAR(found->depth, pair.overlap_along(found->normal), 1e-13 * size);
    EXPECT_LT(length(found->b - found->a + found->normal * found->depth), 1e-10 * size);
  });
  EXPECT_GT(overlapping, 1000);
  EXPECT_GT(answered, overlapping * 92 / 100) << overlapping - answered << " of " << overlapping;
}

TEST(NewtonDepth, NoDirectionHasLessThanIsProven) {
  for_round_pairs(2, 1000, 0.5f, [&](const DirectPair& pair, Random& random) {
    const auto found = pair.direct(1e300);
    if (!found || found->depth < 0) return;
    for (int i = 0; i < 200; ++i) {
      // Half of them near the normal that was found, where little more is the rule.
      const Vec3d any = converted<double>(random_vector(random, 1));
      const Vec3d n = normalized(i % 2 ? any : found->normal + any * 0.1);
      EXPECT_GE(pair.overlap_along(n), found->lower - 1e-13 * pair.difference.size());
    }
  });
}

TEST(NewtonDepth, EveryLevelGivesTheSameBits) {
  for_round_pairs(5, 1000, 0.9f, [&](const DirectPair& pair, Random&) {
    const auto first = pair.direct(1e300, Isa::baseline);
    for (const Isa level : {Isa::avx2, Isa::avx512}) {
      if (!isa_available(level)) continue;
      const auto found = pair.direct(1e300, level);
      ASSERT_EQ(found.has_value(), first.has_value());
      if (!found) continue;
      EXPECT_EQ(found->normal, first->normal);
      EXPECT_EQ(found->depth, first->depth);
      EXPECT_EQ(found->a, first->a);
      EXPECT_EQ(found->b, first->b);
      EXPECT_EQ(found->lower, first->lower);
    }
  });
}

TEST(NewtonDepth, DistancesAreThoseOfGjk) {
  int apart = 0, answered = 0;
  for_round_pairs(3, 2000, 2.5f, [&](const DirectPair& pair, Random&) {
    const double size = pair.difference.reach();
    const GjkResult g = gjk(pair.difference, {1e-13 * size});
    if (g.end == GjkEnd::touching || g.lower < 1e-6) return;
    ++apart;
    const auto found = pair.direct(std::numeric_limits<double>::infinity());
    if (!found) return;
    ++answered;
    // Rounding may shorten the way to a flat simplex to less than what a direction proves.
    EXPECT_NEAR(-found->depth, greatest(g.upper, g.lower), 1e-11 * size);
    EXPECT_LT(length(found->b - found->a + found->normal * found->depth), 1e-10 * size);
    // A limit ends the descent at a direction that does separate by more.
    const auto soon = pair.direct(g.upper / 2);
    ASSERT_TRUE(soon);
    EXPECT_GT(-soon->depth, g.upper / 2);
    EXPECT_NEAR(soon->depth, pair.overlap_along(soon->normal), 1e-13 * size);
  });
  EXPECT_GT(apart, 1000);
  EXPECT_GT(answered, apart * 95 / 100);
}

constexpr Isa levels[] = {Isa::baseline, Isa::avx2, Isa::avx512};

/// Whether the overlap is proven the least, and what is in doubt: the same at every level of the instruction set.
bool proven(const PolarTerms& terms) {
  PolarDoubt first;
  const bool least = GRAZE_KERNEL(Isa::baseline, no_less_around)(terms, first);
  for (const Isa level : levels) {
    if (!isa_available(level)) continue;
    PolarDoubt doubt;
    EXPECT_EQ(GRAZE_KERNEL(level, no_less_around)(terms, doubt), least);
    EXPECT_EQ(doubt.t.u, first.t.u);
    EXPECT_EQ(doubt.t.v, first.t.v);
    EXPECT_EQ(doubt.s, first.s);
  }
  return least;
}

/// The sum of `depth_certificate.hpp`, by its formulas.
double sum_at(const PolarTerms& terms, const PolarTangent& t, double s) {
  const auto along = [&](const PolarTangent& x) { return x.u * t.u + x.v * t.v; };
  double sum = -terms.depth * s * s + (terms.cap + along(terms.cap_slope)) * s;
  for (const PolarTerms::Crease& c : terms.creases) sum += s * (along(c.axis) > 0 ? c.up : -c.down) * along(c.axis);
  for (const PolarTerms::Segment& p : terms.segments)
    sum += p.half * greatest(0.0, p.along * (s * s - 1) - 2 * s * along(p.axis));
  for (const PolarTerms::Round& r : terms.rounds) {
    const TangentForm& f = r.across;
    const double x = r.extent * (1 - s * s) + 2 * s * along(r.point);
    const double y_squared = 4 * s * s * (f.uu * t.u * t.u + 2 * f.uv * t.u * t.v + f.vv * t.v * t.v);
    sum += (std::sqrt(x * x + y_squared) - x) / 2;
  }
  return sum;
}

/// Directions all around, those nearest to n included.
bool none_less_on_grid(const PolarTerms& terms) {
  constexpr int turns = 128, steps = 60;
  for (int i = 0; i < turns; ++i)
    for (int k = 0; k < steps; ++k) {
      const double angle = 2 * 3.14159265358979 * i / turns, s = std::exp(0.25 * (k - 36));
      if (sum_at(terms, {std::cos(angle), std::sin(angle)}, s) < -1e-14 * (1 + s * s)) return false;
    }
  return true;
}

// A point near the middle of an ellipsoid that is 1 wide and `low` high: straight up is the shortest way out, sideways
// is stationary and not. In the middle itself down were as good.
TEST(DepthCertificate, TellsTheLeastFromTheStationary) {
  constexpr double low = 0.2;
  PolarTerms up{0.9 * low};
  up.rounds.push_back({low, {0, 0}, {1, 0, 1}});
  EXPECT_TRUE(proven(up));
  PolarTerms sideways{0.9};
  sideways.rounds.push_back({1, {0, 0}, {1, 0, low * low}});
  EXPECT_FALSE(proven(sideways));
}

// A point on the axis of a box of half edges 1 and of a half thickness: straight up.
TEST(DepthCertificate, ASlabIsLeftThroughItsFace) {
  for (const double thickness : {0.1, 0.9, 1.2, 2.0}) {
    PolarTerms terms{0.9 * thickness};
    terms.creases.push_back({{1, 0}, 1, 1});
    terms.creases.push_back({{0, 1}, 1, 1});
    terms.segments.push_back({{0, 0}, 1, thickness});
    EXPECT_EQ(proven(terms), thickness <= 1) << thickness;
  }
}

// Terms as of cores that meet in all ways: by creases, by the face of a disc, or where both are smooth; and of each the
// greatest depth that is proven, beyond which a bound that were too good would lead.
TEST(DepthCertificate, NoDirectionHasLessWhereItHolds) {
  Random random(4);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(uniform(random, 0, 1));
  };
  const auto tangent = [&](double most) { return PolarTangent{between(-most, most), between(-most, most)}; };
  int deep = 0;
  for (int i = 0; i < 840; ++i) {
    PolarTerms terms{0};
    for (int k = 0; k < i % 3; ++k) terms.creases.push_back({tangent(0.7), between(0, 2), between(0, 2)});
    if (i % 7 == 0) {
      terms.cap = between(0, 1);
      terms.cap_slope = tangent(0.7 * terms.cap);
    }
    for (int k = 0; k < i % 4; ++k) terms.segments.push_back({tangent(0.7), k == 0 ? 0 : between(0, 1), between(0, 1)});
    for (int k = 0; k < i / 2 % 3; ++k) {
      const double extent = between(0.2, 2), across = between(0, 0.3);
      terms.rounds.push_back({extent, tangent(0.5), {between(0.3, 2), across, between(0.3, 2)}});
    }
    double holds = 0;
    for (double step = 1; step > 1e-3; step /= 2) {
      terms.depth = holds + step;
      if (proven(terms)) holds = terms.depth;
    }
    terms.depth = holds;
    EXPECT_TRUE(none_less_on_grid(terms)) << "set " << i << ", depth " << holds;
    deep += holds > 0.05;
  }
  EXPECT_GT(deep, 200);
}

// A form that bends less than the depth, and a segment across n too short to make up for it: already near n is less.
TEST(DepthCertificate, ASegmentAcrossTheNormalHidesNothing) {
  for (const double along : {1e-17, 0.0, -0.0}) {
    PolarTerms terms{0.32};
    terms.rounds.push_back({1, {0, 0}, {0.3, 0, 0.3}});
    terms.segments.push_back({{1, 0}, along, 0.01});
    EXPECT_FALSE(proven(terms)) << along;
  }
}

// A ball a little larger than the depth: nothing is in doubt, but to prove it takes more cells than are looked at.
TEST(DepthCertificate, IsGivenUpWithoutADoubtWhereItTakesTooLong) {
  PolarTerms terms{0.97};
  terms.rounds.push_back({1, {0, 0}, {1, 0, 1}});
  ASSERT_FALSE(proven(terms));
  PolarDoubt doubt;
  GRAZE_KERNEL(chosen_isa(), no_less_around)(terms, doubt);
  EXPECT_EQ(doubt.s, 0);
}

}  // namespace
}  // namespace graze::testing
