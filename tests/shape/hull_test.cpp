// Convex hulls: every point inside, the surface closed, the furthest vertex found; whatever the points.
#include <gtest/gtest.h>

#include <random>

#include "common/specimen.hpp"
#include "graze/shape.hpp"
#include "shape/furthest_vertex.hpp"

namespace graze::testing {
namespace {

template <class T>
std::vector<Vec3<T>> ball(std::size_t count, Random& random, bool on_surface) {
  std::vector<Vec3<T>> points;
  while (points.size() < count) {
    const Vec3d p = converted<double>(random_vector(random, 1));
    const double l = length(p);
    if (l > 1 || l < 0.1) continue;
    points.push_back(converted<T>(on_surface ? p / l : p));
  }
  return points;
}

/// The guarantees of the header, for any set of points.
template <class T>
void check(const std::vector<Vec3<T>>& points, const ConvexHull<T>& hull) {
  const HullData<T>& data = hull.data();
  const double tolerance = static_cast<double>(data.tolerance);
  for (const Plane<T>& plane : data.planes) {
    EXPECT_NEAR(static_cast<double>(length(plane.normal)), 1, 1e-6);
    double outside = -1e300;
    for (const Vec3<T>& p : points)
      outside = std::max(outside, dot(converted<double>(plane.normal), converted<double>(p)) -
                                      static_cast<double>(plane.offset));
    // A float's normal is itself rounded; what it leans reaches as far as the points do.
    EXPECT_LE(outside, tolerance + 4 * static_cast<double>(std::numeric_limits<T>::epsilon() * data.extent));
  }
  for (const Vec3<T>& v : data.vertices) EXPECT_NE(std::find(points.begin(), points.end(), v), points.end());
  if (data.dimension < 2) return;
  const auto v = static_cast<long>(data.vertices.size()), e = static_cast<long>(data.edges.size()),
             f = static_cast<long>(data.planes.size());
  EXPECT_EQ(v - e + f, 2);
  for (const auto& edge : data.edges) {
    EXPECT_LT(edge.face[0], data.planes.size());
    EXPECT_LT(edge.face[1], data.planes.size());
    EXPECT_NE(edge.face[0], edge.face[1]);
  }
  for (std::size_t i = 0; i < data.planes.size(); ++i) EXPECT_GE(data.loop(i).size(), 3u);
}

template <class T>
void check_support(const ConvexHull<T>& hull, Random& random, int directions) {
  const auto& vertices = hull.data().vertices;
  for (int i = 0; i < directions; ++i) {
    const Vec3d d = normalized(converted<double>(random_vector(random, 1)));
    double most = -1e300;
    for (const Vec3<T>& v : vertices) most = std::max(most, dot(converted<double>(v), d));
    EXPECT_NEAR(dot(converted<double>(vertices[hull.support_vertex(d)]), d), most,
                static_cast<double>(hull.tolerance()));
  }
}

TEST(ConvexHull, CubeHasSixFaces) {
  std::vector<Vec3d> points;
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  points.push_back({0, 0, 0});
  points.push_back({1, 0, 0});  // within a face
  points.push_back({1, 1, 0});  // within an edge
  const ConvexHull<double> hull(points);
  EXPECT_EQ(hull.data().dimension, 3);
  EXPECT_EQ(hull.data().vertices.size(), 8u);
  EXPECT_EQ(hull.data().planes.size(), 6u);
  EXPECT_EQ(hull.data().edges.size(), 12u);
  check(points, hull);
}

// Turned, a cube's faces are flat only up to rounding, and six all the same; in float too.
template <class T>
void turned_cubes() {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Quatd q = normalized(converted<double>(random_rotation(random)));
    const Vec3d offset = converted<double>(random_vector(random, 10));
    std::vector<Vec3<T>> points;
    for (int k = 0; k < 8; ++k)
      points.push_back(
          converted<T>(offset + rotate(q, Vec3d{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0})));
    const ConvexHull<T> hull(points);
    EXPECT_EQ(hull.data().planes.size(), 6u);
    check(points, hull);
  }
}
TEST(ConvexHull, TurnedCubesHaveSixFacesInDouble) { turned_cubes<double>(); }
TEST(ConvexHull, TurnedCubesHaveSixFacesInFloat) { turned_cubes<float>(); }

TEST(ConvexHull, FlatAndSmallerSets) {
  const Vec3d p{1, 2, 3}, q{2, 2, 3}, r{1, 3, 3};
  EXPECT_EQ(ConvexHull<double>(std::vector{p}).data().dimension, 0);
  EXPECT_EQ(ConvexHull<double>(std::vector{p, p, p}).data().vertices.size(), 1u);
  const ConvexHull<double> segment(std::vector{p, (p + q) * 0.5, q, p});
  EXPECT_EQ(segment.data().dimension, 1);
  EXPECT_EQ(segment.data().vertices.size(), 2u);
  const ConvexHull<double> polygon(std::vector{p, q, r, (p + q + r) / 3.0, (p + q) * 0.5});
  EXPECT_EQ(polygon.data().dimension, 2);
  EXPECT_EQ(polygon.data().vertices.size(), 3u);
  EXPECT_EQ(polygon.data().planes.size(), 2u);
}

// A sliver is a body as long as rounding leaves it a thickness.
TEST(ConvexHull, SliversStayBodies) {
  for (const double thin : {1e-4, 1e-8}) {
    std::vector<Vec3d> points;
    for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? thin : -thin, i & 4 ? 1.0 : -1.0});
    const ConvexHull<double> hull(points);
    EXPECT_EQ(hull.data().dimension, 3);
    EXPECT_EQ(hull.data().planes.size(), 6u);
  }
}

// Where one is as thin as the tolerance, faces at its tips and along its rim become one with others. The points stay.
TEST(ConvexHull, SliversKeepTheirTips) {
  std::vector<Vec3d> points{{0, 3.2, 1e-14}, {0, 0, 2.7e-12}, {0, 0, 0.8}, {4.4e-11, 0, 0}, {0, 2.9, 0}};
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    const ConvexHull<double> hull(points);
    check(points, hull);
    for (int i = 0; i < 50; ++i) {
      const Vec3d d = i < 3 ? Vec3d{double(i == 0), double(i == 1), double(i == 2)}
                            : normalized(converted<double>(random_vector(random, 1)));
      const auto reach = [&](const std::vector<Vec3d>& of) {
        double most = -1e300;
        for (const Vec3d& p : of) most = std::max(most, dot(p, d));
        return most;
      };
      EXPECT_GE(reach(hull.data().vertices), reach(points) - 8 * hull.tolerance()) << "round " << round;
    }
    points.clear();
    const double thin = std::pow(10.0, uniform(random, -13, -9));
    for (std::size_t i = 4 + random() % 30; i > 0; --i) {
      const Vec3d p = converted<double>(random_vector(random, 1));
      points.push_back({p.x * thin, p.y, p.z});
    }
  }
}

TEST(ConvexHull, HoldsEveryKindOfPoints) {
  Random random(2);
  for (int round = 0; round < 60; ++round) {
    std::vector<Vec3d> points = ball<double>(4 + random() % 300, random, round % 3 == 0);
    switch (round % 6) {
    case 1:  // every point twice, and once more nearby
      for (std::size_t i = 0, n = points.size(); i < n; ++i) {
        points.push_back(points[i]);
        points.push_back(points[i] + converted<double>(random_vector(random, 1e-15f)));
      }
      break;
    case 2:  // a lattice: many coplanar and collinear
      for (Vec3d& p : points) p = {std::round(p.x * 3), std::round(p.y * 3), std::round(p.z * 3)};
      break;
    case 3:
      for (Vec3d& p : points) p = p * 1e-12 + Vec3d{1, 1, 1};
      break;
    case 4:
      for (Vec3d& p : points) p = p * std::ldexp(1.0, static_cast<int>(random() % 150) - 100);
      break;
    case 5:  // flat up to rounding
      for (Vec3d& p : points) p = Vec3d{p.x, p.y, 0.3 * p.x - 0.7 * p.y};
      break;
    default: break;
    }
    const ConvexHull<double> hull(points);
    check(points, hull);
    check_support(hull, random, 50);
    std::vector<Vec3f> singles;
    for (const Vec3d& p : points) singles.push_back(converted<float>(p));
    check(singles, ConvexHull<float>(singles));
  }
}

// Against brute force: a triangle of points is a face where all others lie on one side.
TEST(ConvexHull, AgreesWithBruteForceOnSmallSets) {
  Random random(3);
  for (int round = 0; round < 100; ++round) {
    const std::vector<Vec3d> points = ball<double>(5 + random() % 12, random, false);
    const ConvexHull<double> hull(points);
    const HullData<double>& data = hull.data();
    std::size_t faces = 0;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = 0; k < n; ++k) {
          if (i >= j || i >= k || j == k) continue;
          const Vec3d m = cross(points[j] - points[i], points[k] - points[i]);
          bool outer = true;
          for (std::size_t l = 0; l < n && outer; ++l)
            outer = l == i || l == j || l == k || dot(m, points[l] - points[i]) < 0;
          faces += outer;
        }
    EXPECT_EQ(data.planes.size(), faces);
  }
}

/// Lanes of float find the very vertex that a scan in the direction's own scalar does, of equally high ones the first,
/// at every level of the instruction set; however long the direction, and where vertices are so near that only double
/// tells them apart.
template <class T, class S>
void support_is_the_scan(double scale) {
  Random random(12);
  for (const std::size_t count : {5u, 16u, 23u, 32u, 33u, 47u, 48u, 63u, 64u}) {
    std::vector<Vec3<T>> points = ball<T>(count, random, true);
    for (Vec3<T>& p : points) p *= static_cast<T>(scale);
    points.push_back(points[0] * (T(1) + 4 * std::numeric_limits<T>::epsilon()));
    const ConvexHull<T> hull{std::span<const Vec3<T>>(points)};
    const HullData<T>& data = hull.data();
    if (data.vertices.size() > 64) continue;
    std::vector<Vec3<S>> directions;
    for (int i = 0; i < 100; ++i) directions.push_back(converted<S>(random_vector(random, 1)));
    for (const Plane<T>& plane : data.planes) directions.push_back(converted<S>(plane.normal));
    for (const Vec3<S>& unit : directions)
      for (const double reach : {1.0, 1e-30, 1e25}) {
        const Vec3<S> d = unit * static_cast<S>(reach);
        const std::size_t expected = detail::furthest(data.vertices.data(), data.vertices.size(), d);
        EXPECT_EQ(hull.support_vertex(d), expected);
        for (const Isa level : {Isa::baseline, Isa::avx2, Isa::avx512})
          if (isa_available(level)) {
            EXPECT_EQ((GRAZE_KERNEL(level, furthest_vertex<T, S>)(scanned(data), d)), expected);
            if constexpr (std::is_same_v<T, float> && std::is_same_v<S, float>) {
              const float below = 0.1f * data.extent * static_cast<float>(reach);
              const HighestVertices highest = GRAZE_KERNEL(level, highest_vertices)(scanned(data), d, below);
              EXPECT_EQ(highest.top, expected);
              for (std::size_t v = 0; v < 64; ++v)
                EXPECT_EQ(highest.bits >> v & 1,
                          v < data.vertices.size() &&
                              dot(data.vertices[v], d) >= dot(data.vertices[expected], d) - below);
            }
          }
      }
  }
}
TEST(ConvexHull, SupportOfSmallOnesIsThatOfAScan) {
  for (const double scale : {1e-4, 1.0, 1e4}) {
    support_is_the_scan<float, float>(scale);
    support_is_the_scan<float, double>(scale);
    support_is_the_scan<double, double>(scale);
  }
}

TEST(ConvexHull, HundredThousandPoints) {
  Random random(4);
  const std::vector<Vec3d> points = ball<double>(100000, random, true);
  const ConvexHull<double> hull(points);
  EXPECT_GT(hull.data().vertices.size(), 99000u);
  EXPECT_FALSE(hull.data().hierarchy.empty());
  check_support(hull, random, 300);
}

TEST(ConvexHull, NamesWhatItCannotTake) {
  const auto message = [](std::vector<Vec3d> points) -> std::string {
    try {
      const ConvexHull<double> hull(points);
    } catch (const InvalidValue& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message({}), "points: expected at least one point, got none");
  EXPECT_EQ(message({{0, 0, 0}, {0, std::nan(""), 0}}), "points[1][1]: expected a finite number, got nan");
}

}  // namespace
}  // namespace graze::testing
