// Pairs that leave an expanding polytope little to hold on to: of extreme ratios of size, concentric, nearly identical,
// nearly parallel. An answer is that of the reference within the tolerance, or says by how much it may be off.
//
// How many pairs of two kinds: GRAZE_TEST_EXTREME_PAIRS in the environment, else enough for a run of seconds.
#include <gtest/gtest.h>

#include <cmath>

#include "common/asked_number.hpp"
#include "common/extreme_pair.hpp"
#include "graze/query.hpp"
#include "narrow/core/core.hpp"
#include "reference/certificate.hpp"

namespace graze::testing {
namespace {

reference::Vector reference_vector(const Vec3d& v) {
  return {static_cast<reference::Real>(v.x), static_cast<reference::Real>(v.y), static_cast<reference::Real>(v.z)};
}

template <class T>
void expect_true_or_bounded(const PlacedSpecimen& a, const PlacedSpecimen& b) {
  using reference::Real;
  const reference::Placed ra = reference_of(a), rb = reference_of(b);
  const Real size = reference::size(ra, rb), allowed = allowed_error<T>(a, b, size);
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

// All directions about a common axis are as good, so that a polytope has to come near a whole circle of them. The depth
// is that of the profiles, which a bound of rounding's size proves; and so does one of axes that are apart by little.
TEST(ExtremePairs, BodiesOfRevolutionWithOneAxisAreProven) {
  Random random(11);
  static constexpr Kind kinds[] = {Kind::capsule, Kind::tapered_capsule, Kind::cylinder, Kind::cone,
                                   Kind::truncated_cone};
  static constexpr float ratios[] = {1, 0.3f, 1e-2f, 1e-4f};
  for (int i = 0; i < 600; ++i) {
    const Kind kind_a = kinds[i % 5], kind_b = kinds[i / 5 % 5];
    PlacedSpecimen a{random_specimen(kind_a, 1, random), {}, {}},
        b{random_specimen(kind_b, ratios[i % 4], random), {}, {}};
    b.translation.y = uniform(random, -0.1f, 0.1f) * a.specimen.size[0];
    if (i % 3 == 0) b.rotation = {1, 0, 0, 0};  // upside down
    const reference::Placed ra = reference_of(a), rb = reference_of(b);
    const auto size = static_cast<double>(reference::size(ra, rb));
    const Distance<double> d =
        distance(build<double>(a.specimen), pose_of<double>(a), build<double>(b.specimen), pose_of<double>(b));
    // The search ends within some 1e-8 of the depth; the bound says so.
    EXPECT_LE(d.error, 1e-7 * size) << describe(a) << "\n" << describe(b);
    const auto truth = static_cast<double>(greatest(reference::signed_distance(ra, rb).distance,
                                                    reference::separation(ra, rb, reference_vector(d.normal))));
    EXPECT_NEAR(d.distance, truth, tolerance<double> * size + d.error) << describe(a) << "\n" << describe(b);
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
