// A swept volume against the shape at the places it sweeps over.
#include "graze/swept.hpp"

#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "graze/cast.hpp"

namespace graze::testing {
namespace {

TEST(Swept, OverlapsWhatTheMovingShapeHits) {
  Random random(7);
  int hits = 0, misses = 0;
  for (int i = 0; i < bounded_kinds * 100; ++i) {
    const PlacedSpecimen a{random_specimen(static_cast<Kind>(i % bounded_kinds), 1, random), random_vector(random, 1),
                           random_rotation(random)};
    const PlacedSpecimen b{random_specimen(static_cast<Kind>(i / bounded_kinds % bounded_kinds), 1, random),
                           random_vector(random, 3), random_rotation(random)};
    const Vec3d motion = converted<double>(random_vector(random, 4));
    const Shaped sa = build<double>(a.specimen), sb = build<double>(b.specimen);
    const Posed pa = pose_of<double>(a), pb = pose_of<double>(b);
    const double gap = distance(swept(sa, pa, motion), pa, sb, pb).distance;
    if (std::abs(gap) < 1e-7) continue;
    const bool hit = cast<double>(sa, pa, {motion, {}}, sb, pb, {}, 1).has_value();
    EXPECT_EQ(hit, gap < 0) << gap << "\n" << describe(a) << "\n" << describe(b);
    ++(hit ? hits : misses);
  }
  EXPECT_GT(hits, 100);
  EXPECT_GT(misses, 200);
}

TEST(Swept, OfABallIsACapsule) {
  const Posed pose{{1, 2, 3}, normalized(Quatd{1, 2, 3, 4})};
  const Shaped sweep = swept(Shaped(Sphere<double>(0.5)), pose, {0, 3, 0});
  const Shaped capsule(Capsule<double>(3, 0.5)), probe(Box<double>({0.3, 0.4, 0.5}));
  for (int i = 0; i < 20; ++i) {
    const Posed at{{1 + 2 * std::cos(i), 1 + 0.3 * i, 3 + 2 * std::sin(i)}, {}};
    EXPECT_NEAR(distance(sweep, pose, probe, at).distance,
                distance(capsule, Posed{{1, 3.5, 3}, {}}, probe, at).distance, 1e-12);
  }
}

TEST(Swept, WithoutMotionIsTheShape) {
  const Shapef cube(Box<float>({1, 2, 3}), 0.25f);
  const Shapef still = swept(cube, {}, {});
  for (const Vec3f& d : {Vec3f{1, 0.5f, 0}, Vec3f{-1, 2, 3}}) EXPECT_EQ(support(still, d), support(cube, d));
}

TEST(Swept, RefusesWhatHasNoSupport) {
  EXPECT_THROW(swept(Shaped(HalfSpace<double>()), {}, {1, 0, 0}), InvalidValue);
  EXPECT_THROW(swept(Shaped(Sphere<double>(1)), {}, {std::nan(""), 0, 0}), InvalidValue);
}

}  // namespace
}  // namespace graze::testing
