// The parts of the general path, each alone.
#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "narrow/gjk/epa.hpp"
#include "narrow/gjk/gjk.hpp"
#include "narrow/gjk/trace_recorder.hpp"

namespace graze::testing {
namespace {

Vec3d vector(Random& random, float reach) { return converted<double>(random_vector(random, reach)); }

/// The nearest point to the origin by brute force: a fine grid of barycentric weights.
double grid_distance(const Simplex& s, int steps) {
  double best = std::numeric_limits<double>::infinity();
  const int n = static_cast<int>(s.size());
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= (n > 1 ? steps - i : 0); ++j)
      for (int k = 0; k <= (n > 2 ? steps - i - j : 0); ++k) {
        const double h = 1.0 / steps;
        const double w[4] = {i * h, j * h, k * h, 1 - (i + j + k) * h};
        Vec3d p;
        double rest = 1;
        for (int m = 0; m < n; ++m) {
          const double weight = m + 1 == n ? rest : w[m];
          p += s.w(static_cast<std::size_t>(m)) * weight;
          rest -= weight;
        }
        best = std::min(best, length(p));
      }
  return best;
}

TEST(Simplex, NearestPointAgreesWithAGrid) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    Simplex s;
    const int size = 1 + i % 4;
    for (int k = 0; k < size; ++k) {
      const Vec3d w = vector(random, 1) + Vec3d{0.3, 0.2, 0.1};
      s.push({{}, w, w});
    }
    const double grid = grid_distance(s, 40);
    const Nearest nearest = nearest_to_origin(s);
    reduce(s, nearest);
    const double found = nearest.enclosed ? 0 : length(nearest.point);
    EXPECT_LE(found, grid + 1e-12);
    EXPECT_GE(found, grid - 0.1);  // the grid's step
    if (!nearest.enclosed) {
      double sum = 0;
      Vec3d p;
      for (std::size_t k = 0; k < s.size(); ++k) {
        EXPECT_GE(s.weight[k], 0);
        sum += s.weight[k];
        p += s.w(k) * s.weight[k];
      }
      EXPECT_GT(sum, 0);
      EXPECT_LT(length(p / sum - nearest.point), 1e-12);
    }
  }
}

TEST(Simplex, DegenerateOnesReduceToWhatTheyAre) {
  const Vec3d p{1, 2, 3};
  Simplex twice;
  twice.push({{}, p, p});
  twice.push({{}, p, p});
  EXPECT_EQ(nearest_to_origin(twice).point, p);
  Simplex line;
  for (const double x : {1.0, 2.0, 3.0}) line.push({{}, {x, 1, 0}, {x, 1, 0}});
  EXPECT_EQ(nearest_to_origin(line).point, (Vec3d{1, 1, 0}));
}

TEST(Gjk, BoundsHoldInEveryIteration) {
  const Shaped a = Ellipsoid<double>({1, 0.5, 0.3}), b = Cylinder<double>(1, 0.7);
  const ShapeCore<double> ca(a), cb(b);
  const MinkowskiDifference difference(ca, cb, {{2, 1, 0.5}, normalized(Quatd{1, 2, 3, 4})});
  Trace trace;
  const GjkResult r = gjk(difference, {1e-12}, TraceRecorder(trace));
  ASSERT_EQ(r.end, GjkEnd::apart);
  ASSERT_FALSE(trace.gjk.empty());
  for (const TraceGjk& step : trace.gjk) {
    EXPECT_LE(step.lower, r.upper + 1e-12);
    EXPECT_GE(step.upper, r.lower - 1e-12);
  }
  EXPECT_LE(r.upper - r.lower, 1e-12);
}

// A polytope that holds the origin: what EPA calls the depth is the least of all facets' in the end.
TEST(Epa, PolytopeIsConvexAndHoldsTheOrigin) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Shaped a = build<double>(random_specimen(Kind::hull, 1, random)), b = Box<double>({1, 0.7, 0.4});
    const ShapeCore<double> ca(a), cb(b);
    const MinkowskiDifference difference(
        ca, cb, {vector(random, 0.1f), normalized(converted<double>(random_rotation(random)))});
    const GjkResult g = gjk(difference, {1e-13});
    if (g.end != GjkEnd::touching) continue;
    Trace trace;
    const EpaResult r = epa(difference, g.simplex, 1e-11, TraceRecorder(trace));
    const auto w = [&](std::size_t v) { return trace.polytope[v].b - trace.polytope[v].a; };
    double least_offset = std::numeric_limits<double>::infinity();
    for (const auto& t : trace.triangles) {
      const Vec3d n = normalized(cross(w(t[1]) - w(t[0]), w(t[2]) - w(t[0])), Vec3d{});
      if (n == Vec3d{}) continue;
      least_offset = std::min(least_offset, dot(n, w(t[0])));
      for (const auto& other : trace.triangles)
        for (const std::size_t v : other) EXPECT_LE(dot(n, w(v) - w(t[0])), 1e-9);
    }
    EXPECT_NEAR(least_offset, r.upper, 1e-9);
  }
}

// A support function that breaks its promise costs a bounded number of calls and gives finite numbers.
// The rim of a cylinder on the rim of a cone: the search may end at points some rounding apart, along any way.
TEST(Gjk, ATouchHasANormalAlongWhichTheShapesTouch) {
  const Shaped cylinder = Cylinder<double>(0.5, 1), cone = Cylinder<double>(0.5, 1, 0);
  const Posed at_cylinder{{1, -0.5, 1}, normalized(Quatd{1, 0, -1, 0})};
  const Posed at_cone{{2, 0, 1}, normalized(Quatd{1, 0, 1, 0})};
  const auto reach = [](const Shaped& shape, const Posed& pose, const Vec3d& n) {
    return dot(transform(pose, support(shape, rotate(conjugate(pose.rotation), n))), n);
  };
  const auto check = [&](const Shaped& a, const Posed& pose_a, const Shaped& b, const Posed& pose_b) {
    const Distance<double> d = distance(a, pose_a, b, pose_b);
    EXPECT_NEAR(d.distance, 0, 1e-12);
    EXPECT_NEAR(reach(a, pose_a, d.normal), dot(d.a, d.normal), 1e-6);
    EXPECT_NEAR(reach(b, pose_b, -d.normal), -dot(d.b, d.normal), 1e-6);
  };
  check(cylinder, at_cylinder, cone, at_cone);
  check(cone, at_cone, cylinder, at_cylinder);
}

TEST(Gjk, BrokenSupportFunctionsEndAllTheSame) {
  struct Broken final : SupportFunction<double> {
    mutable std::uint64_t state = 1;
    Vec3d support(const Vec3d&) const override {
      state = state * 6364136223846793005u + 1442695040888963407u;
      const auto part = [&](int shift) { return static_cast<double>((state >> shift) & 1023) / 512 - 1; };
      return {part(10), part(30), part(50)};
    }
  };
  const Shaped broken = UserConvex<double>(std::make_shared<Broken>());
  for (int i = 0; i < 100; ++i) {
    const Distance<double> d = distance<double>(broken, {}, Box<double>({1, 1, 1}), {{i * 0.03, 0.1, 0}, {}});
    EXPECT_TRUE(std::isfinite(d.distance));
    EXPECT_NEAR(length(d.normal), 1, 1e-12);
  }
}

}  // namespace
}  // namespace graze::testing
