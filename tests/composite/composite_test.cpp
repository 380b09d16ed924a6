// Composites against brute force over their pieces.
#include <gtest/gtest.h>

#include <limits>

#include "common/cube_mesh.hpp"
#include "composite/brute_force.hpp"
#include "graze/cast.hpp"
#include "graze/raycast.hpp"

namespace graze::testing {
namespace {

/// A bumpy sheet of triangles.
Mesh<double> sheet(Random& random, int n) {
  std::vector<Vec3d> points;
  std::vector<Mesh<double>::Index> triangles;
  for (int r = 0; r <= n; ++r)
    for (int c = 0; c <= n; ++c)
      points.push_back({c - n / 2.0, static_cast<double>(uniform(random, -0.3f, 0.3f)), r - n / 2.0});
  const auto at = [n](int r, int c) { return static_cast<std::uint32_t>(r * (n + 1) + c); };
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) {
      triangles.push_back({at(r, c), at(r + 1, c), at(r, c + 1)});
      triangles.push_back({at(r + 1, c), at(r + 1, c + 1), at(r, c + 1)});
    }
  return {points, triangles};
}

/// A field of bumps with holes in it, as wide as the sheet.
HeightField<double> field(Random& random, std::size_t n) {
  std::vector<double> heights((n + 1) * (n + 1));
  for (double& h : heights)
    h = random() % 12 == 0 ? std::numeric_limits<double>::quiet_NaN()
                           : static_cast<double>(uniform(random, -0.3f, 0.3f));
  heights[0] = heights[1] = heights[n + 1] = heights[n + 2] = 0;  // at least one cell is whole
  return {n + 1, n + 1, heights};
}

Posed random_pose(Random& random, float reach) {
  return {converted<double>(random_vector(random, reach)), normalized(converted<double>(random_rotation(random)))};
}

/// All that can be asked of two shapes, against every piece with every other.
void expect_brute_force(const Shaped& a, const Posed& pa, const Shaped& b, const Posed& pb, double margin) {
  const double expected = brute_force_distance(a, pa, b, pb);
  const Distance<double> d = distance(a, pa, b, pb);
  ASSERT_NEAR(d.distance, expected, 1e-9);
  if (std::abs(d.distance) < 1e6) {
    EXPECT_LT(length(d.b - d.a - d.normal * d.distance), 1e-9);
  }
  if (std::abs(expected) > 1e-9) {
    EXPECT_EQ(overlap(a, pa, b, pb), expected < 0);
  }
  Manifolds<double> manifolds;
  EXPECT_EQ(contacts(a, pa, b, pb, margin, manifolds), d.distance <= 0);
  EXPECT_EQ(manifolds.empty(), d.distance > margin);
  for (const auto& m : manifolds)
    for (const auto& p : m.points) EXPECT_LT(length(p.b - p.a - m.normal * p.distance), 1e-9);
  expect_manifolds(manifolds, brute_force_manifolds(a, pa, b, pb, margin), 1e-8);
}

TEST(Composite, DistanceOverlapAndContactsAgreeWithBruteForce) {
  Random random(1);
  const Shaped mesh = sheet(random, 6), other = sheet(random, 4), bumps = field(random, 5);
  const Shaped compound =
      Compound<double>({{Box<double>({1, 0.5, 1}), {{0.6, 0, 0}, {}}},
                        {Compound<double>({{Sphere<double>(0.4), {{-0.7, 0.2, 0}, {}}}, {other, {{0, -1, 0}, {}}}}),
                         {{0, 0.2, 0}, {}}}});
  const Shaped grounds = Compound<double>({{HalfSpace<double>(), {{0, -1.5, 0}, {}}}, {bumps, {{0.3, 0, 0}, {}}}});
  const Shaped all[] = {
      mesh, other, bumps, compound, grounds, Shaped(Capsule<double>(1, 0.3)), Shaped(HalfSpace<double>(), 0.25)};
  for (int i = 0; i < 12; ++i)
    for (const Shaped& a : all)
      for (const Shaped& b : all) {
        if (a.convex() && b.convex()) continue;
        const bool unbounded = (&a == &all[4] || &a == &all[6]) && (&b == &all[4] || &b == &all[6]);
        if (unbounded) continue;  // two half-spaces that meet have no depth: below
        const Posed pose_a = random_pose(random, 1), pose_b = random_pose(random, 3);
        expect_brute_force(a, pose_a, b, pose_b, 0.1);
      }
}

// Two surfaces in many relative poses: apart, touching, through each other.
TEST(Composite, TwoSurfacesInManyPoses) {
  Random random(2);
  const Shaped surfaces[] = {sheet(random, 5), field(random, 4), field(random, 1)};
  for (int i = 0; i < 150; ++i) {
    const Shaped &a = surfaces[i % 3], &b = surfaces[(i / 3) % 3];
    expect_brute_force(a, {}, b, random_pose(random, 4), 0.05);
  }
}

// Contacts are settled among the pieces of one shape before those of the other, and do not tell which was named first.
TEST(Composite, ContactsOfTwoCompositesAreMirroredByASwap) {
  Random random(6);
  const Shaped field_of_cells = field(random, 4);
  const Shaped cube = cube_mesh<double>(1, false);
  const Shaped shapes[] = {sheet(random, 5), cube, Compound<double>({{cube, {}}, {field_of_cells, {}}})};
  std::size_t touching = 0;
  for (int i = 0; i < 300; ++i) {
    const Shaped &a = shapes[i % 3], &b = shapes[(i / 3) % 3];
    const Posed pose_a = random_pose(random, 1), pose_b = random_pose(random, 2);
    Manifolds<double> found, swapped;
    contacts(a, pose_a, b, pose_b, 0.02, found);
    contacts(b, pose_b, a, pose_a, 0.02, swapped);
    ASSERT_EQ(found.size(), swapped.size());
    touching += !found.empty();
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].normal, -swapped[k].normal);
      EXPECT_EQ(found[k].piece_a, swapped[k].piece_b);
      EXPECT_EQ(found[k].piece_b, swapped[k].piece_a);
      ASSERT_EQ(found[k].points.size(), swapped[k].points.size());
      for (std::size_t j = 0; j < found[k].points.size(); ++j) {
        EXPECT_EQ(found[k].points[j].a, swapped[k].points[j].b);
        EXPECT_EQ(found[k].points[j].distance, swapped[k].points[j].distance);
      }
    }
  }
  EXPECT_GT(touching, 100u);
}

/// A place in the cube of side 2 about the origin, in tenths, so that many edges and corners meet.
Vec3d tenth(Random& random) {
  const auto number = [&] { return static_cast<int>(random() % 21) / 10.0 - 1; };
  return {number(), number(), number()};
}

Shaped small_mesh(Random& random, std::vector<Mesh<double>::Index> triangles) {
  std::vector<Vec3d> points;
  for (int i = 0; i < 4; ++i) points.push_back(tenth(random));
  return Mesh<double>(points, std::move(triangles));
}

Shaped small_composite(Random& random) {
  if (random() % 3 == 0) return small_mesh(random, {{0, 1, 2}, {1, 3, 2}});
  if (random() % 2 == 0) return small_mesh(random, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  std::vector<Placed<double>> boxes;
  for (int i = 0; i < 3; ++i) boxes.push_back({Box<double>({0.6, 0.4, 0.8}), {tenth(random), {}}});
  return Compound<double>(std::move(boxes));
}

// The last resort joins the others as they join each other.
TEST(Composite, NoTwoManifoldsHaveOneNormal) {
  Random random(32);
  std::size_t several = 0;
  for (int i = 0; i < 20000; ++i) {
    const Shaped a = small_composite(random), b = small_composite(random);
    Manifolds<double> manifolds;
    contacts(a, {}, b, {tenth(random) / 2.0, {}}, 0.0, manifolds);
    several += manifolds.size() > 1;
    for (std::size_t k = 1; k < manifolds.size(); ++k)
      for (std::size_t j = 0; j < k; ++j) EXPECT_NE(manifolds[j].normal, manifolds[k].normal) << "pair " << i;
  }
  EXPECT_GT(several, 1000u);
}

// What is only near is told besides what touches, and never in its place.
TEST(Composite, WhatTouchesHasAPointThatDoesWhateverTheMargin) {
  Random random(31);
  int touching = 0;
  for (int i = 0; i < 4000; ++i) {
    const Shaped a = small_composite(random), b = small_composite(random);
    const Posed pose{tenth(random) / 2.0, {}};
    if (!overlap(a, {}, b, pose)) continue;
    ++touching;
    for (const double margin : {0.0, 0.05}) {
      Manifolds<double> manifolds;
      EXPECT_TRUE(contacts(a, {}, b, pose, margin, manifolds));
      double deepest = 1;
      for (const auto& m : manifolds)
        for (const auto& p : m.points) deepest = std::min(deepest, p.distance);
      EXPECT_LE(deepest, 1e-15) << "pair " << i << ", margin " << margin;
    }
  }
  EXPECT_GT(touching, 2000);
}

// Compounds in compounds, with half-spaces among the children.
TEST(Composite, TwoNestedCompounds) {
  Random random(3);
  const auto nested = [&](auto& self, int depth) -> Shaped {
    std::vector<Placed<double>> children;
    const std::size_t count = 1 + random() % 12;
    for (std::size_t i = 0; i < count; ++i) {
      const Posed pose = random_pose(random, 2);
      if (depth > 0 && random() % 4 == 0)
        children.push_back({self(self, depth - 1), pose});
      else if (random() % 8 == 0)
        children.push_back({field(random, 2), pose});
      else
        children.push_back({build<double>(random_specimen(static_cast<Kind>(random() % 4), 0.6f, random)), pose});
    }
    return Compound<double>(std::move(children));
  };
  for (int i = 0; i < 60; ++i) {
    const Shaped a = nested(nested, 2), b = nested(nested, 2);
    expect_brute_force(a, random_pose(random, 1), b, random_pose(random, 7), 0.1);
  }
}

TEST(Composite, HalfSpacesInCompoundsMeetWhereverTheyAre) {
  const Shaped ground = Compound<double>({{HalfSpace<double>(), {}}, {Box<double>({1, 1, 1}), {{0, -9, 0}, {}}}});
  const Posed down{{0, 2, 0}, Quatd::from_axis_angle({1, 0, 0}, std::acos(-1.0))}, far{{1e6, 0, 0}, {}};
  EXPECT_FALSE(overlap(ground, {}, Shaped(HalfSpace<double>()), down));
  EXPECT_TRUE(overlap(ground, {}, ground, far));
  EXPECT_TRUE(overlap(ground, far, Shaped(Sphere<double>(1)), {}));
}

// Slivers, segments, points and equal triangles: what a scanner leaves behind.
TEST(Composite, DegenerateTriangles) {
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    std::vector<Vec3d> points;
    for (int k = 0; k < 8; ++k)
      points.push_back({0.5 * static_cast<double>(random() % 3), 0.5 * static_cast<double>(random() % 3),
                        0.5 * static_cast<double>(random() % 3)});
    std::vector<Mesh<double>::Index> triangles;
    for (int k = 0; k < 12; ++k) {
      const auto at = [&] { return static_cast<std::uint32_t>(random() % 8); };
      triangles.push_back({at(), at(), at()});
      if (random() % 3 == 0) triangles.push_back(triangles.back());
    }
    const Shaped mesh = Mesh<double>(points, triangles);
    const Posed pose = random_pose(random, 1.5f);
    const Shaped other = i % 2 == 0 ? mesh : Shaped(Box<double>({0.5, 0.5, 0.5}));
    ASSERT_NEAR(distance(mesh, {}, other, pose).distance, brute_force_distance(mesh, {}, other, pose), 1e-9);
    Manifolds<double> manifolds;
    const bool touch = contacts(mesh, {}, other, pose, 0.0, manifolds);
    EXPECT_EQ(manifolds.empty(), !touch);
  }
}

// Sixteen thousand triangles piled on a point meet as many: one pair tells all.
TEST(Composite, PiledTrianglesCountOnce) {
  const std::vector<Vec3d> points{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  std::vector<Mesh<double>::Index> piled(16384, {0, 0, 0}), equal(16384, {0, 1, 2});
  for (const auto& triangles : {piled, equal}) {
    const Shaped mesh = Mesh<double>(points, triangles);
    Manifolds<double> manifolds;
    EXPECT_TRUE(contacts(mesh, {}, mesh, {}, 0.0, manifolds));
    EXPECT_EQ(manifolds.size(), 1u);
    EXPECT_EQ(distance(mesh, {}, mesh, {{0, 2, 0}, {}}).distance, 2);
  }
}

// Answers do not depend on the scale, also of fields and meshes far from their own origin.
template <class T>
void expect_brute_force_at(T scale, const Vec3<T>& offset) {
  Random random(5);
  std::vector<Vec3<T>> points;
  for (int r = 0; r < 5; ++r)
    for (int c = 0; c < 5; ++c)
      points.push_back((Vec3<T>{T(c), T(uniform(random, -0.3f, 0.3f)), T(r)} + offset) * scale);
  std::vector<typename Mesh<T>::Index> triangles;
  for (std::uint32_t i = 0; i < 19; ++i)
    if (i % 5 != 4) triangles.push_back({i, i + 6, i + 1}), triangles.push_back({i, i + 5, i + 6});
  const Shape<T> mesh = Mesh<T>(points, triangles), ball = Sphere<T>(T(0.4) * scale);
  const T size = (length(offset) + T(6)) * scale;
  for (int i = 0; i < 40; ++i) {
    const Vec3<T> at = (converted<T>(random_vector(random, 1)) * T(3) + Vec3<T>{T(2), T(0), T(2)} + offset) * scale;
    for (const bool round : {false, true}) {
      const Shape<T>& other = round ? ball : mesh;
      const Pose<T> where{round ? at : at - offset * scale, {}};
      const T expected = brute_force_distance(mesh, {}, other, where);
      EXPECT_NEAR(distance(mesh, {}, other, where).distance, expected, tolerance<T> * size);
      Manifolds<T> manifolds;
      const bool touch = contacts(mesh, {}, other, where, T(0), manifolds);
      if (std::abs(expected) > tolerance<T> * size) {
        EXPECT_EQ(touch, expected < T(0));
      }
    }
  }
}
TEST(Composite, AnyScaleAndFarFromTheOrigin) {
  for (const double scale : {1e-4, 1.0, 1e4}) {
    for (const double offset : {0.0, 1000.0}) {
      expect_brute_force_at<double>(scale, {offset, 0, -offset});
      expect_brute_force_at<float>(static_cast<float>(scale), {static_cast<float>(offset), 0, 0});
    }
  }
}

// The triangles of a flat floor share a normal, and so one manifold, each point once.
TEST(Composite, PiecesThatShareANormalShareAManifold) {
  std::vector<Vec3d> points;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) points.push_back({c - 1.0, 0, r - 1.0});
  std::vector<Mesh<double>::Index> triangles;
  for (std::uint32_t r = 0; r < 2; ++r)
    for (std::uint32_t c = 0; c < 2; ++c) {
      const std::uint32_t i = 3 * r + c;
      triangles.push_back({i, i + 3, i + 1});
      triangles.push_back({i + 3, i + 4, i + 1});
    }
  Manifolds<double> manifolds;
  contacts<double>(Mesh<double>(points, triangles), {}, Box<double>({1, 1, 1}), {{0.1, 0.49, 0.1}, {}}, 0, manifolds);
  ASSERT_EQ(manifolds.size(), 1u);
  EXPECT_NEAR(manifolds[0].normal.y, 1, 1e-12);
  for (const auto& p : manifolds[0].points) EXPECT_NEAR(p.distance, -0.01, 1e-12);
}

// Every level is looked at a few times and not each time anew for the level below.
TEST(Composite, CompoundsNestAsDeepAsWished) {
  Shaped nested = Sphere<double>(0.5);
  const Quatd turn = Quatd::from_axis_angle({1, 0, 0}, 0.3);
  for (int i = 0; i < 300; ++i) nested = Compound<double>({{nested, {{0.01, 0, 0}, turn}}});
  EXPECT_NEAR(distance(nested, {}, Shaped(Sphere<double>(0.5)), {}).distance, 2, 1e-9);
  EXPECT_NEAR(distance(nested, {}, nested, {{0, 4, 0}, turn}).distance, 3, 1e-9);
  EXPECT_NEAR(closest(nested, {}, {0, 0, 0}).distance, 2.5, 1e-9);
  EXPECT_TRUE(overlap(nested, {}, nested, {{0, 0.5, 0}, {}}));
}

// Deeper than the stack would hold: twenty thousand compounds, each a hair aside of the one in it.
TEST(Composite, DeepNestingNeedsNoStack) {
  Shaped nested = Box<double>({1, 1, 1});
  constexpr int depth = 20000;
  for (int i = 0; i < depth; ++i) nested = Compound<double>({{nested, {{0.0001, 0, 0}, {}}}});
  Shaped beside = nested;
  EXPECT_NEAR(distance(nested, {}, beside, {{4, 0, 0}, {}}).distance, 3, 1e-9);
  EXPECT_NEAR(distance(nested, {}, Shaped(Box<double>({1, 1, 1})), {}).distance, 1, 1e-9);
  Manifolds<double> manifolds;
  contacts(nested, {}, beside, {{0, 0.75, 0}, {}}, 0.0, manifolds);
  ASSERT_EQ(manifolds.size(), 1u);
  EXPECT_EQ(manifolds[0].points.size(), 4u);
  const auto hit = raycast(nested, {}, {{2, 5, 0}, {0, -1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 4.5, 1e-9);
  const auto met = cast(nested, {}, {}, beside, {{9, 0, 0}, {}}, {{-16, 0, 0}, {}}, 1.0);
  ASSERT_TRUE(met);
  EXPECT_NEAR(met->t, 0.5, 1e-8);
}

// A shape may stand in compounds any number of times: they may hold more of them than memory would when taken apart.
TEST(Composite, ShapesBeyondNumberAreRefusedWhereTheyWouldBeTakenApart) {
  const auto many = [](const Shaped& shape) {
    std::vector<Placed<double>> children;
    for (int i = 0; i < 2100; ++i) children.push_back({shape, {{1.0 * i, 0, 0}, {}}});
    return Shaped(Compound<double>(std::move(children)));
  };
  Shaped nested = many(many(Sphere<double>(0.5)));
  for (int i = 2; i < 32; ++i) nested = Compound<double>({{nested, {}}});
  EXPECT_TRUE(overlap(nested, {}, Shaped(Sphere<double>(0.5)), {{2.5, 0, 0}, {}}));
  try {
    nested = Compound<double>({{nested, {}}});
    ADD_FAILURE();
  } catch (const InvalidValue& e) {
    EXPECT_STREQ(e.what(), "children[0]: expected compounds nested at most 32 deep, or of at most 4194304 shapes, got "
                           "4410000 in 33");
  }
}

// A one-sided floor carries what lies on it and lets through what comes from below; geometry knows no sides.
TEST(Composite, OneSidedSurfacesPushFromTheirFrontAlone) {
  const std::vector<Vec3d> points{{-2, 0, -2}, {2, 0, -2}, {-2, 0, 2}, {2, 0, 2}};
  const std::vector<Mesh<double>::Index> up{{0, 3, 1}, {0, 2, 3}};
  const std::vector<double> level(4, 0.0);
  const Shaped ball = Sphere<double>(1), other = Mesh<double>(points, up);
  for (const Shaped& floor :
       {Shaped(Mesh<double>(points, up, Sides::front)), Shaped(HeightField<double>(2, 2, level, 4, 4, Sides::front)),
        Shaped(Compound<double>({{Mesh<double>(points, up, Sides::front), {}}}))}) {
    Manifolds<double> manifolds;
    EXPECT_TRUE(contacts(floor, {}, ball, {{1, 0.9, -1}, {}}, 0.0, manifolds));
    ASSERT_EQ(manifolds.size(), 1u);
    EXPECT_NEAR(manifolds[0].normal.y, 1, 1e-12);
    EXPECT_TRUE(contacts(ball, {{1, 0.9, -1}, {}}, floor, {}, 0.0, manifolds));
    manifolds.clear();
    const Posed below{{1, -0.9, -1}, {}};
    EXPECT_FALSE(contacts(floor, {}, ball, below, 0.0, manifolds));
    EXPECT_FALSE(contacts(ball, below, floor, {}, 0.0, manifolds));
    EXPECT_TRUE(manifolds.empty());
    EXPECT_TRUE(overlap(floor, {}, ball, below));
    EXPECT_NEAR(distance(floor, {}, ball, below).distance, -0.1, 1e-12);
  }
  Manifolds<double> manifolds;
  EXPECT_TRUE(contacts(other, {}, ball, {{1, -0.9, -1}, {}}, 0.0, manifolds));
}

TEST(Mesh, NamesWhatItCannotTake) {
  const std::vector<Vec3d> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  try {
    const Mesh<double> mesh(points, {{0, 1, 3}});
    FAIL();
  } catch (const InvalidValue& e) {
    EXPECT_STREQ(e.what(), "triangles[0][2]: expected an index below 3, got 3");
  }
  EXPECT_THROW(Mesh<double>(points, {}), InvalidValue);
  EXPECT_THROW(Compound<double>({}), InvalidValue);
  EXPECT_THROW(Shaped(Mesh<double>(points, {{0, 1, 2}}), 0.5), InvalidValue);
}

}  // namespace
}  // namespace graze::testing
