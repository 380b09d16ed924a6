// Composites against brute force over their pieces.
#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "graze/query.hpp"

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

std::vector<Placed<double>> pieces(const Shaped& shape, const Posed& pose) {
  std::vector<Placed<double>> out;
  if (const auto* mesh = shape.as<Mesh<double>>()) {
    for (const auto& t : mesh->triangles())
      out.push_back({Triangle<double>(mesh->points()[t[0]], mesh->points()[t[1]], mesh->points()[t[2]]), pose});
  } else if (const auto* compound = shape.as<Compound<double>>()) {
    for (const auto& child : compound->children())
      for (auto& p : pieces(child.shape, compose(pose, child.pose))) out.push_back(p);
  } else {
    out.push_back({shape, pose});
  }
  return out;
}

double brute_force(const Shaped& a, const Posed& pa, const Shaped& b, const Posed& pb) {
  double least = 1e300;
  for (const auto& p : pieces(a, pa))
    for (const auto& q : pieces(b, pb)) least = std::min(least, distance(p.shape, p.pose, q.shape, q.pose).distance);
  return least;
}

TEST(Composite, DistanceOverlapAndContactsAgreeWithBruteForce) {
  Random random(1);
  const Shaped mesh = sheet(random, 6), other = sheet(random, 4);
  const Shaped compound =
      Compound<double>({{Box<double>({1, 0.5, 1}), {{0.6, 0, 0}, {}}},
                        {Compound<double>({{Sphere<double>(0.4), {{-0.7, 0.2, 0}, {}}}, {other, {{0, -1, 0}, {}}}}),
                         {{0, 0.2, 0}, {}}}});
  const Shaped all[] = {mesh, other, compound, Shaped(Capsule<double>(1, 0.3)), Shaped(HalfSpace<double>())};
  for (int i = 0; i < 60; ++i)
    for (const Shaped& a : all)
      for (const Shaped& b : all) {
        if (a.convex() && b.convex()) continue;
        const Posed pa{cast<double>(random_vector(random, 1)), normalized(cast<double>(random_rotation(random)))};
        const Posed pb{cast<double>(random_vector(random, 3)), normalized(cast<double>(random_rotation(random)))};
        const double expected = brute_force(a, pa, b, pb);
        const Distance<double> d = distance(a, pa, b, pb);
        ASSERT_NEAR(d.distance, expected, 1e-9);
        EXPECT_LT(length(d.b - d.a - d.normal * d.distance), 1e-9);
        if (std::abs(expected) > 1e-9) {
          EXPECT_EQ(overlap(a, pa, b, pb), expected < 0);
        }
        Manifolds<double> manifolds;
        EXPECT_EQ(contacts(a, pa, b, pb, 0.1, manifolds), d.distance <= 0);
        EXPECT_EQ(manifolds.empty(), d.distance > 0.1);
        for (const auto& m : manifolds)
          for (const auto& p : m.points) EXPECT_LT(length(p.b - p.a - m.normal * p.distance), 1e-9);
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
