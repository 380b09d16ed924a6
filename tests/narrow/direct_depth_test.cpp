// The descent on closed forms against GJK and EPA, and its proof against directions at random.
#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "narrow/direct_depth.hpp"
#include "narrow/epa.hpp"
#include "narrow/gjk.hpp"
#include "narrow/polar_proof.hpp"

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
  auto direct(double limit) const {
    return GRAZE_KERNEL(chosen_isa(), direct_depth)(*core_a.summed(), *core_b.summed(), pose, limit);
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
        {cast<double>(random_vector(random, spread)), normalized(cast<double>(random_rotation(random)))});
    check(pair, random);
  }
}

TEST(DirectDepth, IsThatOfTheExpandingPolytope) {
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
  EXPECT_GT(answered, overlapping * 93 / 100) << overlapping - answered << " of " << overlapping;
}

TEST(DirectDepth, NoDirectionHasLessThanIsProven) {
  for_round_pairs(2, 1000, 0.5f, [&](const DirectPair& pair, Random& random) {
    const auto found = pair.direct(1e300);
    if (!found || found->depth < 0) return;
    for (int i = 0; i < 200; ++i) {
      // Half of them near the normal that was found, where little more is the rule.
      const Vec3d any = cast<double>(random_vector(random, 1));
      const Vec3d n = normalized(i % 2 ? any : found->normal + any * 0.1);
      EXPECT_GE(pair.overlap_along(n), found->lower - 1e-13 * pair.difference.size());
    }
  });
}

TEST(DirectDepth, DistancesAreThoseOfGjk) {
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

/// Whether the overlap is proven the least; at every level of the instruction set alike.
bool proven(const PolarTerms& terms) {
  PolarDoubt doubt;
  return GRAZE_KERNEL(chosen_isa(), no_less_around)(terms, doubt);
}

// A point near the middle of an ellipsoid that is 1 wide and `low` high: straight up is the shortest way out, sideways is
// stationary and not. In the middle itself down were as good.
TEST(PolarProof, TellsTheLeastFromTheStationary) {
  constexpr double low = 0.2;
  PolarTerms up{0.9 * low};
  up.rounds.push_back({low, {0, 0}, {1, 0, 1}});
  EXPECT_TRUE(proven(up));
  PolarTerms sideways{0.9};
  sideways.rounds.push_back({1, {0, 0}, {1, 0, low * low}});
  EXPECT_FALSE(proven(sideways));
}

// A point on the axis of a box of half edges 1 and of a half thickness: straight up.
TEST(PolarProof, ASlabIsLeftThroughItsFace) {
  for (const double thickness : {0.1, 0.9, 1.2, 2.0}) {
    PolarTerms terms{0.9 * thickness};
    terms.creases.push_back({{1, 0}, 1, 1});
    terms.creases.push_back({{0, 1}, 1, 1});
    terms.segments.push_back({{0, 0}, 1, thickness});
    EXPECT_EQ(proven(terms), thickness <= 1) << thickness;
  }
}

}  // namespace
}  // namespace graze::testing
