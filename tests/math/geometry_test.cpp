// The small exact questions, against brute force, on degenerate input, and lane by lane.
#include "graze/geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "graze/wide.hpp"

namespace graze {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; }
Vec3d vector(Random& random) {
  const double x = uniform(random), y = uniform(random);
  return {x, y, uniform(random)};
}
Quatd rotation(Random& random) {
  const Vec3d v = vector(random);
  return normalized(Quatd{v.x, v.y, v.z, uniform(random) + 1e-3});
}

TEST(Vec3, NormalizedAtTheEndsOfTheRange) {
  for (const double size : {1e-310, 1e-200, 1.0, 1e200, 1e308})
    EXPECT_NEAR(length(normalized(Vec3d{size, -size, size / 2})), 1, 1e-14) << size;
  EXPECT_EQ(normalized(Vec3d{}), (Vec3d{0, 1, 0}));
}

TEST(Vec3, AnyPerpendicularIsPerpendicular) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d n = normalized(vector(random));
    EXPECT_NEAR(dot(any_perpendicular(n), n), 0, 1e-15);
    EXPECT_NEAR(length(any_perpendicular(n)), 1, 1e-15);
  }
}

TEST(Pose, ComposeInverseRelative) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Posed a{vector(random), rotation(random)}, b{vector(random), rotation(random)};
    const Vec3d p = vector(random);
    EXPECT_LT(length(transform(compose(a, b), p) - transform(a, transform(b, p))), 1e-14);
    EXPECT_LT(length(transform(inverse(a), transform(a, p)) - p), 1e-14);
    EXPECT_LT(length(transform(a, transform(relative(a, b), p)) - transform(b, p)), 1e-14);
    EXPECT_LT(length(rotation_matrix(a.rotation) * p - rotate(a.rotation, p)), 1e-14);
    const Quatd q = rotation_quaternion(rotation_matrix(a.rotation));
    EXPECT_LT(length(rotate(q, p) - rotate(a.rotation, p)), 1e-14);
  }
}

/// The least distance over a grid of weights.
template <class F>
double least_over_grid(int steps, const F& distance) {
  double best = 1e300;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) best = std::min(best, distance(double(i) / steps, double(j) / steps));
  return best;
}

TEST(Geometry, ClosestPointOnTriangleAgreesWithAGrid) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Vec3d a = vector(random), b = vector(random), c = vector(random), p = vector(random) * 2.0;
    const auto found = closest_point_on_triangle(a, b, c, p);
    const double grid = least_over_grid(
        60, [&](double s, double t) { return s + t > 1 ? 1e300 : length(a + (b - a) * s + (c - a) * t - p); });
    EXPECT_LE(length(found.point - p), grid + 1e-12);
    EXPECT_GE(length(found.point - p), grid - 0.1);
    EXPECT_LT(length(a * found.weight.x + b * found.weight.y + c * found.weight.z - found.point), 1e-12);
  }
  const Vec3d a{0, 0, 0}, b{1, 0, 0};
  EXPECT_EQ(closest_point_on_triangle(a, b, b, Vec3d{0.5, 1, 0}).point, (Vec3d{0.5, 0, 0}));
  EXPECT_EQ(closest_point_on_triangle(a, a, a, Vec3d{0.5, 1, 0}).point, a);
}

/// Corners and a point over a known place of the triangle, all of them exact: whole numbers times a power of two,
/// turned by a matrix of determinant one. The base runs along two neighbours of Fibonacci's sequence; earlier ones
/// span an area of one with it.
struct SlenderTriangle {
  Vec3d corner[3], place, point;
  double longest;
};
SlenderTriangle slender_triangle_of(Random& random) {
  const auto whole = [&](int most) { return static_cast<double>(static_cast<int>(random() % (2 * most + 1)) - most); };
  const int steps = 4 + static_cast<int>(random() % 28);
  double f = 1, g = 1;
  for (int i = 0; i < steps; ++i) f = std::exchange(g, f + g);
  const double part = static_cast<double>(1 + random() % 15) / 16;
  const Vec3d base{g, f, 0};
  const Vec3d apex =
      random() % 2 ? Vec3d{f, g - f, 0} : Vec3d{std::floor(part * g), std::floor(part * f) + whole(1), 0};
  const double a = whole(2), b = whole(2), c = whole(2);
  const auto turned = [&](const Vec3d& v) {  // by two shears
    const double x = v.x, y = v.y + a * x, z = v.z + b * x + c * y;
    return Vec3d{x + a * z, y, z};
  };
  SlenderTriangle t{{Vec3d{}, turned(base), turned(apex)}, {}, {}, 0};
  const double u = static_cast<double>(random() % 60) + 2, v = static_cast<double>(random() % 60) + 2, all = 128;
  t.place = (t.corner[1] * u + t.corner[2] * v) * (1 / all);
  const Vec3d n = cross(t.corner[1], t.corner[2]);
  t.longest = std::max({length(t.corner[1]), length(t.corner[2]), length(t.corner[1] - t.corner[2])});
  const double up = std::exp2(std::floor(std::log2(t.longest / std::max(max_abs(n), 1.0))));
  t.point = t.place + n * up;
  return t;
}

TEST(Geometry, ClosestPointOnASlenderTriangleIsExact) {
  Random random(5);
  double least_aspect = 1;
  for (int i = 0; i < 4000; ++i) {
    const SlenderTriangle t = slender_triangle_of(random);
    const Vec3d n = cross(t.corner[1], t.corner[2]);
    if (n == Vec3d{}) continue;
    const std::size_t k = random() % 3;  // whatever corner comes first
    const auto found = closest_point_on_triangle(t.corner[k], t.corner[(k + 1) % 3], t.corner[(k + 2) % 3], t.point);
    EXPECT_LE(length(found.point - t.place), 4e-15 * t.longest) << "aspect " << length(n) / (t.longest * t.longest);
    EXPECT_NEAR(found.weight.x + found.weight.y + found.weight.z, 1, 1e-15);
    least_aspect = std::min(least_aspect, length(n) / (t.longest * t.longest));
  }
  EXPECT_LT(least_aspect, 1e-10);
}

TEST(Geometry, SegmentsAgreeWithAGrid) {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    Segmentd p{vector(random), vector(random)}, q{vector(random), vector(random)};
    if (i % 5 == 0) q = {p.a + Vec3d{0.1, 0.2, 0}, p.b + Vec3d{0.1, 0.2, 0}};  // parallel
    if (i % 7 == 0) q.b = q.a;
    if (i % 11 == 0) p.b = p.a;
    const auto [s, t] = closest_parameters(p, q);
    const double found = length(point_at(p, s) - point_at(q, t));
    const double grid =
        least_over_grid(60, [&](double u, double v) { return length(point_at(p, u) - point_at(q, v)); });
    EXPECT_LE(found, grid + 1e-12);
    EXPECT_GE(found, grid - 0.1);
  }
}

TEST(Geometry, LinesAndPlanes) {
  const Rayd x{{0, 0, 0}, {2, 0, 0}}, up{{1, 3, 1}, {0, 1, 0}};
  const auto [s, t] = closest_parameters_of_lines(x, up);
  EXPECT_EQ(s, 0.5);
  EXPECT_EQ(t, -3);
  EXPECT_EQ(closest_point_on_line(x, Vec3d{-7, 1, 0}), (Vec3d{-7, 0, 0}));
  const Planed plane = plane_through(Vec3d{0, 1, 0}, Vec3d{0, 1, 1}, Vec3d{1, 1, 0});
  EXPECT_EQ(plane.normal, (Vec3d{0, 1, 0}));
  EXPECT_EQ(plane.offset, 1);
  EXPECT_EQ(closest_point(plane, Vec3d{3, 5, 2}), (Vec3d{3, 1, 2}));
  EXPECT_EQ(plane_at(Vec3d{0, 2, 0}, Vec3d{1, 4, 9}).offset, 4);
  EXPECT_EQ(plane_from(Vec3d{0, 2, 0}, 3.0).offset, 3);
  // Collinear points still give a plane through them.
  const Planed any = plane_through(Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{2, 0, 0});
  EXPECT_NEAR(length(any.normal), 1, 1e-15);
  EXPECT_EQ(signed_distance(any, Vec3d{2, 0, 0}), 0);
}

TEST(Geometry, RaysHitWhatTheyPointAt) {
  const Rayd ray{{-3, 0, 0}, {1, 0, 0}};
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(intersect_sphere(ray, Vec3d{0, 0, 0}, 1.0), 2);
  EXPECT_EQ(intersect_sphere(ray, Vec3d{0, 1, 0}, 1.0), 3);  // grazing
  EXPECT_EQ(intersect_sphere(ray, Vec3d{0, 2, 0}, 1.0), inf);
  EXPECT_EQ(intersect_sphere(ray, Vec3d{-3, 0, 0}, 1.0), 0);
  EXPECT_EQ(intersect_sphere(ray, Vec3d{-6, 0, 0}, 1.0), inf);  // behind
  EXPECT_EQ(intersect_box(ray, Vec3d{1, 1, 1}), 2);
  EXPECT_EQ(intersect_box(Rayd{{-3, 1, 0}, {1, 0, 0}}, Vec3d{1, 1, 1}), 2);  // along a face
  EXPECT_EQ(intersect_box(Rayd{{-3, 1.5, 0}, {1, 0, 0}}, Vec3d{1, 1, 1}), inf);
  EXPECT_EQ(intersect_box(Rayd{{0, 0, 0}, {0, 0, 1}}, Vec3d{1, 1, 1}), 0);
  EXPECT_EQ(intersect(ray, Planed{{-1, 0, 0}, -1.0}), 4);
  EXPECT_EQ(intersect(ray, Planed{{0, 1, 0}, 1.0}), inf);
  const auto hit = intersect_triangle(ray, Vec3d{0, -1, -1}, Vec3d{0, 2, 0}, Vec3d{0, -1, 1});
  EXPECT_EQ(hit.t, 3);
  EXPECT_NEAR(hit.weight.x + hit.weight.y + hit.weight.z, 1, 1e-15);
  EXPECT_EQ(intersect_triangle(ray, Vec3d{0, 1, -1}, Vec3d{0, 2, 0}, Vec3d{0, 1, 1}).t, inf);
}

TEST(Geometry, BoxesAsVerticesPlanesAndEdges) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const OrientedBox<double> box{{vector(random), rotation(random)}, abs(vector(random))};
    for (const OrientedBox<double>& back : {box_of(vertices_of(box)), box_of(planes_of(box)), box_of(corner_of(box))}) {
      const auto v = vertices_of(box), w = vertices_of(back);
      for (std::size_t k = 0; k < 8; ++k) EXPECT_LT(length(v[k] - w[k]), 1e-13);
    }
  }
}

// The lanes of a kernel give the bits that the scalar gives: every question over every width.
template <class T, int N>
void lanes_equal_scalars() {
  using W = Wide<T, N>;
  Random random(6);
  for (int round = 0; round < 50; ++round) {
    Vec3<W> wide[4];
    Vec3<T> lane[N][4];
    for (auto& v : wide)
      for (int i = 0; i < N; ++i) {
        const Vec3<T> p = converted<T>(vector(random));
        lane[i][&v - wide] = p;
        v.x.set(i, p.x), v.y.set(i, p.y), v.z.set(i, p.z);
      }
    const auto all = [](const auto& a, const auto& b, const auto& c, const auto& d) {
      using S = std::decay_t<decltype(a.x)>;
      const auto triangle = closest_point_on_triangle(a, b, c, d);
      const auto [s, t] = closest_parameters(Segment<S>{a, b}, Segment<S>{c, d});
      const Ray<S> ray{a, normalized(b)};
      return std::array<S, 10>{triangle.point.x,
                               triangle.weight.y,
                               s,
                               t,
                               intersect_sphere(ray, c, d.x),
                               intersect_box(ray, abs(c)),
                               intersect_triangle(ray, b, c, d).t,
                               any_perpendicular(normalized(c)).y,
                               closest_point_in_box(abs(c), d).z,
                               intersect(ray, Plane<S>{normalized(c), d.x})};
    };
    const auto answers = all(wide[0], wide[1], wide[2], wide[3]);
    for (int i = 0; i < N; ++i) {
      const auto single = all(lane[i][0], lane[i][1], lane[i][2], lane[i][3]);
      for (std::size_t k = 0; k < answers.size(); ++k) EXPECT_EQ(answers[k][i], single[k]) << "question " << k;
    }
  }
}
/// Of each lane alone, and of all but that, whether any is set, and all.
template <class T, int N>
void lanes_are_joined() {
  for (int i = 0; i < N; ++i) {
    Wide<T, N> one(T(0));
    one.set(i, T(1));
    EXPECT_TRUE(any(one > Wide<T, N>(T(0)))) << i;
    EXPECT_FALSE(all(one < Wide<T, N>(T(1)))) << i;
  }
  const Wide<T, N> zero(T(0));
  EXPECT_FALSE(any(zero > zero));
  EXPECT_TRUE(all(zero == zero));
}
TEST(Wide, AnyAndAllJoinEveryLane) {
  lanes_are_joined<float, 4>();
  lanes_are_joined<float, 8>();
  lanes_are_joined<float, 16>();
  lanes_are_joined<double, 2>();
  lanes_are_joined<double, 4>();
  lanes_are_joined<double, 8>();
}
TEST(Wide, Float4) { lanes_equal_scalars<float, 4>(); }
TEST(Wide, Float8) { lanes_equal_scalars<float, 8>(); }
TEST(Wide, Float16) { lanes_equal_scalars<float, 16>(); }
TEST(Wide, Double2) { lanes_equal_scalars<double, 2>(); }
TEST(Wide, Double4) { lanes_equal_scalars<double, 4>(); }
TEST(Wide, Double8) { lanes_equal_scalars<double, 8>(); }

}  // namespace
}  // namespace graze
