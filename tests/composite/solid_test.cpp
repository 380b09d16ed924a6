// Solid meshes: what lies wholly inside touches; and the questions with a limit.
#include <gtest/gtest.h>

#include "composite/brute_force.hpp"
#include "graze/cast.hpp"
#include "graze/raycast.hpp"

namespace graze::testing {
namespace {

template <class T>
class Solid : public ::testing::Test {
 public:
  static constexpr T noise = T(1e-5);

  static Mesh<T> cube(T half, bool solid) {
    std::vector<Vec3<T>> points;
    for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half});
    return {points,
            {{0, 2, 1},
             {1, 2, 3},
             {4, 5, 6},
             {5, 7, 6},
             {0, 1, 4},
             {1, 5, 4},
             {2, 6, 3},
             {3, 6, 7},
             {0, 4, 2},
             {2, 4, 6},
             {1, 3, 5},
             {3, 7, 5}},
            Sides::both,
            solid};
  }

  const Shape<T> solid = cube(T(2), true), hollow = cube(T(2), false), ball = Sphere<T>(T(0.5));
  const Pose<T> origin{}, inside{{T(1), T(0.1), T(0.2)}, {}}, outside{{T(5), T(0), T(0)}, {}};
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Solid, Scalars);

TYPED_TEST(Solid, AnOpenMeshIsNone) {
  using T = TypeParam;
  EXPECT_THROW(Mesh<T>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, Sides::both, true), InvalidValue);
}

TYPED_TEST(Solid, WhatLiesInsideTouchesAndLeavesAlongTheNormal) {
  using T = TypeParam;
  EXPECT_TRUE(overlap(this->ball, this->inside, this->solid, this->origin));
  EXPECT_FALSE(overlap(this->ball, this->inside, this->hollow, this->origin));
  for (const bool swapped : {false, true}) {
    const Distance<T> d = swapped ? distance(this->solid, this->origin, this->ball, this->inside)
                                  : distance(this->ball, this->inside, this->solid, this->origin);
    EXPECT_NEAR(d.distance, T(-1.5), this->noise);
    EXPECT_NEAR(d.normal.x, swapped ? 1 : -1, this->noise);
    EXPECT_LE(max_abs(d.b - d.a - d.normal * d.distance), this->noise);
  }
}

TYPED_TEST(Solid, MeshesInsideMeshes) {
  using T = TypeParam;
  for (const bool filled : {false, true}) {
    const Shape<T> small = this->cube(T(0.25), filled);
    EXPECT_TRUE(overlap(small, this->inside, this->solid, this->origin));
    EXPECT_FALSE(overlap(small, this->inside, this->hollow, this->origin));
    EXPECT_NEAR(distance(small, this->inside, this->solid, this->origin).distance, T(-1.25), this->noise);
  }
}

TYPED_TEST(Solid, OnePointOfContactWhateverTheMargin) {
  using T = TypeParam;
  for (const T margin : {T(0), T(2)}) {
    Manifolds<T> manifolds;
    EXPECT_TRUE(contacts(this->ball, this->inside, this->solid, this->origin, margin, manifolds));
    ASSERT_EQ(manifolds.size(), 1u);
    EXPECT_EQ(manifolds[0].points.size(), 1u);
  }
}

TYPED_TEST(Solid, AsAChildOfACompound) {
  using T = TypeParam;
  const Shape<T> compound = Compound<T>({Placed<T>{this->solid, {{T(10), T(0), T(0)}, {}}}});
  const Pose<T> there{{T(11), T(0.1), T(0.2)}, {}};
  EXPECT_TRUE(overlap(this->ball, there, compound, this->origin));
  EXPECT_FALSE(overlap(this->ball, this->inside, compound, this->origin));
  EXPECT_NEAR(distance(compound, this->origin, this->ball, there).distance, T(-1.5), this->noise);
}

TYPED_TEST(Solid, CastsAndRaysBeginInContact) {
  using T = TypeParam;
  const auto hit = cast<T>(this->ball, this->inside, {}, this->solid, this->origin, {}, T(1));
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->t, T(0));
  EXPECT_FALSE(cast<T>(this->ball, this->inside, {}, this->hollow, this->origin, {}, T(1)).has_value());
  const Ray<T> ray{this->inside.translation, {1, 0, 0}};
  const auto at = raycast<T>(this->solid, this->origin, ray, T(10));
  ASSERT_TRUE(at.has_value());
  EXPECT_EQ(at->t, T(0));
  EXPECT_EQ(at->normal.x, T(-1));
}

TYPED_TEST(Solid, LimitsAgreeWithTheDistance) {
  using T = TypeParam;
  EXPECT_TRUE(within(this->ball, this->outside, this->solid, this->origin, T(2.6)));
  EXPECT_FALSE(within(this->ball, this->outside, this->solid, this->origin, T(2.4)));
  EXPECT_TRUE(within(this->ball, this->inside, this->solid, this->origin, T(0)));
  EXPECT_FALSE(distance_up_to(this->ball, this->outside, this->solid, this->origin, T(2.4)).has_value());
  const auto d = distance_up_to(this->ball, this->outside, this->solid, this->origin, T(2.6));
  ASSERT_TRUE(d.has_value());
  EXPECT_EQ(d->distance, brute_force_distance(this->ball, this->outside, this->solid, this->origin));
  std::vector<PieceDistance<T>> near;
  near_pieces(this->ball, this->outside, this->solid, this->origin, T(2.6), near);
  EXPECT_EQ(near.size(), 2u);
}

}  // namespace
}  // namespace graze::testing
