// Polygons and chains of ten thousand vertices, against all of their edges in extended precision.
#include <gtest/gtest.h>

#include "plane/wide_outline.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneManyVertices : public ::testing::Test {};
using ManyVertexScalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneManyVertices, ManyVertexScalars);

constexpr std::size_t vertex_count = 10000;

/// The error that an answer may have, relative to a size of one: of a distance and the place of a ray's hit, and of the
/// place of a cast.
template <class T>
constexpr Wide far_off = 1e-10L;
template <>
constexpr Wide far_off<float> = 4e-6L;
template <class T>
constexpr Wide cast_off = 1e-8L;
template <>
constexpr Wide cast_off<float> = 2e-5L;

/// Points around the origin, on a circle, or in and out of it by `waves` of the radius.
template <class T>
std::vector<Vec2<T>> points_around(double waves) {
  std::vector<Vec2<T>> out;
  for (std::size_t i = 0; i < vertex_count; ++i) {
    const double angle = 2 * std::acos(-1.0) * double(i) / vertex_count, r = 1 + waves * std::sin(25 * angle);
    out.push_back({static_cast<T>(r * std::cos(angle)), static_cast<T>(r * std::sin(angle))});
  }
  return out;
}

template <class T>
struct Outlined {
  Shape<T> shape;
  WideOutline outline;
  bool solid;
};
template <class T>
std::vector<Outlined<T>> outlined_by_many() {
  const auto circle = points_around<T>(0), waves = points_around<T>(0.2);
  const ConvexPolygon<T> convex(circle);
  const std::vector<Vec2<T>> corners(convex.vertices().begin(), convex.vertices().end());
  return {{convex, {corners, true}, true},
          {Polygon<T>(waves), {waves, true}, true},
          {Chain<T>(waves, true), {waves, true}, false},
          {Chain<T>(waves), {waves, false}, false}};
}

template <class T>
Wide distance_to(const Outlined<T>& shape, const Pose2<T>& pose, const Vec2<T>& p) {
  const WidePoint own = into_frame(wide(pose), p);
  return shape.solid ? shape.outline.signed_distance(own) : shape.outline.to_edges(own);
}

template <class T>
const std::vector<Outlined<T>>& shapes_of_many() {
  static const std::vector<Outlined<T>> all = outlined_by_many<T>();
  return all;
}

template <class T>
Vec2<T> random_point(double reach, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-reach, reach);
  const double x = uniform(random);
  return {static_cast<T>(x), static_cast<T>(uniform(random))};
}

TYPED_TEST(PlaneManyVertices, NearestPoints) {
  using T = TypeParam;
  std::mt19937 random(81);
  for (const Outlined<T>& shape : shapes_of_many<T>())
    for (int i = 0; i < 60; ++i) {
      const Pose2<T> pose = random_pose<T>(0.2, random);
      const Vec2<T> p = random_point<T>(1.5, random);
      const Closest<T> found = closest(shape.shape, pose, p);
      ASSERT_NEAR(double(found.distance), double(distance_to(shape, pose, p)), double(far_off<T>))
          << shape.shape.name();
      ASSERT_NEAR(double(distance_to(shape, pose, found.point)), 0, double(far_off<T>)) << shape.shape.name();
    }
}

TYPED_TEST(PlaneManyVertices, Rays) {
  using T = TypeParam;
  std::mt19937 random(82);
  int hits = 0, misses = 0;
  for (const Outlined<T>& shape : shapes_of_many<T>())
    for (int i = 0; i < 60; ++i) {
      const Pose2<T> pose = random_pose<T>(0.2, random);
      const Vec2<T> origin = random_point<T>(3, random), target = random_point<T>(1.4, random);
      const Ray<T> ray{origin, target - origin};
      const auto hit = raycast(shape.shape, pose, ray);
      const WidePose at = wide(pose);
      const WidePoint from = into_frame(at, ray.origin);
      Wide x = ray.direction.x, y = ray.direction.y;
      const Wide l = std::hypot(x, y);
      x /= l, y /= l;
      const WidePoint along{at.cosine * x + at.sine * y, at.cosine * y - at.sine * x};
      Wide expected = shape.outline.first_crossing(from, along);
      if (shape.solid && shape.outline.inside(from)) expected = 0;
      ASSERT_EQ(hit.has_value(), expected < 1e30L) << shape.shape.name() << ", " << i;
      ++(hit ? hits : misses);
      if (!hit) continue;
      ASSERT_NEAR(double(hit->t), double(expected), 2 * double(far_off<T>)) << shape.shape.name() << ", " << i;
      ASSERT_LE(double(distance_to(shape, pose, hit->point)), double(far_off<T>)) << shape.shape.name();
    }
  EXPECT_GT(hits, 80);
  EXPECT_GT(misses, 30);
}

/// A disc beside the shapes: its contacts are as deep as its centre is near, less its radius.
TYPED_TEST(PlaneManyVertices, ContactsOfADisc) {
  using T = TypeParam;
  std::mt19937 random(83);
  int met = 0, apart = 0;
  for (const Outlined<T>& shape : shapes_of_many<T>())
    for (int i = 0; i < 60; ++i) {
      const Pose2<T> pose = random_pose<T>(0.2, random);
      const T radius = T(0.05);
      const Vec2<T> center = random_point<T>(1.5, random);
      const Wide expected = distance_to(shape, pose, center) - Wide(radius);
      if (shape.solid && expected < -Wide(radius)) continue;  // its centre is inside
      const Shape<T> disc = Circle<T>(radius);
      ASSERT_NEAR(double(distance(shape.shape, pose, disc, {center, {}}).distance), double(expected),
                  double(far_off<T>))
          << shape.shape.name();
      Manifolds<T> manifolds;
      ASSERT_EQ(contacts(shape.shape, pose, disc, {center, {}}, T(0), manifolds), expected <= 0) << shape.shape.name();
      ++(expected <= 0 ? met : apart);
      if (manifolds.empty()) continue;
      T deepest = 1;
      for (const Manifold<T>& m : manifolds)
        for (const ContactPoint<T>& p : m.points) {
          deepest = std::min(deepest, p.distance);
          ASSERT_NEAR(double(distance_to(shape, pose, p.a)), 0, double(far_off<T>)) << shape.shape.name();
        }
      ASSERT_NEAR(double(deepest), double(expected), double(far_off<T>)) << shape.shape.name();
    }
  EXPECT_GT(met, 10);
  EXPECT_GT(apart, 60);
}

/// A disc that comes in without turning: at the time of its hit it touches, and up to there it does not.
TYPED_TEST(PlaneManyVertices, CastsOfADisc) {
  using T = TypeParam;
  std::mt19937 random(84);
  int hits = 0, misses = 0;
  for (const Outlined<T>& shape : shapes_of_many<T>())
    for (int i = 0; i < 40; ++i) {
      const Pose2<T> pose = random_pose<T>(0.2, random);
      const T radius = T(0.05);
      const Vec2<T> from = random_point<T>(1, random) + Vec2<T>{T(i % 2 ? 3 : -3), 0},
                    to = random_point<T>(1.5, random);
      const Velocity<T> velocity{to - from, i % 3 == 0 ? T(1) : T(0)};
      const auto hit = cast<T>(shape.shape, pose, {}, Circle<T>(radius), {from, {}}, velocity, T(1));
      ++(hit ? hits : misses);
      const auto gap_at = [&](Wide t) {
        const Vec2<Wide> p{Wide(from.x) + t * Wide(velocity.linear.x), Wide(from.y) + t * Wide(velocity.linear.y)};
        const WidePoint own = into_frame(wide(pose), p);
        return (shape.solid ? shape.outline.signed_distance(own) : shape.outline.to_edges(own)) - Wide(radius);
      };
      const Wide until = hit ? Wide(hit->t) : 1;
      // Steps as long as the gap takes at least.
      const Wide speed = std::hypot(Wide(velocity.linear.x), Wide(velocity.linear.y));
      for (Wide t = 0; t < until;) {
        const Wide gap = gap_at(t);
        ASSERT_GT(double(gap), -double(cast_off<T>)) << shape.shape.name() << ", " << i << " at " << double(t);
        t += std::max(gap, 10 * cast_off<T>) / speed;
      }
      if (hit) {
        ASSERT_NEAR(double(gap_at(hit->t)), 0, double(cast_off<T>)) << shape.shape.name() << ", " << i;
      }
    }
  EXPECT_GT(hits, 60);
  EXPECT_GT(misses, 5);
}

/// Two polygons that are as good as discs.
TYPED_TEST(PlaneManyVertices, EachOther) {
  using T = TypeParam;
  const auto circle = points_around<T>(0);
  const Shape<T> polygon = ConvexPolygon<T>(circle);
  const double sagitta = 1 - std::cos(std::acos(-1.0) / vertex_count), off = 2 * sagitta + double(far_off<T>);
  for (const double x : {2.5, 2.1, 1.9, 1.2}) {
    const Pose2<T> there{{static_cast<T>(0.6 * x), static_cast<T>(0.8 * x)}, Rot2<T>::from_angle(T(0.1))};
    Manifolds<T> manifolds;
    ASSERT_EQ(contacts(polygon, {}, polygon, there, T(0.2), manifolds), x < 2);
    ASSERT_EQ(manifolds.size(), x < 2.2 ? 1u : 0u);
    if (!manifolds.empty()) {
      T deepest = 1;
      for (const ContactPoint<T>& p : manifolds[0].points) deepest = std::min(deepest, p.distance);
      EXPECT_NEAR(double(deepest), x - 2, off);
      EXPECT_NEAR(double(manifolds[0].normal.x), 0.6, 1e-3);
    }
    const auto hit = cast<T>(polygon, {}, {}, polygon, there, {there.translation * T(-1), T(0.3)}, T(1));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(double(hit->t), std::max(0.0, (x - 2) / x), 2 * sagitta + double(cast_off<T>));
  }
}

}  // namespace
}  // namespace graze::plane
