// Solid meshes in a world and in batches.
#include <gtest/gtest.h>

#include <cmath>

#include "common/cube_mesh.hpp"
#include "graze/batch.hpp"
#include "scenario.hpp"

namespace graze::testing {
namespace {

template <class T>
class SolidBodies : public ::testing::Test {
 public:
  /// Fills a world with a cube and what may lie inside it.
  static void fill(World<T>& world, bool solid, const Shape<T>& inside, const Pose<T>& pose) {
    Body<T> body{cube_mesh<T>(T(2), solid)};
    body.fixed = true;
    world.add(body);
    world.add({inside, pose});
    world.update();
  }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SolidBodies, Scalars);

TYPED_TEST(SolidBodies, WhatLiesInsideIsInContact) {
  using T = TypeParam;
  const Pose<T> pose{{T(1), T(0.1), T(0.2)}, {}};
  const Shape<T> shapes[] = {Sphere<T>(T(0.25)), Box<T>({T(0.5), T(0.5), T(0.5)}), cube_mesh<T>(T(0.25), false),
                             Compound<T>({Placed<T>{Sphere<T>(T(0.25)), {}}})};
  for (const Shape<T>& shape : shapes) {
    World<T> hollow, world;
    this->fill(hollow, false, shape, pose);
    EXPECT_TRUE(hollow.contacts().pairs.empty()) << shape.name();
    this->fill(world, true, shape, pose);
    for (int update = 0; update < 3; ++update) {
      const ContactArrays<T>& found = world.contacts();
      ASSERT_EQ(found.pairs.size(), 1u) << shape.name();
      EXPECT_TRUE(found.pairs[0].overlap);
      ASSERT_EQ(found.pairs[0].manifold_count, 1u);
      const auto& manifold = found.manifolds_of(found.pairs[0])[0];
      ASSERT_EQ(manifold.point_count, 1u);
      EXPECT_NEAR(manifold.normal.x, 1, 1e-5) << "from the cube to what leaves it at x = 2";
      EXPECT_NEAR(found.points_of(manifold)[0].distance, T(-1.25), 1e-5);
      world.update();
    }
  }
}

// What comes in from outside begins to touch at the surface and goes on touching all the way through.
TYPED_TEST(SolidBodies, ContactLastsAllTheWayThrough) {
  using T = TypeParam;
  World<T> world;
  this->fill(world, true, Sphere<T>(T(0.25)), {{T(9), T(0), T(0)}, {}});
  const BodyId ball = world.add({Sphere<T>(T(0.25)), {{T(5), T(0), T(0)}, {}}});
  const auto in_contact = [&](T x) {
    world.move(ball, {{x, T(0.1), T(0.2)}, {}});
    world.update();
    return std::any_of(world.contacts().pairs.begin(), world.contacts().pairs.end(),
                       [&](const auto& p) { return p.overlap && (p.a == ball.index || p.b == ball.index); });
  };
  for (int i = -30; i <= 30; ++i) {
    const T x = T(i) / 10;
    EXPECT_EQ(in_contact(x), std::abs(x) <= T(2.25)) << x;
  }
}

TYPED_TEST(SolidBodies, ABatchAnswersAsOneByOne) {
  using T = TypeParam;
  Random random(3);
  std::vector<Shape<T>> solids, shapes;
  std::vector<Pose<T>> at_a, at_b;
  for (int i = 0; i < 300; ++i) {
    const Shape<T> mesh = cube_mesh<T>(T(2), i % 5 != 0);
    solids.push_back(i % 7 == 0 ? Shape<T>(Compound<T>({Placed<T>{mesh, random_pose<T>(random, 1.0f)}})) : mesh);
    at_a.push_back(random_pose<T>(random, 1.0f));
    shapes.push_back(build<T>(random_specimen(static_cast<Kind>(random() % bounded_kinds), 0.5f, random)));
    at_b.push_back(random_pose<T>(random, 4.0f));
  }
  const Batch<T> batch(Bodies<T>(solids, at_a), Bodies<T>(shapes, at_b));
  std::vector<std::uint8_t> touch;
  overlap(batch, touch);
  std::vector<Distance<T>> distances;
  distance(batch, distances);
  BatchContacts<T> found;
  contacts(batch, T(0.1), found);
  int inside = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    EXPECT_EQ(touch[i] != 0, overlap(solids[i], at_a[i], shapes[i], at_b[i]));
    const Distance<T> d = distance(solids[i], at_a[i], shapes[i], at_b[i]);
    EXPECT_EQ(distances[i].distance, d.distance);
    EXPECT_EQ(distances[i].normal, d.normal);
    EXPECT_EQ(distances[i].a, d.a);
    Manifolds<T> manifolds;
    EXPECT_EQ(contacts(solids[i], at_a[i], shapes[i], at_b[i], T(0.1), manifolds), found.pairs[i].overlap);
    ASSERT_EQ(manifolds.size(), found.pairs[i].manifold_count);
    for (std::size_t m = 0; m < manifolds.size(); ++m) {
      const auto& group = found.manifolds_of(i)[m];
      EXPECT_EQ(group.normal, manifolds[m].normal);
      ASSERT_EQ(group.point_count, manifolds[m].points.size());
      for (std::size_t k = 0; k < group.point_count; ++k) {
        EXPECT_EQ(found.points_of(group)[k].a, manifolds[m].points[k].a);
        EXPECT_EQ(found.points_of(group)[k].distance, manifolds[m].points[k].distance);
      }
    }
    inside += d.distance <= T(-0.25);
  }
  EXPECT_GE(inside, 20);
}

}  // namespace
}  // namespace graze::testing
