// Balls against triangles: the closed form against the general path, against the naive nearest point, and against
// itself, since what contacts, distances and overlaps say has to be the same.
#include <gtest/gtest.h>

#include <algorithm>

#include "common/specimen.hpp"
#include "graze/geometry.hpp"
#include "graze/query.hpp"
#include "narrow/general.hpp"
#include "narrow/manifold/clip_faces.hpp"
#include "narrow/manifold/features.hpp"

namespace graze::testing {
namespace {

template <class T>
struct BallAt {
  Sphere<T> ball;
  Triangle<T> triangle;
  T margin_ball, margin_triangle;
  Pose<T> pose_ball, pose_triangle;
  T scale;

  Shape<T> a() const { return Shape<T>(ball, margin_ball); }
  Shape<T> b() const { return Shape<T>(triangle, margin_triangle); }
};

/// Some balls are off their origins, some radii are none; every fifth pair is far from the world's origin.
template <class T>
BallAt<T> random_ball_at(int i, Random& random) {
  static constexpr float scales[] = {1, 1e-4f, 1e-2f, 1e2f, 1e4f};
  const float scale = scales[i % 5];
  const auto vector = [&](float reach) { return converted<T>(random_vector(random, reach * scale)); };
  const auto turn = [&] { return i % 3 == 0 ? Quat<T>{} : normalized(converted<T>(random_rotation(random))); };
  const Vec3<T> away = i % 5 == 0 ? vector(100) : Vec3<T>{};
  const T radius = i % 11 == 0 ? T(0) : T(scale) * T(uniform(random, 0.1f, 0.8f));
  const Vec3<T> p = vector(1), q = vector(1), r = vector(1);
  return {Sphere<T>(radius, i % 4 == 0 ? vector(0.5f) : Vec3<T>{}),
          Triangle<T>(p, q, r),
          i % 6 == 0 ? T(scale) * T(0.1) : T(0),
          i % 7 == 0 ? T(scale) * T(0.1) : T(0),
          {away + vector(1), turn()},
          {away, turn()},
          T(scale)};
}

template <class T>
double to_triangle(const BallAt<T>& s) {
  const Posed to = in_double(s.pose_triangle), from = in_double(s.pose_ball);
  const Vec3d p = inverse_transform(to, transform(from, converted<double>(s.ball.center())));
  const auto at = [&](std::size_t i) { return converted<double>(s.triangle.point(i)); };
  return length(closest_point_on_triangle(at(0), at(1), at(2), p).point - p);
}

/// What GJK and the support faces make of it.
template <class T>
std::uint32_t general_name(const BallAt<T>& s, const Vec3d& normal, const Vec3d& on_b) {
  const Posed frame = in_double(s.pose_triangle);
  Face<T> face;
  s.triangle.core_face(converted<T>(rotate(conjugate(frame.rotation), -normal)), face, side_lean<T>);
  PlacedFace placed, vertex;
  placed.id = face.id;
  for (const Vec3<T>& v : face.vertices) placed.vertices.push_back(transform(frame, converted<double>(v)));
  for (const std::uint32_t id : face.ids) placed.ids.push_back(id);
  vertex.vertices.push_back({});
  vertex.ids.push_back(0);
  return feature_at(vertex, {}, placed, on_b, normal);
}

template <class T>
void expect_as_in_general(unsigned seed, double near) {
  Random random(seed);
  int touching = 0, other_names = 0, names[4] = {};
  for (int i = 0; i < 6000; ++i) {
    const auto s = random_ball_at<T>(i, random);
    const Shape<T> a = s.a(), b = s.b();
    const double size = static_cast<double>(s.scale), reach = i % 5 == 0 ? 100 * size : size, allowed = near * reach;
    const Distance<T> d = distance(a, s.pose_ball, b, s.pose_triangle);
    const double radius_a = static_cast<double>(s.ball.radius() + s.margin_ball), radius_b = s.margin_triangle;

    ASSERT_NEAR(static_cast<double>(d.distance), to_triangle(s) - radius_a - radius_b, allowed);
    const auto general = general_distance<T>(a, b, relative_in_double(s.pose_ball, s.pose_triangle));
    ASSERT_NEAR(static_cast<double>(d.distance), general.core.distance - radius_a - radius_b, allowed);
    const Vec3d normal = rotate(in_double(s.pose_ball).rotation, general.core.normal);
    if (general.core.distance > 0.01 * size) {
      ASSERT_LT(length(converted<double>(d.normal) - normal), 100 * near) << i;
      const Vec3d on_b = transform(in_double(s.pose_ball), general.core.b) - normal * radius_b;
      ASSERT_LT(length(converted<double>(d.b) - on_b), 10 * allowed);
    }
    ASSERT_LT(length(converted<double>(d.b - d.a - d.normal * d.distance)), allowed);

    Manifolds<T> found, mirrored;
    const bool touch = contacts(a, s.pose_ball, b, s.pose_triangle, T(0), found);
    ASSERT_EQ(touch, d.distance <= T(0));
    ASSERT_EQ(touch, overlap(a, s.pose_ball, b, s.pose_triangle));
    ASSERT_EQ(touch, contacts(b, s.pose_triangle, a, s.pose_ball, T(0), mirrored));
    if (!touch) continue;
    ++touching;
    ASSERT_EQ(found.size(), 1u);
    ASSERT_EQ(found[0].points.size(), 1u);
    const ContactPoint<T>&p = found[0].points[0], &q = mirrored[0].points[0];
    ASSERT_TRUE(p.distance == d.distance && p.a == d.a && p.b == d.b && found[0].normal == d.normal);
    ASSERT_TRUE(q.distance == d.distance && q.b == d.a && q.a == d.b && mirrored[0].normal == -d.normal);
    ASSERT_EQ(p.feature, swapped_feature_id(q.feature));
    ++names[(p.feature & 0xffff) >> 14];
    if (general.core.distance > 0.01 * size)
      other_names += p.feature != general_name(s, normal, transform(in_double(s.pose_ball), general.core.b));
  }
  EXPECT_GT(touching, 1000);
  for (int kind : {1, 2, 3}) EXPECT_GT(names[kind], 100);
  EXPECT_LE(other_names, 2);  // where rounding tells which
}

TEST(SphereTriangle, IsAsInGeneral) {
  expect_as_in_general<float>(1, 1e-6);
  expect_as_in_general<double>(2, 1e-11);
}

// Segments, points, slivers, and a centre on the triangle: all agree on what touches, and nothing is not a number.
template <class T>
void expect_consistent_where_degenerate() {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3<T> p = converted<T>(random_vector(random, 1)), q = converted<T>(random_vector(random, 1));
    const T thin = T(std::exp2(-uniform(random, 0, 60)));
    const Vec3<T> r = i % 4 == 0   ? p
                      : i % 4 == 1 ? p + (q - p) * T(uniform(random, -1, 2))
                                   : p + (q - p) * T(0.3) + converted<T>(random_vector(random, 1)) * thin;
    const Shape<T> triangle(Triangle<T>(p, i % 8 == 0 ? p : q, r)), ball(Sphere<T>(T(1 + i % 3) * T(0.1)));
    const T off = i % 2 == 0 ? T(0) : T(std::exp2(-uniform(random, 0, 60)));
    const Pose<T> at{(p + q + r) * T(1.0 / 3) + converted<T>(random_vector(random, 1)) * off, {}};
    const Distance<T> d = distance(ball, at, triangle, {});
    ASSERT_NEAR(static_cast<double>(length(d.normal)), 1, 1e-6);
    ASSERT_LT(length(d.b - d.a - d.normal * d.distance), T(1e-5));
    Manifolds<T> found;
    ASSERT_EQ(contacts(ball, at, triangle, {}, T(0), found), d.distance <= T(0)) << i;
    ASSERT_EQ(overlap(ball, at, triangle, {}), d.distance <= T(0)) << i;
  }
}

TEST(SphereTriangle, AgreesWithItselfWhereDegenerate) {
  expect_consistent_where_degenerate<float>();
  expect_consistent_where_degenerate<double>();
}

TEST(SphereTriangle, NamesWhatTouches) {
  const Shape<double> triangle(Triangle<double>({0, 0, 0}, {1, 0, 0}, {0, 0, -1})), ball(Sphere<double>(0.5));
  const auto name = [&](double x, double y, double z) {
    Manifolds<double> found;
    EXPECT_TRUE(contacts(ball, {{x, y, z}, {}}, triangle, {}, 0.0, found));
    return found[0].points[0].feature & 0xffff;
  };
  EXPECT_EQ(name(0.2, 0.4, -0.2), face_feature(0));
  EXPECT_EQ(name(0.2, -0.4, -0.2), face_feature(1));
  EXPECT_EQ(name(0.5, 0, 0.4), edge_feature(0, 1));
  EXPECT_EQ(name(0.7, 0.3, -0.7), edge_feature(1, 2));
  EXPECT_EQ(name(-0.3, 0.3, -0.5), edge_feature(0, 2));
  EXPECT_EQ(name(-0.2, 0.1, 0.3), vertex_feature(0));
  EXPECT_EQ(name(1.2, 0.3, 0.1), vertex_feature(1));
  EXPECT_EQ(name(0, 0.4, -1.1), vertex_feature(2));
}

// A ball that just touches: what rounding cannot tell from touching touches, far from the origin too.
TEST(SphereTriangle, TouchesExactly) {
  const Shape<double> triangle(Triangle<double>({-1, 0, 1}, {1, 0, 1}, {0, 0, -1}));
  for (const double away : {0.0, 1e3, 1e6})
    for (const Vec3d& place : {Vec3d{0.1, 0.3, 0}, Vec3d{0.1, 0, 1.3}, Vec3d{0, 0, -1.3}}) {
      const Shape<double> ball(Sphere<double>(0.3));
      const Posed at{place + Vec3d{away, away, 0}, {}}, ground{{away, away, 0}, {}};
      const double apart = distance(ball, at, triangle, ground).distance;
      EXPECT_NEAR(apart, 0, 1e-15 + away * 1e-15);
      Manifolds<double> found;
      EXPECT_EQ(contacts(ball, at, triangle, ground, 0.0, found), apart <= 0);
      EXPECT_EQ(overlap(ball, at, triangle, ground), apart <= 0);
    }
}

}  // namespace
}  // namespace graze::testing
