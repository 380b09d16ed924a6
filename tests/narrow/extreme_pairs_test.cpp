// Pairs that leave an expanding polytope little to hold on to: of extreme ratios of size, concentric, nearly identical,
// nearly parallel. An answer is that of the reference within the tolerance, or says by how much it may be off.
//
// How many pairs of two kinds: GRAZE_TEST_EXTREME_PAIRS in the environment, else enough for a run of seconds.
#include <gtest/gtest.h>

#include <cmath>

#include "common/asked_number.hpp"
#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "narrow/core/core.hpp"
#include "reference/certificate.hpp"

namespace graze::testing {
namespace {

reference::Vector reference_vector(const Vec3d& v) {
  return {static_cast<reference::Real>(v.x), static_cast<reference::Real>(v.y), static_cast<reference::Real>(v.z)};
}

float log_uniform(Random& random, float low, float high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

/// One up to ten thousand times as large as the other and about it, or both alike; turned by nothing, little or much.
std::pair<PlacedSpecimen, PlacedSpecimen> extreme_pair(Kind kind_a, Kind kind_b, Random& random, int round) {
  static constexpr float ratios[] = {1e4f, 1e3f, 1e2f, 1};
  static constexpr float nearest[] = {1e-9f, 1e-8f, 1e-3f, 0.3f}, furthest[] = {1e-8f, 1e-3f, 0.3f, 1.5f};
  const auto any = [&](Kind kind, float scale) {
    return random() % 3 == 0 ? degenerate_specimen(kind, scale, random) : random_specimen(kind, scale, random);
  };
  PlacedSpecimen a{any(kind_a, 1), {}, {}}, b{any(kind_b, 1 / ratios[round % 4]), {}, {}};
  if (round % 4 == 3 && kind_a == kind_b) b.specimen = a.specimen;
  if (random() % 2 == 0) a.rotation = random_rotation(random);
  b.rotation = a.rotation;
  if (random() % 2 == 0) {
    const Vec3f lean = random_vector(random, log_uniform(random, 1e-9f, 1));
    b.rotation = normalized(a.rotation) * normalized(Quatf{lean.x, lean.y, lean.z, 1});
  }
  if (const auto way = random() % 5; way > 0) {
    const float far = log_uniform(random, nearest[way - 1], furthest[way - 1]);
    Vec3f along{};
    along[random() % 3] = far;
    b.translation = random() % 2 == 0 ? rotate(normalized(a.rotation), along) : random_vector(random, far);
  }
  if (random() % 2 == 0) std::swap(a, b);
  return {a, b};
}

template <class T>
void expect_true_or_bounded(const PlacedSpecimen& a, const PlacedSpecimen& b) {
  using reference::Real;
  const reference::Placed ra = reference_of(a), rb = reference_of(b);
  // A coordinate of the scene is rounded, too, however small the shapes.
  const Real size = reference::size(ra, rb), far = static_cast<Real>(max_abs(a.translation - b.translation)),
             allowed = static_cast<Real>(tolerance<T>) * size + 16 * static_cast<Real>(epsilon<T>) * far;
  if (!(size > 0)) return;
  const Distance<T> d = distance(build<T>(a.specimen), pose_of<T>(a), build<T>(b.specimen), pose_of<T>(b));
  const Vec3d normal = converted<double>(d.normal), on_a = converted<double>(d.a), on_b = converted<double>(d.b);
  const auto measured = static_cast<Real>(d.distance);
  const Real truth =
      greatest(reference::signed_distance(ra, rb).distance, reference::separation(ra, rb, reference_vector(normal)));
  EXPECT_LE(std::abs(measured - truth), allowed + static_cast<Real>(d.error)) << describe(a) << "\n" << describe(b);
  if (d.status != Status::converged) return;
  EXPECT_LE(std::abs(measured - truth), allowed) << describe(a) << "\n" << describe(b);
  const Real missed = reference::length(reference_vector(on_b - on_a - normal * static_cast<double>(d.distance)));
  EXPECT_LE(missed, allowed) << describe(a) << "\n" << describe(b);
  EXPECT_LE(reference::outside_distance(ra, reference_vector(on_a)), allowed) << describe(a) << "\n" << describe(b);
  EXPECT_LE(reference::outside_distance(rb, reference_vector(on_b)), allowed) << describe(a) << "\n" << describe(b);
}

TEST(ExtremePairs, AreRightOrSayByHowMuchTheyMayBeOff) {
  const int pairs = asked_number("GRAZE_TEST_EXTREME_PAIRS", 24);
  for (int i = 0; i < bounded_kinds; ++i)
    for (int j = i; j < bounded_kinds; ++j) {
      Random random(static_cast<std::uint64_t>(100 * i + j));
      for (int k = 0; k < pairs; ++k) {
        const auto [a, b] = extreme_pair(static_cast<Kind>(i), static_cast<Kind>(j), random, k);
        expect_true_or_bounded<double>(a, b);
        if (k % 4 == 0) expect_true_or_bounded<float>(a, b);
        if (::testing::Test::HasFailure()) return;
      }
    }
}

// The way from centre to centre is the axis but for rounding, and has no face of its own: one end is parted from the
// other along the axis by 1e-6 less than the height.
TEST(ExtremePairs, EqualCylindersBesideEachOtherAlongTheirAxis) {
  const Shaped cylinder = Cylinder<double>(1, 0.5);
  for (const double shift : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Distance<double> d = distance(cylinder, Posed{}, cylinder, Posed{{0, shift, 0}, {}});
    EXPECT_EQ(d.status, Status::converged) << shift;
    EXPECT_NEAR(d.distance, shift - 1, 1e-12) << shift;
    EXPECT_NEAR(d.normal.y, 1, 1e-12) << shift;
  }
}

// A ball's centre is as deep in a cone or a tapered capsule as its nearest side, which has no facets to be expanded.
TEST(ExtremePairs, BallsInsideBodiesOfRevolutionAreProven) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Shaped ball = Sphere<double>(0.01);
    const Shaped round = i % 2 ? Shaped(Cylinder<double>(2, 0.5, 0.2)) : Shaped(Capsule<double>(2, 0.5, 0.2));
    const Posed pose{converted<double>(random_vector(random, 0.1f)),
                     normalized(converted<double>(random_rotation(random)))};
    EXPECT_EQ(distance(round, pose, ball, Posed{}).status, Status::converged) << i;
  }
}

// Boxes of size 1 a hundredth deep, whose faces are parallel but for an angle of rounding and more. The corner that is
// deepest hangs over the rim of the other's face by as much.
TEST(ExtremePairs, WitnessPointsOfNearlyParallelBoxesLieOnThem) {
  Random random(1);
  const Vec3d half{0.5, 0.5, 0.5};
  const Shaped box = Box<double>(half * 2);
  const auto outside = [&](const Posed& pose, const Vec3d& point) {
    const Vec3d beyond = abs(inverse_transform(pose, point)) - half;
    return greatest(0.0, greatest(beyond.x, greatest(beyond.y, beyond.z)));
  };
  for (int i = 0; i < 20000; ++i) {
    static constexpr Vec3d axes[] = {{1, 1, 1}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
    const Vec3d lean = normalized(axes[random() % 4]) * static_cast<double>(log_uniform(random, 1e-10f, 1e-4f) / 2);
    Posed a, b{{}, normalized(Quatd{lean.x, lean.y, lean.z, 1})};
    const auto axis = random() % 3;
    for (std::size_t k = 0; k < 3; ++k)
      b.translation[k] = k == axis ? 0.99 : random() % 2 ? static_cast<double>(uniform(random, -0.3f, 0.3f)) : 0;
    if (i % 2 == 0) {
      const Posed moved{converted<double>(random_vector(random, 1)),
                        normalized(converted<double>(random_rotation(random)))};
      a = compose(moved, a);
      b = compose(moved, b);
    }
    const Distance<double> d = distance(box, a, box, b);
    ASSERT_LT(outside(a, d.a), 1e-11) << i;
    ASSERT_LT(outside(b, d.b), 1e-11) << i;
    ASSERT_LT(length(d.b - d.a - d.normal * d.distance), 1e-14) << i;
  }
}

}  // namespace
}  // namespace graze::testing
