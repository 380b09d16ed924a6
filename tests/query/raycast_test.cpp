// Ray casts against the reference. A hit is proven by its own numbers: a point of the shape, on the ray, that is the
// shape's support point along a normal that faces the ray; no earlier point of the ray can be inside then. A miss is
// proven by the least distance along the ray, a convex function.
#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"
#include "reference/certificate.hpp"

namespace graze::testing {
namespace {

using reference::Real;
using reference::Vector;

Vector extended(const Vec3d& v) { return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)}; }

template <class T>
struct RayCase {
  PlacedSpecimen placed;
  Shape<T> shape;
  Pose<T> pose;
  reference::Placed reference;
  double size;

  explicit RayCase(const PlacedSpecimen& p)
      : placed(p),
        shape(build<T>(p.specimen)),
        pose(pose_of<T>(p)),
        reference(reference_of(p)),
        size(static_cast<double>(reference::bounding_radius(reference.shape))) {}

  /// What an answer may be off by: the shape's share and the ray's, whose origin is as exact as its distance allows.
  /// `t` adds to it where a half-space is met further away than that: it is known in relative terms only.
  double tolerance_from(const Vec3d& origin, double t = 0) const {
    const double afar = length(origin - converted<double>(pose.translation)) + t;
    return static_cast<double>(tolerance<T>) * size +
           16 * static_cast<double>(std::numeric_limits<T>::epsilon()) * afar;
  }
};

template <class T>
Ray<T> random_ray(double scale, double afar, Random& random) {
  const Vec3d target = converted<double>(random_vector(random, static_cast<float>(0.5 * scale)));
  const Vec3d from = normalized(converted<double>(random_vector(random, 1))) * (afar * scale);
  // Directions of any length, some along an axis.
  Vec3d direction = (target - from) * static_cast<double>(uniform(random, 0.01f, 10));
  if (random() % 8 == 0) direction = scaled(direction, Vec3d{1, 0, random() % 2 ? 1.0 : 0.0});
  if (direction == Vec3d{}) direction = {1, 0, 0};
  return {converted<T>(from), converted<T>(direction)};
}

/// The least value of a convex function between two places.
template <class F>
double least_value(double low, double high, const F& f) {
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) * 0.45, b = low + (high - low) * 0.55;
    if (f(a) <= f(b))
      high = b;
    else
      low = a;
  }
  return f((low + high) / 2);
}

template <class T>
void expect_proven_hit(const RayCase<T>& c, const Ray<T>& ray, const RayHit<T>& hit) {
  const Vec3d origin = converted<double>(ray.origin), direction = normalized(converted<double>(ray.direction));
  const Vec3d point = converted<double>(hit.point), normal = converted<double>(hit.normal);
  const double t = static_cast<double>(hit.t), tol = c.tolerance_from(origin, t);
  const double unit = 8 * static_cast<double>(std::numeric_limits<T>::epsilon());
  ASSERT_GE(t, 0);
  ASSERT_NEAR(length(normal), 1, unit);
  ASSERT_LE(dot(normal, direction), unit);
  ASSERT_LE(length(point - origin - direction * t), tol);
  ASSERT_LE(static_cast<double>(reference::outside_distance(c.reference, extended(point))), tol) << "t " << t;
  // From inside a solid; where the ray begins on the surface, its normal will do as well.
  if (t == 0 && length(normal + direction) <= unit) return;
  reference::Placed shifted = c.reference;
  shifted.translation = shifted.translation - extended(point);
  Vector outward = extended(normal);
  if (c.placed.specimen.kind == Kind::half_space) outward = c.reference.axis_y;
  ASSERT_LE(static_cast<double>(reference::support_value(shifted, outward)), tol) << "t " << t;
}

template <class T>
void expect_proven_miss(const RayCase<T>& c, const Ray<T>& ray) {
  const Vec3d origin = converted<double>(ray.origin), direction = normalized(converted<double>(ray.direction));
  const double far = length(origin - converted<double>(c.pose.translation)) + 2 * c.size + 1e-3;
  const double tol = c.tolerance_from(origin);
  // Outside the reference closed form is the distance; that of a point that just is in the shape must be of no depth.
  const auto outside = [&](double t) {
    return static_cast<double>(reference::outside_distance(c.reference, extended(origin + direction * t)));
  };
  if (least_value(0, far, outside) > 0) return;
  const auto signed_distance = [&](double t) {
    return static_cast<double>(closest(c.shape, c.pose, converted<T>(origin + direction * t)).distance);
  };
  ASSERT_GE(least_value(0, far, signed_distance), -tol);
}

/// The same without convexity: no point of the ray is inside before the hit, nor any point of a miss.
template <class T>
void expect_outside_before(const RayCase<T>& c, const Ray<T>& ray, const std::optional<RayHit<T>>& hit) {
  const Vec3d origin = converted<double>(ray.origin), direction = normalized(converted<double>(ray.direction));
  if (hit && hit->t == T(0)) return;  // proven to begin inside
  const double far = hit ? static_cast<double>(hit->t) : length(origin) + 2 * c.size;
  for (int i = 0; i < 200; ++i) {
    const Vec3<T> p = converted<T>(origin + direction * (far * i / 200));
    ASSERT_GE(static_cast<double>(closest(c.shape, c.pose, p).distance), -c.tolerance_from(origin));
  }
}

struct Tally {
  int rays = 0, hits = 0;
};

template <class T>
void check_ray(const RayCase<T>& c, const Ray<T>& ray, Tally& tally) {
  SCOPED_TRACE(describe(c.placed));
  const auto hit = raycast(c.shape, c.pose, ray);
  ++tally.rays;
  tally.hits += hit.has_value();
  ASSERT_EQ(raycast_any(c.shape, c.pose, ray), hit.has_value());
  if (hit)
    expect_proven_hit(c, ray, *hit);
  else if (tally.rays % 4 == 0)
    expect_proven_miss(c, ray);
  if (tally.rays % 200 == 0) expect_outside_before(c, ray, hit);
  if (hit && hit->t > T(0)) {
    const auto again = raycast(c.shape, c.pose, ray, hit->t);
    ASSERT_TRUE(again);
    ASSERT_EQ(again->t, hit->t);
    ASSERT_FALSE(raycast(c.shape, c.pose, ray, hit->t * T(0.99)));
  }
}

class RaycastKind : public ::testing::TestWithParam<int> {
 protected:
  Kind kind() const { return static_cast<Kind>(GetParam()); }
};

TEST_P(RaycastKind, HitsAndMissesAreProven) {
  Random random(static_cast<unsigned>(GetParam()) + 1);
  Tally tally;
  for (int i = 0; i < 500; ++i) {
    const double scale = std::pow(10.0, i % 9 - 4);
    const auto f = static_cast<float>(scale);
    const RayCase<double> c(
        {random_specimen(kind(), f, random), random_vector(random, 0.2f * f), random_rotation(random)});
    const double afar = i % 10 == 0 ? 1e6 : i % 10 == 1 ? 0.3 : static_cast<double>(uniform(random, 1, 5));
    for (int k = 0; k < 20 && !HasFatalFailure(); ++k) check_ray(c, random_ray<double>(scale, afar, random), tally);
    if (HasFatalFailure()) return;
  }
  // Most rays are aimed well; a segment is hit by chance only where it is rounded, which one in three is.
  EXPECT_GT(tally.hits, kind() == Kind::segment ? 350 : 1000);
  EXPECT_LT(tally.hits, 10000);
}

TEST_P(RaycastKind, InFloat) {
  Random random(static_cast<unsigned>(GetParam()) + 100);
  Tally tally;
  for (int i = 0; i < 200; ++i) {
    const RayCase<float> c({random_specimen(kind(), 1, random), random_vector(random, 0.2f), random_rotation(random)});
    for (int k = 0; k < 10 && !HasFatalFailure(); ++k) check_ray(c, random_ray<float>(1, 3, random), tally);
    if (HasFatalFailure()) return;
  }
}

// Flat, thin, of equal sizes, in line with the axes, of zero size: every answer is finite and any hit is proven.
TEST_P(RaycastKind, Degenerate) {
  Random random(static_cast<unsigned>(GetParam()) + 200);
  for (int i = 0; i < 600; ++i) {
    const RayCase<double> c(on_lattice(degenerate_specimen(kind(), 1, random), 1, random));
    for (int k = 0; k < 4; ++k) {
      Ray<double> ray = random_ray<double>(1, 3, random);
      if (k < 2) {  // from lattice to lattice: along faces, through edges and corners
        const PlacedSpecimen from = on_lattice(c.placed.specimen, 1, random), to = on_lattice(from.specimen, 1, random);
        ray = {converted<double>(from.translation), converted<double>(to.translation - from.translation)};
        if (ray.direction == Vec3d{}) ray.direction = {0, 0, 1};
      }
      SCOPED_TRACE(describe(c.placed));
      const auto hit = raycast(c.shape, c.pose, ray);
      if (hit) {
        ASSERT_NO_FATAL_FAILURE(expect_proven_hit(c, ray, *hit));
      } else if (i % 4 == 0) {
        ASSERT_NO_FATAL_FAILURE(expect_proven_miss(c, ray));
      }
    }
  }
}

// What begins on the surface and heads into a solid does not get past it, and is hit before it has gone anywhere.
TEST_P(RaycastKind, FromTheSurface) {
  Random random(static_cast<unsigned>(GetParam()) + 300);
  for (int i = 0; i < 300; ++i) {
    const double scale = std::pow(10.0, i % 9 - 4);
    const auto f = static_cast<float>(scale);
    const RayCase<double> c(
        {random_specimen(kind(), f, random), random_vector(random, 0.2f * f), random_rotation(random)});
    SCOPED_TRACE(describe(c.placed));
    for (int k = 0; k < 10; ++k) {
      const Ray<double> aimed = random_ray<double>(scale, 3, random);
      const auto hit = raycast(c.shape, c.pose, aimed);
      if (!hit) continue;
      const auto again = raycast(c.shape, c.pose, {hit->point, aimed.direction});
      const double tol = c.tolerance_from(aimed.origin, hit->t);
      // A ray that only grazes may leave by rounding; any that goes deeper may not.
      const Vec3d deeper = hit->point + normalized(aimed.direction) * (1e-3 * scale);
      const bool enters = closest(c.shape, c.pose, deeper).distance < -tol;
      ASSERT_TRUE(again || !enters);
      // By how far the point is off across the surface, it is off along the ray by more the more the ray grazes.
      const double steep = greatest(1e-6, -dot(hit->normal, normalized(aimed.direction)));
      ASSERT_LE(again ? again->t : 0, 2 * tol / steep);
    }
  }
}

// One end of `length` to the other: none, exactly to the hit, and the numbers that are not one.
TEST(Raycast, Lengths) {
  const Shape<double> ball(Sphere<double>(1.0));
  const Ray<double> ray{{0, 5, 0}, {0, -0.25, 0}};
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(raycast(ball, {}, ray));
  EXPECT_TRUE(raycast(ball, {}, ray, infinity));
  EXPECT_EQ(raycast(ball, {}, ray, 4.0).value().t, 4);
  EXPECT_FALSE(raycast(ball, {}, ray, 3.999));
  EXPECT_FALSE(raycast(ball, {}, ray, 0.0));
  EXPECT_TRUE(raycast(ball, {}, {{}, {1, 0, 0}}, 0.0));
  EXPECT_FALSE(raycast(ball, {}, ray, -1.0));
  EXPECT_FALSE(raycast(ball, {}, ray, nan));
}

TEST(Raycast, RaysThatAreNoneHitNothing) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const Shape<double> shapes[] = {Sphere<double>(1.0), Box<double>({1, 1, 1}), HalfSpace<double>()};
  for (const Shape<double>& shape : shapes)
    for (const Ray<double>& ray : {Ray<double>{{0, 0, 0}, {0, 0, 0}}, Ray<double>{{nan, 0, 0}, {1, 0, 0}},
                                   Ray<double>{{0, 0, 0}, {nan, 0, 0}}, Ray<double>{{0, infinity, 0}, {0, -1, 0}},
                                   Ray<double>{{0, 5, 0}, {0, -infinity, 0}}, Ray<double>{{0, 1e300, 0}, {0, -1, 0}}}) {
      EXPECT_FALSE(raycast(shape, {}, ray));
      EXPECT_FALSE(raycast_any(shape, {}, ray));
    }
  // Directions of any length but zero will do.
  EXPECT_NEAR(raycast(shapes[0], {}, {{0, 5, 0}, {0, -1e-300, 0}}).value().t, 4, 1e-12);
  EXPECT_NEAR(raycast(shapes[0], {}, {{0, 5, 0}, {0, -1e300, 0}}).value().t, 4, 1e-12);
}

// A triangle has no thickness and two sides, of which the back can be left out. The same in a mesh.
TEST(Raycast, BackFacesByChoice) {
  const Shape<double> triangle(Triangle<double>({-1, 0, 1}, {1, 0, 1}, {0, 0, -1}));  // its front is +Y
  const Shape<double> mesh(Mesh<double>({{-1, 0, 1}, {1, 0, 1}, {0, 0, -1}}, {{0, 1, 2}}));
  const Ray<double> down{{0, 2, 0}, {0, -1, 0}}, up{{0, -2, 0}, {0, 1, 0}};
  for (const Shape<double>& shape : {triangle, mesh}) {
    EXPECT_EQ(raycast(shape, {}, down).value().normal, Vec3d({0, 1, 0}));
    EXPECT_EQ(raycast(shape, {}, up).value().normal, Vec3d({0, -1, 0}));
    EXPECT_TRUE(raycast(shape, {}, down, 10.0, BackFaces::ignored));
    EXPECT_FALSE(raycast(shape, {}, up, 10.0, BackFaces::ignored));
    EXPECT_FALSE(raycast_any(shape, {}, up, 10.0, BackFaces::ignored));
  }
}

// A compound answers with the nearest child and its number; all hits come sorted.
TEST(Raycast, CompoundsNameTheChild) {
  const Shape<double> ball(Sphere<double>(0.5));
  const Shape<double> pair(Compound<double>({{ball, {{0, 0, 0}, {}}}, {ball, {{1, 0, 0}, {}}}}));
  const Shape<double> row(Compound<double>({{ball, {{6, 0, 0}, {}}}, {pair, {{2, 0, 0}, {}}}}));
  const Ray<double> ray{{-1, 0, 0}, {3, 0, 0}};
  const auto first = raycast(row, {}, ray);
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->t, 2.5, 1e-12);
  EXPECT_EQ(first->piece, 1u);
  std::vector<RayHit<double>> hits;
  EXPECT_EQ(raycast_all(row, {}, ray, hits), 3u);
  EXPECT_NEAR(hits[0].t, 2.5, 1e-12);
  EXPECT_NEAR(hits[1].t, 3.5, 1e-12);
  EXPECT_NEAR(hits[2].t, 6.5, 1e-12);
  EXPECT_EQ(hits[2].piece, 0u);
  EXPECT_EQ(raycast_all(row, {}, ray, hits, 4.0), 2u);  // appended
  EXPECT_EQ(hits.size(), 5u);
}

// Segments and points are met by rays that are aimed at them, within the ray's own rounding.
TEST(Raycast, ThinThingsAreMetWhenAimedAt) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d a = converted<double>(random_vector(random, 1)), b = converted<double>(random_vector(random, 1));
    const Vec3d target = a + (b - a) * static_cast<double>(uniform(random, 0, 1));
    const Vec3d from = converted<double>(random_vector(random, 5));
    const Pose<double> pose{converted<double>(random_vector(random, 3)),
                            normalized(converted<double>(random_rotation(random)))};
    const auto hit = raycast(Shape<double>(LineSegment<double>(a, b)), pose,
                             {transform(pose, from), rotate(pose.rotation, target - from)});
    ASSERT_TRUE(hit);
    // How far the nearest point is along the segment is less sure where the ray runs along it.
    const double sine = length(cross(normalized(b - a), normalized(target - from)));
    ASSERT_NEAR(hit->t, length(target - from), 1e-13 / greatest(sine, 1e-13));
    ASSERT_TRUE(raycast(Shape<double>(Sphere<double>(0.0)), {transform(pose, target), {}},
                        {transform(pose, from), rotate(pose.rotation, target - from)}));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, RaycastKind, ::testing::Range(0, kind_count),
                         [](const auto& info) { return std::string(name_of(static_cast<Kind>(info.param))); });

}  // namespace
}  // namespace graze::testing
