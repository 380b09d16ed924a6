// Solid meshes: what lies wholly inside touches; and the questions with a limit.
#include <gtest/gtest.h>

#include "common/cube_mesh.hpp"
#include "composite/brute_force.hpp"
#include "graze/cast.hpp"
#include "graze/raycast.hpp"

namespace graze::testing {
namespace {

template <class T>
class Solid : public ::testing::Test {
 public:
  static constexpr T noise = T(1e-5);

  const Shape<T> solid = cube_mesh(T(2), true), hollow = cube_mesh(T(2), false), ball = Sphere<T>(T(0.5));
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
    const Shape<T> small = cube_mesh(T(0.25), filled);
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

/// With its middle inside, the surface would pull a body in by the shorter way. It comes out at the nearest side, as it
/// does of a box.
TYPED_TEST(Solid, WhatPokesOutIsPushedOut) {
  using T = TypeParam;
  const Shape<T> bodies[] = {this->ball, Box<T>({T(1), T(1), T(1)}), Capsule<T>(T(0.4), T(0.3))};
  for (const Sides sides : {Sides::both, Sides::front})
    for (const bool child : {false, true})
      for (const Shape<T>& body : bodies)
        for (const T height : {T(2.3), T(2.01), T(1.99), T(1.6)})
          for (const bool swapped : {false, true}) {
            const auto* mesh = this->solid.template as<Mesh<T>>();
            const Shape<T> one_sided = Mesh<T>({mesh->points().begin(), mesh->points().end()},
                                               {mesh->triangles().begin(), mesh->triangles().end()}, sides, true);
            const Shape<T> block = child ? Shape<T>(Compound<T>({{one_sided, {}}})) : one_sided;
            const Pose<T> at{{T(0.1), height, T(0.3)}, {}};
            SCOPED_TRACE(::testing::Message() << body.name() << " at " << height << (child ? ", a child" : ""));
            Manifolds<T> manifolds;
            EXPECT_TRUE(swapped ? contacts(body, at, block, this->origin, T(0), manifolds)
                                : contacts(block, this->origin, body, at, T(0), manifolds));
            ASSERT_FALSE(manifolds.empty());
            T deepest(0);
            for (const Manifold<T>& m : manifolds) {
              EXPECT_NEAR(m.normal.y, swapped ? -1 : 1, this->noise);
              for (const ContactPoint<T>& p : m.points) {
                deepest = std::min(deepest, p.distance);
                EXPECT_LE(max_abs(p.b - p.a - m.normal * p.distance), this->noise);
              }
            }
            EXPECT_NEAR(deepest, height - T(2.5), this->noise);
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

// A body that starts inside gets out where separating bodies are ignored, but not deeper in, and not in from outside.
TYPED_TEST(Solid, WhatLeavesIsNotMetFromWithin) {
  using T = TypeParam;
  const Shape<T> compound = Compound<T>({Placed<T>{this->solid, this->origin}}), box = Box<T>({T(1), T(0.6), T(0.4)});
  const auto met = [&](const Shape<T>& mesh, const Shape<T>& body, const Pose<T>& pose, const Velocity<T>& velocity,
                       bool swapped, Separating separating) {
    return swapped ? cast<T>(mesh, this->origin, {}, body, pose, velocity, T(1), {separating})
                   : cast<T>(body, pose, velocity, mesh, this->origin, {}, T(1), {separating});
  };
  const Velocity<T> out{{T(9), T(0.5), T(0)}, {}}, turning{{T(9), T(0), T(0)}, {T(1), T(2), T(3)}},
      in{{T(-9), T(0), T(0)}, {}};
  for (const bool swapped : {false, true})
    for (const Shape<T>& body : {this->ball, box}) {
      for (const Velocity<T>& velocity : {out, turning}) {
        for (const Shape<T>& mesh : {this->solid, compound}) {
          EXPECT_FALSE(met(mesh, body, this->inside, velocity, swapped, Separating::ignored)) << body.name();
          const auto hit = met(mesh, body, this->inside, velocity, swapped, Separating::hit);
          ASSERT_TRUE(hit);
          EXPECT_EQ(hit->t, T(0));
        }
        // Both sides of a surface count.
        const auto wall = met(this->hollow, body, this->inside, velocity, swapped, Separating::ignored);
        ASSERT_TRUE(wall) << body.name();
        EXPECT_GT(wall->t, T(0));
        EXPECT_LT(wall->t, T(0.1));
      }
      const auto deeper = met(this->solid, body, this->inside, in, swapped, Separating::ignored);
      ASSERT_TRUE(deeper);
      EXPECT_EQ(deeper->t, T(0));
      const auto entering = met(this->solid, body, this->outside, in, swapped, Separating::ignored);
      ASSERT_TRUE(entering);
      EXPECT_GT(entering->t, T(0.2));
      EXPECT_LT(entering->t, T(0.3));
    }
}

// What is inside is explained by the way out, and not by the nearest piece of the surface.
TYPED_TEST(Solid, ExplainedByTheWayOut) {
  using T = TypeParam;
  const Shape<T> compound = Compound<T>({Placed<T>{this->solid, this->origin}});
  for (const Shape<T>& mesh : {this->solid, compound})
    for (const bool swapped : {false, true}) {
      const Shape<T>&a = swapped ? mesh : this->ball, &b = swapped ? this->ball : mesh;
      const Pose<T>&at_a = swapped ? this->origin : this->inside, &at_b = swapped ? this->inside : this->origin;
      Trace of_overlap, of_distance, of_contacts;
      Manifolds<T> manifolds;
      EXPECT_TRUE(overlap(a, at_a, b, at_b, &of_overlap));
      EXPECT_NEAR(distance(a, at_a, b, at_b, &of_distance).distance, T(-1.5), this->noise);
      EXPECT_TRUE(contacts(a, at_a, b, at_b, T(0.1), manifolds, &of_contacts));
      for (const Trace& trace : {of_overlap, of_distance, of_contacts}) {
        ASSERT_EQ(trace.axes.size(), 1u);
        const TraceAxis& axis = trace.axes[0];
        EXPECT_EQ(axis.name, "way out");
        EXPECT_NEAR(axis.direction.x, swapped ? 1 : -1, 1e-5);
        EXPECT_NEAR(axis.overlap(), 1.5, 1e-5);
        // The ball from 0.5 to 1.5, the cube from -2 to 2, along x or against it.
        EXPECT_NEAR(axis.a_lower, swapped ? -2 : -1.5, 1e-5);
        EXPECT_NEAR(axis.b_upper, swapped ? 1.5 : 2, 1e-5);
      }
    }
}

}  // namespace
}  // namespace graze::testing
