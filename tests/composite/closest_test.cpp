// The nearest point and the side of composites: against every triangle, and against the winding number.
#include <gtest/gtest.h>

#include <cmath>

#include "composite/brute_force.hpp"
#include "composite/surface_point.hpp"

namespace graze::testing {
namespace {

/// An octahedron whose triangles are split into four `depth` times, each vertex as far from the origin as `radius`
/// tells.
template <class Radius>
Mesh<double> star(int depth, const Radius& radius) {
  std::vector<Vec3d> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Mesh<double>::Index> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                             {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int i = 0; i < depth; ++i) {
    std::vector<Mesh<double>::Index> finer;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const Vec3d p = normalized(points[a] + points[b]);
      const auto at = std::find(points.begin(), points.end(), p);
      if (at == points.end()) return points.push_back(p), static_cast<std::uint32_t>(points.size() - 1);
      return static_cast<std::uint32_t>(at - points.begin());
    };
    for (const auto& t : triangles) {
      const std::uint32_t a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
    }
    triangles = finer;
  }
  for (Vec3d& p : points) p = p * radius(p);
  return {points, triangles};
}

/// How often the mesh winds about a point: the solid angles of its triangles (van Oosterom, Strackee 1983).
double winding_number(const Mesh<double>& mesh, const Vec3d& p) {
  double sum = 0;
  for (const auto& t : mesh.triangles()) {
    const Vec3d a = mesh.points()[t[0]] - p, b = mesh.points()[t[1]] - p, c = mesh.points()[t[2]] - p;
    const double la = length(a), lb = length(b), lc = length(c);
    sum += 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (4 * std::acos(-1.0));
}

double unsigned_distance(const Mesh<double>& mesh, const Vec3d& p) {
  double least = 1e300;
  for (const auto& t : mesh.triangles()) {
    const auto at = closest_point_on_triangle(mesh.points()[t[0]], mesh.points()[t[1]], mesh.points()[t[2]], p);
    least = std::min(least, length(at.point - p));
  }
  return least;
}

TEST(ClosestMath, TheAngleIsThatOfTheArcTangent) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d a = converted<double>(random_vector(random, 1)), b = converted<double>(random_vector(random, 1));
    EXPECT_NEAR(angle_between(a, b), std::atan2(length(cross(a, b)), dot(a, b)), 2e-15);
  }
  EXPECT_EQ(angle_between({1, 0, 0}, {2, 0, 0}), 0);
  EXPECT_NEAR(angle_between({1, 0, 0}, {-2, 0, 0}), std::acos(-1.0), 1e-15);
  EXPECT_EQ(angle_between({0, 0, 0}, {0, 0, 0}), 0);
}

// Spikes and pits: near them an edge or a vertex is nearest, whose faces lie on both sides of the point.
TEST(Closest, OfAClosedMeshIsNegativeInside) {
  Random random(2);
  for (int i = 0; i < 12; ++i) {
    const Mesh<double> mesh = star(2, [&](const Vec3d&) { return static_cast<double>(uniform(random, 0.3f, 1.5f)); });
    ASSERT_TRUE(mesh.closed());
    const Posed pose{converted<double>(random_vector(random, 5)),
                     normalized(converted<double>(random_rotation(random)))};
    for (int k = 0; k < 300; ++k) {
      const Vec3d p = converted<double>(random_vector(random, 1.4f));
      const Vec3d q = transform(pose, p);
      const Closest<double> c = closest<double>(mesh, pose, q);
      const bool inside = winding_number(mesh, p) > 0.5;
      ASSERT_NEAR(c.distance, unsigned_distance(mesh, p) * (inside ? -1 : 1), 1e-10);
      EXPECT_LT(length(q - c.point - c.normal * c.distance), 1e-10);
      EXPECT_NEAR(length(c.normal), 1, 1e-12);
    }
  }
}

/// A box of two by one by a half as its twelve triangles.
template <class T>
Mesh<T> box_of_triangles(T scale) {
  std::vector<Vec3<T>> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(Vec3<T>{i & 1 ? T(1) : T(-1), i & 2 ? T(0.5) : T(-0.5), i & 4 ? T(0.25) : T(-0.25)} * scale);
  std::vector<typename Mesh<T>::Index> triangles;
  for (const auto& [a, b, c, d] : std::vector<std::array<std::uint32_t, 4>>{
           {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  return {corners, triangles};
}

// The same solid as a box and as triangles, inside and out, at any scale.
template <class T>
void expect_as_box(T scale) {
  Random random(3);
  const Shape<T> mesh = box_of_triangles(scale), box = Box<T>(Vec3<T>{T(2), T(1), T(0.5)} * scale);
  for (int i = 0; i < 500; ++i) {
    const Vec3<T> p = converted<T>(random_vector(random, 1.5f)) * scale;
    const Closest<T> expected = closest(box, {}, p), found = closest(mesh, {}, p);
    EXPECT_NEAR(found.distance, expected.distance, tolerance<T> * scale);
    EXPECT_LT(length(p - found.point - found.normal * found.distance), tolerance<T> * scale);
  }
}
TEST(Closest, OfABoxOfTrianglesIsThatOfTheBox) {
  for (const double scale : {1e-4, 1.0, 1e4}) {
    expect_as_box<double>(scale);
    expect_as_box<float>(static_cast<float>(scale));
  }
}

// On the surface the normal is that of the face, the edge, the corner.
TEST(Closest, OnTheSurfaceHasTheSurfacesNormal) {
  const Shaped mesh = box_of_triangles(1.0);
  const auto normal_at = [&](const Vec3d& p) {
    const Closest<double> c = closest(mesh, {}, p);
    EXPECT_NEAR(c.distance, 0, 1e-15);
    return c.normal;
  };
  EXPECT_LT(length(normal_at({0.3, 0.5, 0.1}) - Vec3d{0, 1, 0}), 1e-15);
  EXPECT_LT(length(normal_at({0, 0, 0.25}) - Vec3d{0, 0, 1}), 1e-15);  // on a diagonal
  EXPECT_LT(length(normal_at({0.2, 0.5, 0.25}) - normalized(Vec3d{0, 1, 1})), 1e-15);
  EXPECT_LT(length(normal_at({1, 0.5, 0.25}) - normalized(Vec3d{1, 1, 1})), 1e-14);
}

// An open mesh and a height field are surfaces: no side of them is inside.
TEST(Closest, OfASurfaceIsNeverNegative) {
  const Mesh<double> whole = box_of_triangles(1.0);
  const Shaped open = Mesh<double>({whole.points().begin(), whole.points().end()},
                                   {whole.triangles().begin(), whole.triangles().end() - 1});
  EXPECT_NEAR(closest(open, {}, {0, 0, 0}).distance, 0.25, 1e-15);
  const Shaped field = HeightField<double>(2, 2, {0, 0, 0, 0});
  EXPECT_NEAR(closest(field, {}, {0.1, -2, 0.1}).distance, 2, 1e-15);
  EXPECT_NEAR(closest(field, {}, {0.1, -2, 0.1}).normal.y, -1, 1e-15);
}

TEST(Closest, OfACompoundIsTheLeastOfItsChildren) {
  const Shaped mesh = box_of_triangles(1.0);
  const Shaped inner = Compound<double>({{mesh, {{3, 0, 0}, {}}}, {Sphere<double>(0.5), {{3, 0, 0}, {}}}});
  const Shaped compound = Compound<double>({{inner, {}}, {HalfSpace<double>(), {{0, -2, 0}, {}}}});
  EXPECT_NEAR(closest(compound, {}, {3, 0, 0}).distance, -0.5, 1e-12);    // deepest in the ball
  EXPECT_NEAR(closest(compound, {}, {3.8, 0, 0}).distance, -0.2, 1e-12);  // only in the box
  EXPECT_NEAR(closest(compound, {}, {-5, -1, 0}).distance, 1, 1e-12);
  EXPECT_NEAR(closest(compound, {}, {-5, -3, 0}).distance, -1, 1e-12);
}

}  // namespace
}  // namespace graze::testing
