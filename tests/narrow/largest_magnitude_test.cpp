// Answers do not change with the size of the world, up to the largest that is accepted.
#include <gtest/gtest.h>

#include <cmath>

#include "common/specimen.hpp"
#include "graze/detail/validate.hpp"
#include "graze/query.hpp"

namespace graze::testing {
namespace {

/// All that can be asked of a pair, in units of `scale`. A power of two takes no digit from any number, so that answers
/// are equal to the last bit unless a product over- or underflows.
template <class T>
struct Answers {
  bool overlap = false;
  Distance<T> distance;
  Closest<T> closest;
  Manifolds<T> manifolds;

  Answers(const PlacedSpecimen& a, const PlacedSpecimen& b, T scale) {
    const Shape<T> sa = build<T>(a.specimen, scale), sb = build<T>(b.specimen, scale);
    const Pose<T> pa = pose_of<T>(a, scale), pb = pose_of<T>(b, scale);
    overlap = graze::overlap(sa, pa, sb, pb);
    distance = graze::distance(sa, pa, sb, pb);
    closest = graze::closest(sa, pa, pb.translation);
    contacts(sa, pa, sb, pb, scale / T(8), manifolds);
  }
};

template <class T>
void expect_scaled(const Answers<T>& unit, const Answers<T>& scaled, T scale) {
  EXPECT_EQ(unit.overlap, scaled.overlap);
  EXPECT_EQ(unit.distance.status, scaled.distance.status);
  EXPECT_EQ(unit.distance.normal, scaled.distance.normal);
  EXPECT_EQ(unit.closest.distance * scale, scaled.closest.distance);
  EXPECT_EQ(unit.closest.point * scale, scaled.closest.point);
  if (unit.distance.status == Status::unbounded) return;
  EXPECT_EQ(unit.distance.distance * scale, scaled.distance.distance);
  EXPECT_EQ(unit.distance.a * scale, scaled.distance.a);
  EXPECT_EQ(unit.distance.b * scale, scaled.distance.b);
  ASSERT_EQ(unit.manifolds.size(), scaled.manifolds.size());
  for (std::size_t m = 0; m < unit.manifolds.size(); ++m) {
    const auto &points = unit.manifolds[m].points, &others = scaled.manifolds[m].points;
    ASSERT_EQ(points.size(), others.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(points[i].a * scale, others[i].a);
      EXPECT_EQ(points[i].b * scale, others[i].b);
      EXPECT_EQ(points[i].feature, others[i].feature);
    }
  }
}

template <class T>
void check_all_kinds(T scale) {
  for (int i = 0; i < kind_count; ++i)
    for (int j = 0; j < kind_count; ++j) {
      Random random(static_cast<unsigned>(100 * i + j));
      const auto a = static_cast<Kind>(i), b = static_cast<Kind>(j);
      for (int n = 0; n < 12; ++n) {
        const bool lattice = n % 3 == 0;
        const auto placed = [&](Kind kind) -> PlacedSpecimen {
          if (lattice) return on_lattice(degenerate_specimen(kind, 1, random), 1, random);
          return {random_specimen(kind, 1, random), random_vector(random, 1), random_rotation(random)};
        };
        const PlacedSpecimen pa = placed(a), pb = placed(b);
        expect_scaled(Answers<T>(pa, pb, T(1)), Answers<T>(pa, pb, scale), scale);
        if (::testing::Test::HasFailure()) FAIL() << describe(pa) << "\n" << describe(pb) << "\nscale " << scale;
      }
    }
}

/// The specimens' sizes and coordinates are up to 2.
TEST(LargestMagnitude, FloatAnswersAsAtOne) {
  const float scale = std::exp2(55.f);
  ASSERT_LE(2 * scale, largest_magnitude<float>);
  check_all_kinds<float>(scale);
}
TEST(LargestMagnitude, DoubleAnswersAsAtOne) {
  const double scale = std::exp2(158.0);
  ASSERT_LE(2 * scale, largest_magnitude<double>);
  check_all_kinds<double>(scale);
}
TEST(LargestMagnitude, FloatAnswersAsAtOneInMillionths) { check_all_kinds<float>(std::exp2(-20.f)); }

}  // namespace
}  // namespace graze::testing
