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
struct Case {
  PlacedSpecimen placed;
  Shape<T> shape;
  Pose<T> pose;
  reference::Placed reference;
  double size;

  explicit Case(const PlacedSpecimen& p)
      : placed(p),
        shape(build<T>(p.specimen)),
        pose(pose_of<T>(p)),
        reference(reference_of(p)),
        size(static_cast<double>(reference::bounding_radius(reference.shape))) {}

  /// What an answer may be off by: the shape's share and the ray's, whose origin is as exact as its distance allows.
  /// `t` adds to it where a half-space is met further away than that: it is known in relative terms only.
  double tolerance_from(const Vec3d& origin, double t = 0) const {
    const double afar = length(origin - cast<double>(pose.translation)) + t;
    return static_cast<double>(tolerance<T>) * size +
           16 * static_cast<double>(std::numeric_limits<T>::epsilon()) * afar;
  }
};

template <class T>
Ray<T> random_ray(double scale, double afar, Random& random) {
  const Vec3d target = cast<double>(random_vector(random, static_cast<float>(0.5 * scale)));
  const Vec3d from = normalized(cast<double>(random_vector(random, 1))) * (afar * scale);
  // Directions of any length, some along an axis.
  Vec3d direction = (target - from) * static_cast<double>(uniform(random, 0.01f, 10));
  if (random() % 8 == 0) direction = scaled(direction, Vec3d{1, 0, random() % 2 ? 1.0 : 0.0});
  if (direction == Vec3d{}) direction = {1, 0, 0};
  return {cast<T>(from), cast<T>(direction)};
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
void expect_proven_hit(const Case<T>& c, const Ray<T>& ray, const RayHit<T>& hit) {
  const Vec3d origin = cast<double>(ray.origin), direction = normalized(cast<double>(ray.direction));
  const Vec3d point = cast<double>(hit.point), normal = cast<double>(hit.normal);
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
void expect_proven_miss(const Case<T>& c, const Ray<T>& ray) {
  const Vec3d origin = cast<double>(ray.origin), direction = normalized(cast<double>(ray.direction));
  const double far = length(origin - cast<double>(c.pose.translation)) + 2 * c.size + 1e-3;
  const double tol = c.tolerance_from(origin);
  // Outside the reference closed form is the distance; that of a point that just is in the shape must be of no depth.
  const auto outside = [&](double t) {
    return static_cast<double>(reference::outside_distance(c.reference, extended(origin + direction * t)));
  };
  if (least_value(0, far, outside) > 0) return;
  const auto signed_distance = [&](double t) {
    return static_cast<double>(closest(c.shape, c.pose, cast<T>(origin + direction * t)).distance);
  };
  ASSERT_GE(least_value(0, far, signed_distance), -tol);
}

/// The same without convexity: no point of the ray is inside before the hit, nor any point of a miss.
template <class T>
void expect_outside_before(const Case<T>& c, const Ray<T>& ray, const std::optional<RayHit<T>>& hit) {
  const Vec3d origin = cast<double>(ray.origin), direction = normalized(cast<double>(ray.direction));
  if (hit && hit->t == T(0)) return;  // proven to begin inside
  const double far = hit ? static_cast<double>(hit->t) : length(origin) + 2 * c.size;
  for (int i = 0; i < 200; ++i) {
    const Vec3<T> p = cast<T>(origin + direction * (far * i / 200));
    ASSERT_GE(static_cast<double>(closest(c.shape, c.pose, p).distance), -c.tolerance_from(origin));
  }
}

struct Tally {
  int rays = 0, hits = 0;
};

template <class T>
void check_ray(const Case<T>& c, const Ray<T>& ray, Tally& tally) {
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
    const T slack = static_cast<T>(c.tolerance_from(cast<double>(ray.origin), static_cast<double>(hit->t)));
    ASSERT_TRUE(raycast(c.shape, c.pose, ray, hit->t + slack));
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
  for (int i = 0; i < 1000; ++i) {
    const double scale = std::pow(10.0, i % 9 - 4);
    const auto f = static_cast<float>(scale);
    const Case<double> c(
        {random_specimen(kind(), f, random), random_vector(random, 0.2f * f), random_rotation(random)});
    const double afar = i % 10 == 0 ? 1e6 : i % 10 == 1 ? 0.3 : static_cast<double>(uniform(random, 1, 5));
    for (int k = 0; k < 20 && !HasFatalFailure(); ++k) check_ray(c, random_ray<double>(scale, afar, random), tally);
    if (HasFatalFailure()) return;
  }
  // Most rays are aimed well; a segment is hit by chance only where it is rounded, which one in three is.
  EXPECT_GT(tally.hits, kind() == Kind::segment ? 700 : 2000);
  EXPECT_LT(tally.hits, 20000);
}

TEST_P(RaycastKind, InFloat) {
  Random random(static_cast<unsigned>(GetParam()) + 100);
  Tally tally;
  for (int i = 0; i < 200; ++i) {
    const Case<float> c({random_specimen(kind(), 1, random), random_vector(random, 0.2f), random_rotation(random)});
    for (int k = 0; k < 10 && !HasFatalFailure(); ++k) check_ray(c, random_ray<float>(1, 3, random), tally);
    if (HasFatalFailure()) return;
  }
}

// Flat, thin, of equal sizes, in line with the axes, of zero size: every answer is finite and any hit is proven.
TEST_P(RaycastKind, Degenerate) {
  Random random(static_cast<unsigned>(GetParam()) + 200);
  Tally tally;
  for (int i = 0; i < 1000; ++i) {
    const Case<double> c(on_lattice(degenerate_specimen(kind(), 1, random), 1, random));
    for (int k = 0; k < 4; ++k) {
      Ray<double> ray = random_ray<double>(1, 3, random);
      if (k < 2) {  // from lattice to lattice: along faces, through edges and corners
        const PlacedSpecimen from = on_lattice(c.placed.specimen, 1, random), to = on_lattice(from.specimen, 1, random);
        ray = {cast<double>(from.translation), cast<double>(to.translation - from.translation)};
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

INSTANTIATE_TEST_SUITE_P(Kinds, RaycastKind, ::testing::Range(0, kind_count),
                         [](const auto& info) { return std::string(name_of(static_cast<Kind>(info.param))); });

}  // namespace
}  // namespace graze::testing
