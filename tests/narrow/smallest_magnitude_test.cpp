// Answers do not change with the size of the world, down to the smallest magnitude; shapes below it are points.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "common/specimen.hpp"
#include "graze/cast.hpp"
#include "graze/detail/validate.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"
#include "shape/mesh_data.hpp"

namespace graze::testing {
namespace {

/// Random specimens reach up to 4 from their own origins.
constexpr double specimen_reach = 4;

template <class T>
struct Scene {
  Shape<T> a, b;
  Pose<T> pose_a, pose_b;
};

/// Shapes in units of `size`, their origins in units of `apart`.
template <class T>
Scene<T> scene(const PlacedSpecimen& a, const PlacedSpecimen& b, T size, T apart) {
  return {build<T>(a.specimen, size), build<T>(b.specimen, size), pose_of<T>(a, apart), pose_of<T>(b, apart)};
}

/// The specimen with zeros where constructors see them, in units of `scale`.
template <class T>
Specimen resolved(Specimen specimen, T scale) {
  const auto zero_small = [&](float& x) {
    if (std::abs(static_cast<T>(x)) * scale < smallest_magnitude<T>) x = 0;
  };
  for (float& size : specimen.size) zero_small(size);
  for (Vec3f& p : specimen.points) {
    zero_small(p.x);
    zero_small(p.y);
    zero_small(p.z);
  }
  zero_small(specimen.margin);
  return specimen;
}

template <class T>
std::optional<CastHit<T>> cast_towards(const Scene<T>& s) {
  const Vec3<T> way = s.pose_b.translation - s.pose_a.translation;
  const Pose<T> away{s.pose_a.translation + way * T(4), s.pose_b.rotation};
  return graze::cast(s.a, s.pose_a, Velocity<T>{way * T(4), {}}, s.b, away, Velocity<T>{}, T(1));
}

template <class T>
std::optional<RayHit<T>> ray_at(const Scene<T>& s) {
  const Vec3<T> way = s.pose_b.translation - s.pose_a.translation;
  return raycast(s.a, s.pose_a, Ray<T>{s.pose_b.translation + way * T(4), -way});
}

template <class T>
void expect_near(T unit, T scaled, T scale, T within) {
  EXPECT_LE(std::abs(scaled / scale - unit), within) << "unit " << unit << ", scaled " << scaled / scale;
}

/// The deepest point's distance, or the margin.
template <class T>
T deepest(const Scene<T>& s, T margin) {
  Manifolds<T> manifolds;
  contacts(s.a, s.pose_a, s.b, s.pose_b, margin, manifolds);
  T least_distance = margin;
  for (const auto& manifold : manifolds)
    for (const auto& point : manifold.points) least_distance = std::min(least_distance, point.distance);
  return least_distance;
}

template <class T>
void expect_scaled(const Scene<T>& unit, const Scene<T>& scaled, T scale) {
  const T within = 2 * tolerance<T> * T(specimen_reach);
  const auto near = distance(unit.a, unit.pose_a, unit.b, unit.pose_b);
  const auto small = distance(scaled.a, scaled.pose_a, scaled.b, scaled.pose_b);
  EXPECT_EQ(near.status == Status::unbounded, small.status == Status::unbounded);
  if (near.status == Status::unbounded) return;
  expect_near(near.distance, small.distance, scale, within);
  if (std::abs(near.distance) > within) {
    EXPECT_EQ(overlap(scaled.a, scaled.pose_a, scaled.b, scaled.pose_b), near.distance <= T(0));
  }
  expect_near(deepest(unit, T(1) / 8), deepest(scaled, scale / 8), scale, within);
  expect_near(closest(unit.a, unit.pose_a, unit.pose_b.translation).distance,
              closest(scaled.a, scaled.pose_a, scaled.pose_b.translation).distance, scale, within);
  const auto ray = ray_at(unit), small_ray = ray_at(scaled);
  ASSERT_EQ(ray.has_value(), small_ray.has_value());
  if (ray) {
    expect_near(ray->t, small_ray->t, scale, T(100) * within);
  }
  const auto hit = cast_towards(unit), small_hit = cast_towards(scaled);
  ASSERT_EQ(hit.has_value(), small_hit.has_value());
  if (hit) {
    EXPECT_NEAR(hit->t, small_hit->t, T(100) * within);
  }
}

template <class T, class Check>
void for_all_kinds(const Check& check) {
  if (::testing::Test::HasFailure()) return;
  for (int i = 0; i < kind_count; ++i)
    for (int j = 0; j < kind_count; ++j) {
      Random random(static_cast<unsigned>(100 * i + j));
      for (int n = 0; n < 24; ++n) {
        const auto placed = [&](int kind) -> PlacedSpecimen {
          return {random_specimen(static_cast<Kind>(kind), 1, random), random_vector(random, 1),
                  random_rotation(random)};
        };
        const PlacedSpecimen a = placed(i), b = placed(j);
        check(a, b);
        if (::testing::Test::HasFailure()) FAIL() << describe(a) << "\n" << describe(b);
      }
    }
}

template <class T>
class SmallestMagnitude : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SmallestMagnitude, Scalars);

/// A tenth is the least size of a random specimen.
TYPED_TEST(SmallestMagnitude, AnswersAboveItAreThoseAtOne) {
  using T = TypeParam;
  const T scale = std::exp2(std::ceil(std::log2(10 * smallest_magnitude<T>)));
  for_all_kinds<T>([&](PlacedSpecimen a, PlacedSpecimen b) {
    a.specimen = resolved<T>(a.specimen, scale);
    b.specimen = resolved<T>(b.specimen, scale);
    expect_scaled(scene<T>(a, b, T(1), T(1)), scene<T>(a, b, scale, scale), scale);
  });
}

/// From scenes of the bound's own size down to where nothing but zero is left.
TYPED_TEST(SmallestMagnitude, ShapesBelowItArePoints) {
  using T = TypeParam;
  const T bound = smallest_magnitude<T>, allowed = T(specimen_reach) * bound;
  for (const T apart : {T(1), bound * 1000, bound, bound / 1000, std::sqrt(std::numeric_limits<T>::min()) / 1000,
                        std::numeric_limits<T>::min()})
    for (const T size : {bound / T(specimen_reach), bound / 1000, std::numeric_limits<T>::min()})
      for_all_kinds<T>([&](const PlacedSpecimen& a, const PlacedSpecimen& b) {
        const bool plane_a = a.specimen.kind == Kind::half_space, plane_b = b.specimen.kind == Kind::half_space;
        if (plane_a && plane_b) return;
        const Scene<T> s = scene<T>(a, b, size, apart);
        const auto found = distance(s.a, s.pose_a, s.b, s.pose_b);
        const Vec3<T> way = s.pose_b.translation - s.pose_a.translation;
        const Vec3<T> up_a = rotate(s.pose_a.rotation, Vec3<T>{0, 1, 0}),
                      up_b = rotate(s.pose_b.rotation, Vec3<T>{0, 1, 0});
        const T expected = plane_a ? dot(way, up_a) : plane_b ? -dot(way, up_b) : length(way);
        EXPECT_LE(std::abs(found.distance - expected), allowed + tolerance<T> * length(way));
        EXPECT_NEAR(length(found.normal), T(1), T(1e-5));
        const bool touch = overlap(s.a, s.pose_a, s.b, s.pose_b);
        // Of a gap whose last digit is no normal number `overlap` may say that it is none.
        if (found.distance <= T(0) ||
            found.distance * std::numeric_limits<T>::epsilon() >= std::numeric_limits<T>::min()) {
          EXPECT_EQ(touch, found.distance <= T(0)) << found.distance;
        }
        if (!plane_a && !plane_b) {
          EXPECT_GE(found.distance, T(0));
        }
        const auto nearest = closest(s.a, s.pose_a, s.pose_b.translation);
        EXPECT_LE(std::abs(nearest.distance - (plane_a ? dot(way, up_a) : length(way))),
                  allowed + tolerance<T> * length(way));
        const T shallow = deepest(s, allowed);
        EXPECT_TRUE(std::isfinite(shallow));
        if (found.distance <= T(0)) {
          EXPECT_LT(shallow, allowed);
        }
        if (const auto hit = cast_towards(s)) {
          EXPECT_TRUE(std::isfinite(hit->t) && hit->t >= T(0));
        }
        if (const auto hit = ray_at(s)) {
          EXPECT_TRUE(std::isfinite(hit->t) && hit->t >= T(0));
        }
        if (::testing::Test::HasFailure()) FAIL() << "size " << size << ", apart " << apart;
      });
}

TYPED_TEST(SmallestMagnitude, IsTheSmallestThatConstructorsKeep) {
  using T = TypeParam;
  const T bound = smallest_magnitude<T>, below = std::nextafter(bound, T(0));
  EXPECT_EQ(Sphere<T>(bound).radius(), bound);
  EXPECT_EQ(Sphere<T>(below, {-below, bound, T(1)}).radius(), T(0));
  EXPECT_EQ(Sphere<T>(below, {-below, bound, T(1)}).center(), (Vec3<T>{0, bound, 1}));
  EXPECT_EQ(Box<T>({below, bound, T(1)}).core_bounds({}).upper, (Vec3<T>{0, bound / 2, T(0.5)}));
  EXPECT_EQ(Capsule<T>(below, bound).half_height(), T(0));
  EXPECT_EQ(Capsule<T>(below, bound).radius_top(), bound);
  EXPECT_EQ(Cylinder<T>(T(1), below).radius_bottom(), T(0));
  EXPECT_EQ(Ellipsoid<T>({below, bound, T(1)}).core_bounds({}).upper, (Vec3<T>{0, bound, 1}));
  EXPECT_EQ(Shape<T>(Sphere<T>(T(1)), below).rounding(), T(0));
  const std::vector<Vec3<T>> points{{below, 0, 0}, {bound, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(Triangle<T>(points[0], points[1], points[2]).core_bounds({}).upper, (Vec3<T>{bound, 1, 0}));
  EXPECT_EQ(ConvexHull<T>(std::vector<Vec3<T>>{{below, below, 0}}).core_bounds({}).upper, (Vec3<T>{0, 0, 0}));
  EXPECT_EQ(Mesh<T>({{below, 0, 0}, {1, 0, 0}, {0, 1, below}}, {{0, 1, 2}}).data().triangle(0)[0], (Vec3<T>{0, 0, 0}));
}

}  // namespace
}  // namespace graze::testing
