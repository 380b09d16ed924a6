// Solid meshes that are not convex against the winding number, and the questions with a limit against all pairs of
// pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "composite/brute_force.hpp"
#include "graze/raycast.hpp"

namespace graze::testing {
namespace {

using Index = Mesh<double>::Index;

/// A closed surface.
struct ClosedSurface {
  std::vector<Vec3f> points;
  std::vector<Index> triangles;
};

/// A torus of radii 1 and about 0.4, whose tube swells and shrinks.
ClosedSurface bumpy_torus(Random& random) {
  constexpr int around = 24, tube = 12;
  const float swell = uniform(random, 0.0f, 0.12f), waves = std::floor(uniform(random, 2, 6));
  ClosedSurface surface;
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < tube; ++k) {
      const float u = 6.2831853f * static_cast<float>(i) / around, v = 6.2831853f * static_cast<float>(k) / tube;
      const float r = 0.4f + swell * std::sin(waves * u + 2 * v), wide = 1 + r * std::cos(v);
      surface.points.push_back({wide * std::cos(u), r * std::sin(v), wide * std::sin(u)});
    }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i % around * tube + k % tube); };
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < tube; ++k) {
      surface.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k)});
      surface.triangles.push_back({at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)});
    }
  return surface;
}

/// A ball of radius about 1 with bumps and dents of up to 0.45.
ClosedSurface bumpy_ball(Random& random) {
  constexpr int around = 20, rows = 11;
  const float bump = uniform(random, 0.1f, 0.45f);
  const Vec3f wave = random_vector(random, 5), start = random_vector(random, 3);
  const auto placed = [&](const Vec3f& d) {
    return d * (1 + bump * std::sin(wave.x * d.x + start.x) * std::cos(wave.y * d.y + start.y) *
                        std::cos(wave.z * d.z + start.z));
  };
  ClosedSurface surface;
  surface.points.push_back(placed({0, 1, 0}));
  surface.points.push_back(placed({0, -1, 0}));
  for (int i = 0; i < around; ++i)
    for (int k = 1; k <= rows; ++k) {
      const float u = 6.2831853f * static_cast<float>(i) / around, v = 3.14159265f * static_cast<float>(k) / (rows + 1);
      surface.points.push_back(placed({std::sin(v) * std::cos(u), std::cos(v), std::sin(v) * std::sin(u)}));
    }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(2 + i % around * rows + k - 1); };
  for (int i = 0; i < around; ++i) {
    surface.triangles.push_back({0, at(i + 1, 1), at(i, 1)});
    surface.triangles.push_back({1, at(i, rows), at(i + 1, rows)});
    for (int k = 1; k < rows; ++k) {
      surface.triangles.push_back({at(i, k), at(i + 1, k), at(i, k + 1)});
      surface.triangles.push_back({at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return surface;
}

/// How often a surface goes around a point: the solid angles of all triangles (van Oosterom, Strackee 1983, "The solid
/// angle of a plane triangle") over the whole sphere's.
long double winding_number(const ClosedSurface& surface, const Vec3f& from) {
  using Real = long double;
  Real sum = 0;
  for (const Index& t : surface.triangles) {
    std::array<std::array<Real, 3>, 3> d;
    std::array<Real, 3> length;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3f& p = surface.points[t[k]];
      d[k] = {Real(p.x) - from.x, Real(p.y) - from.y, Real(p.z) - from.z};
      length[k] = std::sqrt(d[k][0] * d[k][0] + d[k][1] * d[k][1] + d[k][2] * d[k][2]);
    }
    const auto dot = [&](std::size_t i, std::size_t k) {
      return d[i][0] * d[k][0] + d[i][1] * d[k][1] + d[i][2] * d[k][2];
    };
    const Real volume = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                        d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                        d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    sum += 2 * std::atan2(volume, length[0] * length[1] * length[2] + dot(0, 1) * length[2] + dot(1, 2) * length[0] +
                                      dot(2, 0) * length[1]);
  }
  return sum / (4 * std::acos(Real(-1)));
}

template <class T>
Mesh<T> solid_of(const ClosedSurface& surface, bool solid = true) {
  std::vector<Vec3<T>> points;
  for (const Vec3f& p : surface.points) points.push_back(converted<T>(p));
  return {points, surface.triangles, Sides::both, solid};
}

template <class T>
class SolidContainment : public ::testing::Test {};
using BothScalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SolidContainment, BothScalars);

TYPED_TEST(SolidContainment, IsThatOfTheWindingNumber) {
  using T = TypeParam;
  Random random(11);
  int inside = 0, asked = 0;
  for (int i = 0; i < 60; ++i) {
    const ClosedSurface surface = i % 2 == 0 ? bumpy_torus(random) : bumpy_ball(random);
    const Shape<T> solid = solid_of<T>(surface), skin = solid_of<T>(surface, false);
    for (int k = 0; k < 40; ++k) {
      const Vec3f p = random_vector(random, 1.4f);
      const Shape<T> ball = Sphere<T>(T(0.02));
      const Pose<T> at{converted<T>(p), {}};
      // What cuts the surface touches whatever the inside is.
      const T gap = brute_force_distance(ball, at, skin, Pose<T>{});
      if (!(gap > T(1e-4))) continue;
      ++asked;
      const bool expected = winding_number(surface, p) > 0.5L;
      inside += expected;
      EXPECT_FALSE(overlap(ball, at, skin, Pose<T>{}));
      EXPECT_EQ(overlap(ball, at, solid, Pose<T>{}), expected);
      EXPECT_EQ(overlap(solid, Pose<T>{}, ball, at), expected);
      EXPECT_EQ(raycast<T>(solid, Pose<T>{}, Ray<T>{at.translation, {0, 0, 1}}, T(0)).has_value(), expected);
      const Distance<T> d = distance(ball, at, solid, Pose<T>{});
      if (!expected) {
        EXPECT_EQ(d.distance, gap);
        continue;
      }
      // The way that is told leads out, and is no shorter than the surface is far.
      const T way = -d.distance;
      EXPECT_GE(way, gap + T(0.04) * (1 - T(1e-4)));
      const Pose<T> moved{at.translation + d.normal * (d.distance - T(1e-4)), {}};
      EXPECT_FALSE(overlap(ball, moved, solid, Pose<T>{}));
      EXPECT_LE(max_abs(d.b - d.a - d.normal * d.distance), T(1e-5));
    }
  }
  EXPECT_GE(asked, 1500);
  EXPECT_GE(inside, 300);
}

/// Meshes that are open, closed, solid and in compounds with convex shapes.
template <class T>
Shape<T> random_composite(Random& random) {
  const ClosedSurface surface = random() % 2 == 0 ? bumpy_torus(random) : bumpy_ball(random);
  if (random() % 3 == 0) return solid_of<T>(surface, false);
  std::vector<Placed<T>> children;
  if (random() % 2 == 0)
    children.push_back({solid_of<T>(surface, false), {converted<T>(random_vector(random, 1)), {}}});
  for (int i = 0; i < 5; ++i)
    children.push_back(
        {build<T>(random_specimen(static_cast<Kind>(random() % bounded_kinds), 0.4f, random)),
         {converted<T>(random_vector(random, 1.5f)), normalized(converted<T>(random_rotation(random)))}});
  return Compound<T>(children);
}

TYPED_TEST(SolidContainment, LimitsAndNearPiecesAgainstAllPairs) {
  using T = TypeParam;
  Random random(5);
  int near = 0, beyond = 0, listed = 0;
  for (int i = 0; i < 40; ++i) {
    const Shape<T> a = random_composite<T>(random);
    const Shape<T> b = i % 3 == 0 ? random_composite<T>(random)
                                  : build<T>(random_specimen(static_cast<Kind>(i % bounded_kinds), 0.5f, random));
    const Pose<T> at_a{converted<T>(random_vector(random, 1)), normalized(converted<T>(random_rotation(random)))};
    const Pose<T> at_b{converted<T>(random_vector(random, 4)), normalized(converted<T>(random_rotation(random)))};
    const T reach(uniform(random, 0.05f, 1.0f));
    // All pairs of pieces within reach of the nearest pair, in brute force.
    const auto pieces_a = pieces_of(a, at_a), pieces_b = pieces_of(b, at_b);
    std::vector<T> all;
    T least_distance = std::numeric_limits<T>::infinity();
    for (const auto& p : pieces_a)
      for (const auto& q : pieces_b) {
        all.push_back(distance(p.shape, p.pose, q.shape, q.pose).distance);
        least_distance = std::min(least_distance, all.back());
      }
    const Distance<T> whole = distance(a, at_a, b, at_b);
    for (const T limit : {std::max(least_distance, T(0)) + reach, std::max(least_distance - reach, T(0)), T(0)}) {
      // A limit at the distance itself may be decided by rounding.
      if (std::abs(limit - least_distance) < T(1e-4)) continue;
      const bool expected = least_distance <= limit;
      (expected ? near : beyond) += 1;
      EXPECT_EQ(within(a, at_a, b, at_b, limit), expected);
      EXPECT_EQ(within(b, at_b, a, at_a, limit), expected);
      const auto d = distance_up_to(a, at_a, b, at_b, limit);
      ASSERT_EQ(d.has_value(), expected);
      if (d) {
        EXPECT_EQ(d->distance, whole.distance);
        EXPECT_EQ(d->normal, whole.normal);
        EXPECT_EQ(d->a, whole.a);
        EXPECT_EQ(d->b, whole.b);
      }
      std::vector<PieceDistance<T>> pieces;
      near_pieces(a, at_a, b, at_b, limit, pieces);
      std::vector<T> found, wanted;
      for (const auto& p : pieces) found.push_back(p.distance.distance);
      for (const T x : all)
        if (x <= limit) wanted.push_back(x);
      std::sort(found.begin(), found.end());
      std::sort(wanted.begin(), wanted.end());
      listed += static_cast<int>(found.size());
      // Pieces at the very limit may be decided by rounding.
      const auto at_limit = std::count_if(all.begin(), all.end(), [&](T x) { return std::abs(x - limit) < T(1e-4); });
      ASSERT_LE(std::abs(static_cast<long>(found.size()) - static_cast<long>(wanted.size())), at_limit)
          << a.name() << " " << b.name() << " at " << limit << ", least " << least_distance << ": " << found.size()
          << " of " << wanted.size();
      for (std::size_t k = 0; k + static_cast<std::size_t>(at_limit) < std::min(found.size(), wanted.size()); ++k)
        EXPECT_NEAR(found[k], wanted[k], T(1e-4));
      EXPECT_EQ(pieces.empty(), !expected);
    }
  }
  EXPECT_GE(near, 40);
  EXPECT_GE(beyond, 20);
  EXPECT_GE(listed, 200);
}

}  // namespace
}  // namespace graze::testing
