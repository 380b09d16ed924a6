// The oracle against closed forms that use none of its code, and against itself
// where two of its methods are independent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numbers>
#include <random>

#include "certificate.hpp"

namespace graze::reference {
namespace {

constexpr Real tight = 1e-17L;  // the measured worst is a few 1e-18 of the size
constexpr Real infinity = std::numeric_limits<Real>::infinity();

// EXPECT_NEAR compares doubles.
testing::AssertionResult close(const char* xs, const char* ys, const char*, Real x, Real y, Real tolerance) {
  if (std::fabs(x - y) <= tolerance) return testing::AssertionSuccess();
  auto failure = testing::AssertionFailure();
  failure << std::setprecision(20) << xs << " = " << x << "\n" << ys << " = " << y << "\n";
  return failure << "they differ by " << x - y << ", tolerance " << tolerance;
}
#define EXPECT_CLOSE(x, y, tolerance) EXPECT_PRED_FORMAT3(close, x, y, tolerance)

// Not the standard distributions, whose sequence differs between libraries.
class Random {
 public:
  Real uniform(Real lo, Real hi) { return lo + (hi - lo) * static_cast<Real>(engine_() >> 11) * 0x1p-53L; }
  Real log_uniform(Real lo, Real hi) { return std::exp(uniform(std::log(lo), std::log(hi))); }
  Vector vector(Real r) {
    const Real x = uniform(-r, r), y = uniform(-r, r), z = uniform(-r, r);
    return {x, y, z};
  }
  Quaternion rotation() {
    const Real x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    return {x, y, z, uniform(-1, 1)};
  }
  Vector direction() { return normalized(vector(1)); }
  Shape hull(int count, Real r) {
    std::vector<Vector> v;
    for (int i = 0; i < count; ++i) v.push_back(vector(r));
    return polytope(v);
  }

 private:
  std::mt19937_64 engine_{20240607};
};

Quaternion about(const Vector& axis, Real angle) {
  const Vector u = std::sin(angle / 2) * normalized(axis);
  return {u.x, u.y, u.z, std::cos(angle / 2)};
}

Real distance(const Placed& a, const Placed& b) { return signed_distance(a, b).distance; }

TEST(Reference, SphereSphere) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const Real ra = random.uniform(0, 1), rb = random.uniform(0, 1);
    const Vector p = random.vector(1), q = random.vector(1);
    const Placed a = place(sphere(ra), p, random.rotation()), b = place(sphere(rb), q, random.rotation());
    EXPECT_CLOSE(distance(a, b), length(q - p) - ra - rb, tight);
  }
  EXPECT_CLOSE(distance(place(sphere(1)), place(sphere(2))), -3, tight);
  EXPECT_EQ(distance(place(sphere(0)), place(point())), 0);
}

TEST(Reference, AlignedBoxes) {
  Random random;
  for (int i = 0; i < 200; ++i) {
    const Vector p = random.vector(0.5L) + Vector{1, 1, 1}, q = random.vector(0.5L) + Vector{1, 1, 1};
    const Vector t = random.vector(i % 2 ? 2 : 1);
    const Vector gap{std::fabs(t.x) - (p.x + q.x) / 2, std::fabs(t.y) - (p.y + q.y) / 2,
                     std::fabs(t.z) - (p.z + q.z) / 2};
    const Real inside = std::max({gap.x, gap.y, gap.z});
    const Real expected =
        inside <= 0 ? inside : length({std::max(gap.x, 0.0L), std::max(gap.y, 0.0L), std::max(gap.z, 0.0L)});
    EXPECT_CLOSE(distance(place(box(p)), place(box(q), t)), expected, tight);
    // Turned together, and with margins.
    const Quaternion r = random.rotation();
    const Placed a = place(box(p, 0.25L), {3, 4, 5}, r);
    EXPECT_CLOSE(distance(a, place(box(q, 0.5L), a.to_world(t), r)), expected - 0.75L, 2 * tight);
  }
}

TEST(Reference, CubeCornerAgainstFace) {
  // The corner (1,1,1)/2 turned to point down.
  const Vector corner = normalized({1, 1, 1});
  const Quaternion turn = about(cross(corner, {0, -1, 0}), std::acos(-corner.y));
  const Real reach = std::sqrt(3.0L) / 2;
  for (const Real gap : {1.0L, 1e-3L, 1e-9L, 0.0L, -1e-9L, -0.25L})
    EXPECT_CLOSE(distance(place(box({4, 1, 4})), place(box({1, 1, 1}), {0, 0.5L + reach + gap, 0}, turn)), gap, tight);
}

TEST(Reference, TurnedBoxesOfKnownDepth) {
  // An edge of the turned cube enters a face by 1/2 + sqrt(1/2) - t.
  const Quaternion turn = about({0, 1, 0}, std::numbers::pi_v<Real> / 4);
  for (const Real t : {1.5L, 1.2L, 1.1L, 0.9L}) {
    const Signed s = signed_distance(place(box({1, 1, 1})), place(box({1, 1, 1}), {t, 0.1L, 0.05L}, turn));
    EXPECT_CLOSE(s.distance, t - 0.5L - std::sqrt(0.5L), tight);
    EXPECT_CLOSE(s.normal.x, 1, tight);
  }
  // Crossed edges: two cubes on edge, one along Z above one along X.
  const Quaternion on_z = about({0, 0, 1}, std::numbers::pi_v<Real> / 4);
  const Quaternion on_x = about({1, 0, 0}, std::numbers::pi_v<Real> / 4);
  for (const Real gap : {0.5L, 1e-12L, -0.1L})
    EXPECT_CLOSE(
        distance(place(box({1, 1, 1}), {}, on_z), place(box({1, 1, 1}), {0.1L, std::sqrt(2.0L) + gap, 0.2L}, on_x)),
        gap, tight);
}

TEST(Reference, CoaxialAndParallelCylinders) {
  Random random;
  for (const Real gap : {1.0L, 1e-9L, 0.0L, -1e-9L, -0.1L}) {
    const Quaternion turn = random.rotation();
    const Placed a = place(cylinder(2, 0.5L, 0.5L), {1, 2, 3}, turn);
    EXPECT_CLOSE(distance(a, place(cylinder(1, 0.75L, 0.25L), a.to_world({0, 1.5L + gap, 0}), turn)), gap, tight);
    EXPECT_CLOSE(distance(a, place(cylinder(1, 0.25L, 0.25L), a.to_world({0.75L + gap, 0.2L, 0}), turn)), gap, tight);
    // Rims apart in both directions; overlapping they touch at a corner only.
    if (gap > 0) {
      const Placed b = place(cylinder(1, 0.25L, 0.25L), a.to_world({0.75L + gap, 1.5L + gap, 0}), turn);
      EXPECT_CLOSE(distance(a, b), gap * std::sqrt(2.0L), tight);
    }
  }
  EXPECT_CLOSE(distance(place(cylinder(2, 1, 1)), place(cylinder(4, 0.25L, 0.25L))), -1.25L, tight);
  EXPECT_CLOSE(distance(place(cylinder(0.5L, 1, 1)), place(cylinder(0.25L, 2, 1))), -0.375L, tight);
}

TEST(Reference, ConeSides) {
  // A cone and its image under a half turn, laid side against side.
  const Real h = 2, r = 0.75L;
  const Vector m = normalized({h, r, 0}), middle{r / 2, 0, 0};
  for (const Real gap : {1.0L, 1e-6L, 1e-12L, 0.0L, -1e-9L, -0.01L}) {
    const Placed a = place(cylinder(h, r, 0));
    EXPECT_CLOSE(distance(a, place(cylinder(h, r, 0), 2 * middle + gap * m, {0, 0, 1, 0})), gap, tight);
  }
  // Tip to tip.
  EXPECT_CLOSE(distance(place(cylinder(h, r, 0)), place(cylinder(h, r, 0), {0, h + 0.5L, 0}, {0, 0, 1, 0})), 0.5L,
               tight);
}

TEST(Reference, Halfspaces) {
  const Placed floor = place(halfspace());
  const Real h = 2, r = 0.5L;
  for (const Real angle : {0.0L, 0.3L, 1.0L, 1.5L, 3.0L}) {
    // A cone's lowest point is its tip or the rim of its base.
    const Real tip = h / 2 * std::cos(angle), rim = -h / 2 * std::cos(angle) - r * std::sin(angle);
    const Placed cone = place(cylinder(h, r, 0, 0.125L), {7, 1, -3}, about({1, 0, 0}, angle));
    EXPECT_CLOSE(distance(floor, cone), 1 + std::min(tip, rim) - 0.125L, tight);
    EXPECT_CLOSE(distance(cone, floor), 1 + std::min(tip, rim) - 0.125L, tight);
  }
  EXPECT_CLOSE(distance(place(halfspace(0.5L), {0, 1, 0}), place(box({1, 1, 1}), {9, 5, 9})), 3, tight);
  EXPECT_EQ(distance(floor, place(halfspace(), {0, 1, 0})), -infinity);
  EXPECT_CLOSE(distance(floor, place(halfspace(0.25L), {4, 3, 0}, {1, 0, 0, 0})), 2.75L, tight);
  EXPECT_CLOSE(distance(floor, place(halfspace(0.25L), {4, -3, 0}, {1, 0, 0, 0})), -3.25L, tight);
  EXPECT_EQ(distance(floor, place(halfspace(), {0, 9, 0}, about({1, 0, 0}, 3))), -infinity);
}

TEST(Reference, EllipsoidAndPointOnAxis) {
  const Placed e = place(ellipsoid({3, 2, 1}));
  EXPECT_CLOSE(distance(e, place(point(), {5, 0, 0})), 2, 3 * tight);
  EXPECT_CLOSE(distance(e, place(point(), {0, -5, 0})), 3, 3 * tight);
  EXPECT_CLOSE(distance(place(point(), {0, 0, 1 + 1e-9L}), e), 1e-9L, 3 * tight);
  // Inside on the long axis, the nearest surface point is off the axis until
  // x passes the centre of curvature (a^2 - c^2) / a of the end.
  for (const Real x : {0.0L, 0.5L, 1.5L, 2.5L, 2.75L, 2.9L}) {
    const Real depth = x < 8.0L / 3 ? std::sqrt(1 - x * x / 8) : 3 - x;
    EXPECT_CLOSE(distance(e, place(point(), {x, 0, 0})), -depth, 3 * tight);
  }
  EXPECT_CLOSE(distance(place(ellipsoid({3, 2, 0})), place(sphere(0.5L), {0, 0, 2})), 1.5L, 3 * tight);
  EXPECT_CLOSE(distance(place(ellipsoid({3, 0, 0})), place(ellipsoid({0, 2, 0}), {0, 0, 2})), 2, 3 * tight);
}

TEST(Reference, Concentric) {
  EXPECT_CLOSE(distance(place(box({1, 2, 3})), place(box({4, 5, 6}))), -2.5L, tight);
  EXPECT_CLOSE(distance(place(ellipsoid({1, 2, 3})), place(ellipsoid({2, 1.5L, 3}))), -3, 3 * tight);
  EXPECT_CLOSE(distance(place(capsule(2, 0.5L, 0.5L)), place(capsule(2, 0.5L, 0.5L))), -1, tight);
  EXPECT_CLOSE(distance(place(cylinder(2, 1, 1)), place(box({2, 6, 2}))), -2, 2 * tight);
  // One end sphere inside the other.
  EXPECT_CLOSE(distance(place(capsule(1, 2, 0.5L)), place(point(), {0, -0.5L, 0})), -2, tight);
}

TEST(Reference, ZeroSizes) {
  for (const Shape& s : {box({0, 0, 0}), sphere(0), capsule(0, 0, 0), cylinder(0, 0, 0), ellipsoid({0, 0, 0})}) {
    EXPECT_EQ(distance(place(s), place(s)), 0);
    EXPECT_CLOSE(distance(place(s), place(box({1, 1, 1}), {2, 0, 0})), 1.5L, tight);
    EXPECT_CLOSE(distance(place(s), place(cylinder(1, 1, 1), {0, 2, 0})), 1.5L, tight);
  }
  const Placed disc = place(cylinder(0, 1, 1));
  EXPECT_CLOSE(distance(disc, place(point(), {0.5L, 0.25L, 0})), 0.25L, tight);
  EXPECT_CLOSE(distance(disc, place(box({0, 4, 0}), {0.5L, 0, 0})), -0.5L, tight);
  EXPECT_CLOSE(distance(place(box({2, 0, 0})), place(box({2, 0, 0}), {1, 0, 0})), 0, tight);
  EXPECT_CLOSE(distance(place(box({2, 0, 0})), place(box({2, 0, 0}), {5, 0, 0})), 3, tight);
  EXPECT_CLOSE(distance(place(box({2, 0, 2})), place(box({2, 0, 2}), {1, 0, 0})), 0, tight);
  EXPECT_CLOSE(distance(place(box({2, 0, 2})), place(box({2, 0, 2}), {5, 0, 6})), 5, tight);
}

// Outside, a point (or sphere) and a curved shape have closed forms.
TEST(Reference, PointOutsideCurvedShape) {
  Random random;
  for (int i = 0; i < 60; ++i) {
    const Real p = random.log_uniform(0.01L, 2), q = random.log_uniform(0.01L, 2), r = random.log_uniform(0.01L, 2);
    for (const Shape& s : {capsule(p, q, r), cylinder(p, q, r), cylinder(p, q, 0), ellipsoid({p, q, r}),
                           ellipsoid({p, 0, r}), cylinder(0, q, r)}) {
      const Placed a = place(s, random.vector(1), random.rotation());
      const Vector n = random.direction();
      // Away from a support point along n the distance is the step, exactly.
      for (const Real step : {2.0L, 1e-3L, 1e-6L, 1e-9L, 1e-12L}) {
        const Vector x = support(a, n) + step * n;
        const Placed b = place(point(), x);
        const Real unit = size(a, b) + 2;
        EXPECT_CLOSE(outside_distance(a, x), step, tight * unit);
        EXPECT_CLOSE(distance(a, b), step, tight * unit);
      }
      const Vector x = a.translation + random.vector(3);
      if (const Real d = outside_distance(a, x); d > 0) {
        EXPECT_CLOSE(distance(a, place(sphere(0.5L), x)), d - 0.5L, 5 * tight);
      }
    }
  }
}

// Inside a cone frustum, the depth of a point is its distance to the nearest of
// the two end planes and the side.
TEST(Reference, PointInsideFrustum) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const Real h = random.log_uniform(0.05L, 2), rb = random.log_uniform(0.05L, 2);
    const Real rt = i % 4 ? random.log_uniform(0.05L, 2) : 0, nearness = random.log_uniform(1e-12L, 1);
    const Real y = (i % 3 ? random.uniform(-0.5L, 0.5L) : 0.5L - nearness) * h;
    const Real reach = (rb * (h / 2 - y) + rt * (h / 2 + y)) / h;
    const Real r = reach * (i % 2 ? 1 - nearness : random.uniform(0, 1)), turn = random.uniform(0, 6);
    const Real depth = std::min({h / 2 - y, h / 2 + y, (reach - r) * h / std::hypot(h, rb - rt)});
    const Placed a = place(cylinder(h, rb, rt), random.vector(1), random.rotation());
    const Placed b = place(point(), a.to_world({r * std::cos(turn), y, r * std::sin(turn)}));
    EXPECT_CLOSE(distance(a, b), -depth, 3 * tight);
    EXPECT_EQ(outside_distance(a, b.translation), 0);
  }
}

Shape any_shape(Random& random, int kind) {
  const auto length = [&] { return random.log_uniform(0.05L, 1.5L); };
  const Real p = length(), q = length(), r = length();
  switch (kind) {
  case 0: return random.hull(12, 1);
  case 1: return random.hull(3, 1);
  case 2: return capsule(p, q, r);
  case 3: return cylinder(p, q, r);
  case 4: return ellipsoid({p, q, r});
  default: return box({p, q, r}, 0.1L);
  }
}

// A support point of B set a step along n from A's: the step bounds the distance
// from above and s(n) from below, so it is the distance, whatever the shapes.
TEST(Reference, SupportPointsSetApart) {
  Random random;
  for (int i = 0; i < 180; ++i) {
    const Placed a = place(any_shape(random, i % 6), random.vector(1), random.rotation());
    Placed b = place(any_shape(random, i / 6 % 6), {}, random.rotation());
    const Vector n = random.direction(), origin = support(b, -n);
    for (const Real step : {1.0L, 1e-3L, 1e-6L, 1e-9L, 1e-12L, 0.0L}) {
      b.translation = support(a, n) + step * n - origin;
      EXPECT_CLOSE(distance(a, b), step, 3 * tight) << i;
      const Answer answer{step, n, support(a, n), support(b, -n)};
      EXPECT_EQ(disprove(a, b, answer, 1e-15L, step == 0), std::nullopt);
    }
  }
}

TEST(Reference, EnumerationAgreesWithSearch) {
  Random random;
  for (int i = 0; i < 150; ++i) {
    const int counts[] = {1, 2, 3, 4, 8, 16};
    const Placed a = place(random.hull(counts[i % 6], 1), random.vector(0.3L), random.rotation());
    const Placed b = place(random.hull(counts[i / 6 % 6], 1), random.vector(i % 3 ? 0.3L : 2), random.rotation());
    EXPECT_CLOSE(distance(a, b), search_signed_distance(a, b).distance, tight) << i;
  }
}

TEST(Reference, SwapSymmetryAndBound) {
  Random random;
  for (int i = 0; i < 108; ++i) {
    const Placed a = place(any_shape(random, i % 6), random.vector(0.5L), random.rotation());
    const Placed b = place(any_shape(random, i / 6 % 6), random.vector(i % 4 ? 0.5L : 3), random.rotation());
    const Signed s = signed_distance(a, b);
    EXPECT_CLOSE(s.distance, distance(b, a), 2 * tight);
    // The support points of shape.cpp and the closed forms of the search.
    EXPECT_CLOSE(separation(a, b, s.normal), s.distance, 2 * tight);
    EXPECT_CLOSE(separation(b, a, -s.normal), s.distance, 2 * tight);
    for (int k = 0; k < 100; ++k) EXPECT_LE(separation(a, b, random.direction()), s.distance + tight);
  }
}

TEST(Reference, LargeHulls) {
  // 200 points on a unit sphere, which their hull nearly fills.
  Random random;
  std::vector<Vector> v;
  for (int i = 0; i < 200; ++i) v.push_back(random.direction());
  const Placed a = place(polytope(v)), b = place(random.hull(16, 0.2L), {0.5L, 0.5L, 0});
  EXPECT_CLOSE(distance(a, b), search_signed_distance(a, b).distance, tight);
  EXPECT_CLOSE(distance(a, place(point(), 3 * v[7])), 2, tight);
}

TEST(Certificate, AcceptsTheTruth) {
  const Placed a = place(box({2, 2, 2})), b = place(sphere(1), {2.5L, 0.25L, 0}),
               c = place(sphere(1), {1.5L, 0.25L, 0});
  EXPECT_EQ(disprove(a, b, {0.5L, {1, 0, 0}, {1, 0.25L, 0}, {1.5L, 0.25L, 0}}, 1e-15L), std::nullopt);
  EXPECT_EQ(disprove(a, c, {-0.5L, {1, 0, 0}, {1, 0.25L, 0}, {0.5L, 0.25L, 0}}, 1e-15L), std::nullopt);
  const Placed floor = place(halfspace());
  EXPECT_EQ(disprove(floor, a, {-1, {0, 1, 0}, {0.5L, 0, 0}, {0.5L, -1, 0}}, 1e-15L), std::nullopt);
  EXPECT_EQ(disprove(floor, floor, {-infinity, {0, 1, 0}, {}, {}}, 1e-15L), std::nullopt);
}

TEST(Certificate, RejectsFalseClaims) {
  const Placed a = place(box({2, 2, 2})), b = place(box({2, 2, 2}), {2.5L, 0, 0}),
               c = place(box({2, 2, 2}), {1.5L, 0, 0});
  const auto says = [](const std::optional<std::string>& sentence, const char* what) {
    EXPECT_NE(sentence.value_or("").find(what), std::string::npos) << sentence.value_or("accepted");
  };
  const Real t = 1e-9L;
  const Vector x{1, 0, 0}, at{1, 0, 0}, bt{1.5L, 0, 0};
  EXPECT_EQ(disprove(a, b, {0.5L, x, at, bt}, t), std::nullopt);
  says(disprove(a, b, {0.5L, {1.001L, 0, 0}, at, bt}, t), "has length");
  says(disprove(a, b, {0.5L, x, at, {1.6L, 0, 0}}, t), "differs from distance");
  says(disprove(a, b, {0.6L, x, at, {1.6L, 0, 0}}, t), "not a support point");
  says(disprove(a, b, {0.4L, x, {1.1L, 0, 0}, bt}, t), "outside its shape");
  // The right direction is needed, and a tilted one is not.
  const Vector tilted = normalized({1, 0.1L, 0});
  says(disprove(a, b, {0.5L, tilted, {1, 1, 0}, Vector{1, 1, 0} + 0.5L * tilted}, t), "outside its shape");
  says(disprove(a, b, {std::numeric_limits<Real>::quiet_NaN(), x, at, bt}, t), "not finite");
  // Separates, but is not the shortest way: found by search only.
  const Answer sideways{-2, {0, 1, 0}, {0.75L, 1, 0}, {0.75L, -1, 0}};
  says(disprove(a, c, sideways, t), "separates by -0.5");
  EXPECT_EQ(disprove(a, c, sideways, t, false), std::nullopt);
  // A separated pair called overlapping.
  const Placed p = place(point()), q = place(point(), x);
  says(disprove(p, q, {-1, -x, {}, x}, t, false), "separates by 1");
}

}  // namespace
}  // namespace graze::reference
