// The separating-axis test against closed forms, by symmetry, and against the signed distance, which finds its
// directions in another way.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "distance.hpp"
#include "separating_axes.hpp"

namespace graze::reference {
namespace {

using Point = Vector;

constexpr Real tight = 1e-17L;
// The answers of the reference's two methods may differ where this one takes close axes for the same.
constexpr Real loose = 1e-15L;

struct Pose {
  Vector translation;
  Quaternion rotation;
};

// EXPECT_NEAR compares doubles.
#define EXPECT_CLOSE(x, y, tolerance)                                                                                  \
  EXPECT_LE(std::fabs((x) - (y)), tolerance) << #x " = " << (x) << ", " #y " = " << (y)

void expect_along(const Point& n, const Point& expected, Real tolerance = tight) {
  EXPECT_CLOSE(n.x, expected.x, tolerance);
  EXPECT_CLOSE(n.y, expected.y, tolerance);
  EXPECT_CLOSE(n.z, expected.z, tolerance);
}

// Not the standard distributions, whose sequence differs between libraries.
class Random {
 public:
  double uniform(double lo, double hi) { return lo + (hi - lo) * static_cast<double>(engine_() >> 11) * 0x1p-53; }
  Vector vector(double r) {
    const double x = uniform(-r, r), y = uniform(-r, r), z = uniform(-r, r);
    return {x, y, z};
  }
  // Not of unit length: the reference is to see to that.
  Pose pose(double r) {
    const Vector t = vector(r), q = vector(1);
    return {t, {q.x, q.y, q.z, uniform(-1, 1)}};
  }
  Point size() { return vector(0.5) + Point{1, 1, 1}; }
  std::vector<Point> points(int count) {
    std::vector<Point> p;
    for (int i = 0; i < count; ++i) p.push_back(vector(1));
    return p;
  }

 private:
  std::mt19937_64 engine_{20240607};
};

Placed place(const Shape& shape, const Pose& pose) { return place(shape, pose.translation, pose.rotation); }
Polyhedron moved(const Polyhedron& polyhedron, const Pose& pose) {
  return moved(polyhedron, pose.translation, pose.rotation);
}

std::vector<Point> octahedron(Real r) { return {{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}}; }

Polyhedron cube_turned(const Vector& axis, const Vector& translation) {
  const Real half = std::numbers::pi_v<Real> / 8, s = std::sin(half);
  return moved(polyhedron_of_box({1, 1, 1}), translation, {s * axis.x, s * axis.y, s * axis.z, std::cos(half)});
}

TEST(SeparatingAxes, FacesAreCounterClockwise) {
  Random random;
  for (const Polyhedron& p :
       {polyhedron_of_box({1, 2, 3}), polyhedron_of_hull(octahedron(1)), polyhedron_of_hull(random.points(20))}) {
    Point middle{};
    for (const Point& v : p.vertices) middle = middle + v * (1 / static_cast<Real>(p.vertices.size()));
    for (const std::vector<int>& face : p.faces) {
      const Point u = p.vertices[face[0]], v = p.vertices[face[1]], w = p.vertices[face[2]];
      EXPECT_GT(dot(cross(v - u, w - u), u - middle), 0);
    }
  }
  EXPECT_EQ(polyhedron_of_hull(octahedron(1)).faces.size(), 8U);
}

TEST(SeparatingAxes, AlignedBoxes) {
  const Polyhedron cube = polyhedron_of_box({1, 1, 1});
  const AxisResult r = separating_axes(cube, moved(cube, {0.9L, 0, 0}, {}));
  EXPECT_TRUE(r.overlap);
  EXPECT_EQ(r.gap, 0);
  EXPECT_CLOSE(r.depth, 0.1L, tight);
  expect_along(r.normal, {1, 0, 0});
  EXPECT_CLOSE(r.runner_up, 1, tight);

  // Concentric: the other side of the same axis is as near.
  const AxisResult both = separating_axes(cube, polyhedron_of_box({1, 3, 3}));
  EXPECT_CLOSE(both.depth, 1, tight);
  EXPECT_CLOSE(both.runner_up, 1, tight);

  // As Pose is filled in, with a quaternion that is not of unit length, and far away.
  const Pose far{{1e6, -2e6, 3e6}, {0, 0, 3, 3}}, near{{1e6, -2e6 + 0.75, 3e6}, {0, 0, 3, 3}};
  const AxisResult turned = separating_axes(moved(cube, far), moved(polyhedron_of_box({1, 1, 1}), near));
  EXPECT_CLOSE(turned.depth, 0.25L, 1e-12L);
  expect_along(turned.normal, {0, 1, 0}, 1e-12L);
}

TEST(SeparatingAxes, CrossedEdges) {
  // Two cubes on edge, one along Z, above it one along X.
  for (const Real gap : {0.5L, 1e-12L, -1e-12L, -0.1L}) {
    const Polyhedron a = cube_turned({0, 0, 1}, {}), b = cube_turned({1, 0, 0}, {0.1L, std::sqrt(2.0L) + gap, 0.2L});
    const AxisResult r = separating_axes(a, b);
    EXPECT_EQ(r.overlap, gap < 0);
    EXPECT_CLOSE(r.depth, -gap, tight);
    EXPECT_CLOSE(r.gap, gap > 0 ? gap : 0, tight);
    expect_along(r.normal, {0, 1, 0});
    EXPECT_GT(r.runner_up, r.depth + 0.01L);
  }
}

TEST(SeparatingAxes, Separated) {
  const Polyhedron a = polyhedron_of_box({1, 2, 3});
  const AxisResult r = separating_axes(a, moved(a, {1.25L, 0.5L, -4}, {}));
  EXPECT_FALSE(r.overlap);
  EXPECT_CLOSE(r.gap, 1, tight);
  EXPECT_CLOSE(r.depth, -1, tight);
  expect_along(r.normal, {0, 0, -1});
  EXPECT_CLOSE(r.runner_up, -0.25L, tight);
}

TEST(SeparatingAxes, FlatPolygons) {
  const Polyhedron triangle = polyhedron_of_polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Polyhedron rectangle = polyhedron_of_polygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  const Polyhedron cube = polyhedron_of_box({1, 1, 1});
  // In one plane, apart across the slanted edge of the triangle only.
  const Quaternion eighth{0, 0, std::sin(std::numbers::pi_v<Real> / 8), std::cos(std::numbers::pi_v<Real> / 8)};
  const AxisResult coplanar = separating_axes(triangle, moved(rectangle, {1.5L, 1.5L, 0}, eighth));
  EXPECT_FALSE(coplanar.overlap);
  EXPECT_CLOSE(coplanar.gap, std::sqrt(2.0L) - 1, tight);
  expect_along(coplanar.normal, {std::sqrt(0.5L), std::sqrt(0.5L), 0});
  EXPECT_TRUE(separating_axes(triangle, rectangle).overlap);
  EXPECT_EQ(separating_axes(triangle, rectangle).depth, 0);
  // Parallel, crossed, and inside a solid.
  EXPECT_CLOSE(separating_axes(triangle, moved(rectangle, {0, 0, 0.25L}, {})).gap, 0.25L, tight);
  const Real root = std::sqrt(0.5L);
  EXPECT_CLOSE(separating_axes(rectangle, moved(triangle, {0, 0, -0.25L}, {root, 0, 0, root})).depth, 0.25L, tight);
  const AxisResult solid = separating_axes(cube, moved(rectangle, {0, 0, 0.375L}, {}));
  EXPECT_CLOSE(solid.depth, 0.125L, tight);
  expect_along(solid.normal, {0, 0, 1});
  // A box without height is a rectangle.
  for (const Real x : {0.25L, 2.5L}) {
    const Vector t{x, 0.375L, 0.125L};
    const AxisResult box = separating_axes(polyhedron_of_box({2, 2, 0}), moved(cube, t, eighth));
    const AxisResult flat = separating_axes(rectangle, moved(cube, t, eighth));
    EXPECT_CLOSE(box.depth, flat.depth, tight);
    EXPECT_CLOSE(box.runner_up, flat.runner_up, tight);
  }
}

TEST(SeparatingAxes, SwapMirrors) {
  Random random;
  for (int i = 0; i < 500; ++i) {
    const Polyhedron a = moved(polyhedron_of_box(random.size()), random.pose(1));
    const Polyhedron b = i % 2 ? moved(polyhedron_of_box(random.size()), random.pose(1))
                               : moved(polyhedron_of_hull(octahedron(1)), random.pose(1));
    const AxisResult ab = separating_axes(a, b), ba = separating_axes(b, a);
    EXPECT_EQ(ab.overlap, ba.overlap);
    EXPECT_CLOSE(ab.depth, ba.depth, tight);
    EXPECT_CLOSE(ab.gap, ba.gap, tight);
    EXPECT_CLOSE(ab.runner_up, ba.runner_up, tight);
    if (ab.runner_up > ab.depth + 1e-9L) expect_along(ab.normal, -ba.normal, loose);
  }
}

// The largest separation along any axis at all is the distance, so along those tried it is no more.
void compare(const AxisResult& r, const Placed& a, const Placed& b) {
  const Signed s = signed_distance(a, b);
  EXPECT_EQ(r.overlap, s.distance <= 0);
  if (!r.overlap) {
    EXPECT_GT(r.gap, 0);
    EXPECT_LE(r.gap, s.distance + loose);
    return;
  }
  EXPECT_CLOSE(r.depth, -s.distance, loose);
  const Vector n{r.normal.x, r.normal.y, r.normal.z};
  EXPECT_CLOSE(length(n), 1, tight);
  EXPECT_CLOSE(separation(a, b, n), -r.depth, loose);
  if (r.runner_up > r.depth + 1e-6L) expect_along(r.normal, {s.normal.x, s.normal.y, s.normal.z}, 1e-9L);
}

TEST(SeparatingAxes, AgreesWithSignedDistance) {
  Random random;
  int overlaps = 0, count = 0;
  for (int i = 0; i < 300; ++i, ++count) {
    const Point size = random.size();
    const std::vector<Point> points = i % 3 ? random.points(12) : octahedron(1);
    const Pose p = random.pose(0.75), q = random.pose(0.75);
    const AxisResult r = separating_axes(moved(polyhedron_of_hull(points), p), moved(polyhedron_of_box(size), q));
    compare(r, place(polytope(points), p), place(box({size.x, size.y, size.z}), q));
    overlaps += r.overlap;
  }
  EXPECT_GT(overlaps, count / 2);
  EXPECT_LT(overlaps, count);
}

TEST(SeparatingAxes, AgreesWithSignedDistanceOnFlatPolygons) {
  Random random;
  int overlaps = 0, count = 0;
  for (int i = 0; i < 300; ++i, ++count) {
    const Point size = random.size();
    const Point e = size * 0.5L;
    const std::vector<Point> corners =
        i % 2 ? random.points(3) : std::vector<Point>{{-e.x, -e.y, 0}, {e.x, -e.y, 0}, {e.x, e.y, 0}, {-e.x, e.y, 0}};
    const std::vector<Point> other = i % 3 ? random.points(8) : random.points(3);
    const Pose p = random.pose(0.5), q = random.pose(0.5);
    const AxisResult r = separating_axes(moved(polyhedron_of_polygon(corners), p),
                                         moved(i % 3 ? polyhedron_of_hull(other) : polyhedron_of_polygon(other), q));
    compare(r, place(polytope(corners), p), place(polytope(other), q));
    overlaps += r.overlap;
  }
  EXPECT_GT(overlaps, count / 4);
  EXPECT_LT(overlaps, count);
}

}  // namespace
}  // namespace graze::reference
