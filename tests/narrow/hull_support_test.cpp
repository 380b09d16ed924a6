// Two small hulls, or one and another shape of few corners, by the kernel that scans both: what any two cores give, at
// every level of the instruction set; and GJK from four points against GJK from one; and their depth on lanes against
// that of the general EPA.
#include "narrow/core/hull_support.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <optional>

#include "common/specimen.hpp"
#include "narrow/core/scanned_shape.hpp"
#include "narrow/gjk/epa.hpp"
#include "narrow/gjk/gjk.hpp"
#include "narrow/gjk/hull_depth.hpp"

namespace graze::testing {
namespace {

/// A hull and another shape whose corners are scanned.
template <class T>
struct TwoHulls {
  TwoHulls(Random& random, int i)
      : TwoHulls(build<T>(random_specimen(i % 2 ? Kind::hull : other(i), 1, random)),
                 build<T>(random_specimen(i % 2 ? other(i) : Kind::hull, 1, random)), 1.5f, random) {}
  TwoHulls(const Shape<T>& first, const Shape<T>& second, float apart, Random& random)
      : a(first),
        b(second),
        pose{converted<double>(random_vector(random, apart)), normalized(converted<double>(random_rotation(random)))},
        core_a(a),
        core_b(b),
        cores(core_a, core_b, pose) {
    if (!scanned()) return;
    corners_a.emplace(a);
    corners_b.emplace(b);
  }

  bool scanned() const { return is_scannable(a) && is_scannable(b); }
  HullDifference<T> difference() const {
    return {corners_a->view(), corners_b->view(), greatest(corners_a->extent(), corners_b->extent()), pose};
  }

  static Kind other(int i) {
    static constexpr Kind kinds[] = {Kind::hull, Kind::box, Kind::triangle, Kind::capsule, Kind::sphere};
    return kinds[i / 2 % std::size(kinds)];
  }

  Shape<T> a, b;
  Posed pose;
  ShapeCore<T> core_a, core_b;
  MinkowskiDifference<ShapeCore<T>, ShapeCore<T>> cores;
  std::optional<ScannedShape<T>> corners_a, corners_b;
};

template <class T>
class HullDifferences : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(HullDifferences, Scalars);

/// A hull of so many points of a sphere, all of which are vertices.
template <class T>
Shape<T> round_hull(int count, Random& random) {
  std::vector<Vec3<T>> points;
  for (int k = 0; k < count; ++k) points.push_back(converted<T>(normalized(random_vector(random, 1))));
  return ConvexHull<T>(std::span<const Vec3<T>>(points));
}

TYPED_TEST(HullDifferences, AreThoseOfTheirCores) {
  using T = TypeParam;
  Random random(1);
  // Behind the others hulls of up to 64 vertices, of which one has few where the other has many.
  const auto two_hulls = [&](int i) {
    if (i < 100) return TwoHulls<T>(random, i);
    const Shape<T> first = round_hull<T>(i - 96, random), second = round_hull<T>(164 - i, random);
    return TwoHulls<T>(first, second, 1.5f, random);
  };
  for (int i = 0; i < 160; ++i) {
    const TwoHulls<T> two = two_hulls(i);
    EXPECT_TRUE(i < 100 || two.scanned());
    if (!two.scanned()) continue;
    const HullPair<T> pair = two.difference().hulls();
    for (std::size_t k = 0; k < 20; ++k) {
      Vec3d direction = converted<double>(random_vector(random, 1));
      if (k < 6) {  // across a box's edges
        direction = {};
        direction[k % 3] = k < 3 ? 1 : -1;
      }
      const SupportPoint expected = two.cores.support(direction);
      for (const Isa level : {Isa::baseline, Isa::avx2, Isa::avx512}) {
        if (!isa_available(level)) continue;
        SupportPoint found;
        GRAZE_KERNEL(level, hull_support<T>)(pair, direction, found);
        EXPECT_EQ(found.a, expected.a);
        EXPECT_EQ(found.b, expected.b);
        EXPECT_EQ(found.w, expected.w);
        PlacedVertices placed;
        GRAZE_KERNEL(level, place_vertices<T>)(pair, placed);
        GRAZE_KERNEL(level, placed_support<T>)(pair, placed, direction, found);
        EXPECT_EQ(found.a, expected.a);
        EXPECT_EQ(found.b, expected.b);
      }
    }
  }
}

TYPED_TEST(HullDifferences, AreAsFarFromFourPointsAsFromOne) {
  using T = TypeParam;
  Random random(2);
  int touching = 0, apart = 0;
  for (int i = 0; i < 500; ++i) {
    const TwoHulls<T> two(random, i);
    if (!two.scanned()) continue;
    HullDifference<T> difference = two.difference();
    const GjkGoal goal{1e-13 * difference.size()};
    const GjkResult one = gjk(two.cores, goal), four = gjk_spread(difference, goal);
    EXPECT_EQ(one.end == GjkEnd::touching, four.end == GjkEnd::touching);
    EXPECT_NEAR(one.upper, four.upper, 1e-12);
    EXPECT_LE(four.lower, one.upper + 1e-12);
    (one.end == GjkEnd::touching ? touching : apart) += 1;

    // Further apart than half of it: a bound will do, and holds.
    if (one.end == GjkEnd::touching) continue;
    const GjkResult proven = gjk_spread(difference, {goal.tolerance, one.upper / 2});
    EXPECT_GT(proven.lower, one.upper / 2);
    EXPECT_LE(proven.lower, one.upper + 1e-12);
    EXPECT_NEAR(dot(two.cores.support(proven.normal).w, proven.normal), proven.lower, 1e-12);
    EXPECT_NEAR(length(proven.normal), 1, 1e-14);
  }
  EXPECT_GT(touching, 20);
  EXPECT_GT(apart, 20);
}

struct Compared {
  int enclosed = 0, proven = 0;
};

/// The depth at every level against the general EPA's, where GJK leaves a tetrahedron about the origin.
template <class T>
void compare_depths(const TwoHulls<T>& two, Compared& compared) {
  if (!two.scanned()) return;
  HullDifference<T> difference = two.difference();
  const double tolerance = 1e-11 * difference.size(), noise = rounding_error * difference.reach();
  const GjkResult g = gjk_spread(difference, {tolerance});
  if (g.end != GjkEnd::touching || g.simplex.size() < 4) return;
  const EpaResult expected = epa(difference, g.simplex, tolerance);
  std::vector<EpaResult> at_levels;
  std::size_t levels = 0;
  for (const Isa level : {Isa::baseline, Isa::avx2, Isa::avx512}) {
    EpaResult found;
    if (!isa_available(level)) continue;
    ++levels;
    if (GRAZE_KERNEL(level, hull_depth<T>)(difference.hulls(), difference.placed(), g.simplex.points.data(), noise,
                                           tolerance, found))
      at_levels.push_back(found);
  }
  ++compared.enclosed;
  if (at_levels.empty()) return;
  ++compared.proven;
  EXPECT_EQ(at_levels.size(), levels);
  for (const EpaResult& found : at_levels) {
    EXPECT_EQ(found.upper, at_levels[0].upper);
    EXPECT_EQ(found.lower, at_levels[0].lower);
    EXPECT_EQ(found.normal, at_levels[0].normal);
    EXPECT_EQ(found.a, at_levels[0].a);
    EXPECT_EQ(found.b, at_levels[0].b);
    EXPECT_NEAR(found.upper, expected.upper, 2 * tolerance);
    EXPECT_LE(found.upper - found.lower, tolerance);
    EXPECT_NEAR(dot(two.cores.support(found.normal).w, found.normal), -found.upper, tolerance);
    EXPECT_LE(length(found.b - found.a + found.normal * found.upper), 100 * tolerance);
  }
}

TYPED_TEST(HullDifferences, AreAsDeepOnLanesAsByOneFacetAfterTheOther) {
  Random random(3);
  Compared compared;
  for (int i = 0; i < 1000; ++i) compare_depths(TwoHulls<TypeParam>(random, i), compared);
  EXPECT_GT(compared.enclosed, 50);
  EXPECT_GE(compared.proven, compared.enclosed * 9 / 10);
}

/// Round hulls, needles and discs about nearly one centre, whose polytopes have many points.
TYPED_TEST(HullDifferences, AreAsDeepOnLanesWhereThePolytopeGrows) {
  using T = TypeParam;
  Random random(7);
  const auto hull = [&] {
    const float wide = uniform(random, 0.02f, 1), high = uniform(random, 0.02f, 1);
    std::vector<Vec3<T>> points;
    const int count = random() % 2 == 0 ? 32 : 64;
    for (int k = 0; k < count; ++k) {
      const Vec3f p = normalized(random_vector(random, 1));
      points.push_back(converted<T>(Vec3f{p.x * wide, p.y * high, p.z}));
    }
    return Shape<T>(ConvexHull<T>(std::span<const Vec3<T>>(points)));
  };
  Compared compared;
  for (int i = 0; i < 500; ++i) compare_depths(TwoHulls<T>(hull(), hull(), 0.1f, random), compared);
  EXPECT_GT(compared.enclosed, 400);
  EXPECT_GE(compared.proven, compared.enclosed * 8 / 10);
}

/// Cones with a pebble about in their middle: an apex is seen from many facets, once in some hundred pairs from more
/// than a register holds.
TYPED_TEST(HullDifferences, AreAsDeepOnLanesWhereManyFacetsSeeAPoint) {
  using T = TypeParam;
  Random random(9);
  const auto hull_of = [&](const std::vector<Vec3f>& around) {
    std::vector<Vec3<T>> points;
    for (const Vec3f& p : around) points.push_back(converted<T>(p));
    return Shape<T>(ConvexHull<T>(std::span<const Vec3<T>>(points)));
  };
  Compared compared;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Vec3f> pebble, cone{{0, uniform(random, 0.3f, 2), 0}};
    for (int k = 0; k < 8; ++k) pebble.push_back(normalized(random_vector(random, 1)) * 0.05f);
    for (int k = 0; k < 31; ++k) {
      const Vec3f p = random_vector(random, 1);
      cone.push_back(normalized(Vec3f{p.x, 0, p.z}));
    }
    compare_depths(TwoHulls<T>(hull_of(pebble), hull_of(cone), 0.3f, random), compared);
  }
  EXPECT_GT(compared.enclosed, 1000);
  EXPECT_EQ(compared.proven, compared.enclosed);
}

}  // namespace
}  // namespace graze::testing
