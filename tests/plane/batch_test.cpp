// Many pairs of the plane at once have the bits that each has alone. CMake runs these at every level of the
// instruction set (lanes.plane_*).
#include "graze/plane/batch.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "common/executors.hpp"
#include "plane/figures.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneBatch : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneBatch, Scalars);

template <class T>
::testing::AssertionResult same_bits(const T& a, const T& b) {
  if (std::memcmp(&a, &b, sizeof a) == 0) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << double(a) << " is not " << double(b);
}
template <class T>
void expect_same(const Vec2<T>& a, const Vec2<T>& b) {
  EXPECT_TRUE(same_bits(a.x, b.x));
  EXPECT_TRUE(same_bits(a.y, b.y));
}

/// Bodies of all kinds, some with a rotation that is not of unit length, which no kernel takes.
template <class T>
void make_bodies(std::size_t count, std::vector<Shape<T>>& shapes, std::vector<Pose2<T>>& poses) {
  std::mt19937 random(5);
  for (std::size_t i = 0; i < count; ++i) {
    shapes.push_back(random() % 16 == 0 ? Shape<T>(HalfPlane<T>())
                                        : random_figure<T>(static_cast<int>(random() % figure_kinds), 1, random).shape);
    poses.push_back(random_pose<T>(0.6, random));
    if (random() % 32 == 0) poses.back().rotation.cosine *= T(1.5), poses.back().rotation.sine *= T(1.5);
  }
}

template <class T>
std::vector<IdPair> make_pairs(std::size_t bodies, std::size_t count) {
  std::mt19937 random(6);
  std::vector<IdPair> pairs;
  for (std::size_t i = 0; i < count; ++i)
    pairs.push_back({static_cast<std::uint32_t>(random() % bodies), static_cast<std::uint32_t>(random() % bodies)});
  return pairs;
}

template <class T>
void expect_as_alone(const Batch<T>& batch, const std::vector<Shape<T>>& a, const std::vector<Pose2<T>>& pose_a,
                     const std::vector<Shape<T>>& b, const std::vector<Pose2<T>>& pose_b, Executor* executor) {
  std::vector<std::uint8_t> touch;
  std::vector<Distance<T>> distances;
  BatchContacts<T> found;
  const T margin = T(0.1);
  overlap(batch, touch, executor);
  distance(batch, distances, executor);
  contacts(batch, margin, found, executor);
  ASSERT_EQ(touch.size(), batch.size());
  ASSERT_EQ(distances.size(), batch.size());
  ASSERT_EQ(found.pairs.size(), batch.size());
  std::size_t points = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const IdPair p = batch[i];
    const Distance<T> alone = distance(a[p.a], pose_a[p.a], b[p.b], pose_b[p.b]);
    ASSERT_EQ(touch[i] != 0, overlap(a[p.a], pose_a[p.a], b[p.b], pose_b[p.b])) << i;
    EXPECT_TRUE(same_bits(distances[i].distance, alone.distance));
    expect_same(distances[i].normal, alone.normal);
    expect_same(distances[i].a, alone.a);
    expect_same(distances[i].b, alone.b);
    EXPECT_EQ(distances[i].status, alone.status);
    Manifolds<T> manifolds;
    ASSERT_EQ(contacts(a[p.a], pose_a[p.a], b[p.b], pose_b[p.b], margin, manifolds), found.pairs[i].overlap) << i;
    ASSERT_EQ(found.manifolds_of(i).size(), manifolds.size()) << i;
    for (std::size_t m = 0; m < manifolds.size(); ++m) {
      const auto& group = found.manifolds_of(i)[m];
      expect_same(group.normal, manifolds[m].normal);
      const auto there = found.points_of(group);
      ASSERT_EQ(there.size(), manifolds[m].points.size()) << i;
      for (std::size_t k = 0; k < there.size(); ++k, ++points) {
        expect_same(there[k].a, manifolds[m].points[k].a);
        expect_same(there[k].b, manifolds[m].points[k].b);
        EXPECT_TRUE(same_bits(there[k].distance, manifolds[m].points[k].distance));
        EXPECT_TRUE(same_bits(there[k].weight, manifolds[m].points[k].weight));
        EXPECT_EQ(there[k].feature, manifolds[m].points[k].feature);
      }
    }
    if (::testing::Test::HasFailure()) FAIL() << a[p.a].name() << " and " << b[p.b].name() << ", pair " << i;
  }
  EXPECT_GE(points, batch.size() / 8);
}

TYPED_TEST(PlaneBatch, HasTheBitsOfEachPairAlone) {
  using T = TypeParam;
  std::vector<Shape<T>> shapes;
  std::vector<Pose2<T>> poses;
  make_bodies<T>(500, shapes, poses);
  const std::vector<IdPair> pairs = make_pairs<T>(shapes.size(), 9000);
  const Bodies<T> bodies(shapes, poses);
  expect_as_alone<T>(Batch<T>(bodies, bodies, pairs), shapes, poses, shapes, poses, nullptr);
}

// The arrays are the same too, with their order.
TYPED_TEST(PlaneBatch, ThreadsChangeNothing) {
  using T = TypeParam;
  std::vector<Shape<T>> shapes;
  std::vector<Pose2<T>> poses;
  make_bodies<T>(300, shapes, poses);
  const std::vector<IdPair> pairs = make_pairs<T>(shapes.size(), 20000);
  const Bodies<T> bodies(shapes, poses);
  const Batch<T> batch(bodies, bodies, pairs);
  graze::testing::ThreadExecutor threads(4);
  BatchContacts<T> one, four;
  std::vector<Distance<T>> distances_one, distances_four;
  contacts(batch, T(0.1), one);
  contacts(batch, T(0.1), four, &threads);
  distance(batch, distances_one);
  distance(batch, distances_four, &threads);
  ASSERT_EQ(one.manifolds.size(), four.manifolds.size());
  ASSERT_EQ(one.points.size(), four.points.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(one.pairs[i].overlap, four.pairs[i].overlap);
    EXPECT_EQ(one.pairs[i].first_manifold, four.pairs[i].first_manifold);
    EXPECT_EQ(one.pairs[i].manifold_count, four.pairs[i].manifold_count);
    EXPECT_TRUE(same_bits(distances_one[i].distance, distances_four[i].distance));
  }
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    expect_same(one.points[i].a, four.points[i].a);
    EXPECT_EQ(one.points[i].feature, four.points[i].feature);
  }
}

// Shapes of one kind a side, held tightly; few pairs and many, so that registers are filled and not.
TYPED_TEST(PlaneBatch, OneKindASide) {
  using T = TypeParam;
  std::mt19937 random(8);
  for (const std::size_t count : {1u, 3u, 16u, 17u, 64u, 65u, 1000u}) {
    std::vector<Box<T>> boxes;
    std::vector<Capsule<T>> capsules;
    std::vector<Shape<T>> any_boxes, any_capsules;
    std::vector<Pose2<T>> poses_a, poses_b;
    for (std::size_t i = 0; i < count; ++i) {
      const auto size = [&] { return static_cast<T>(std::uniform_real_distribution<double>(0.2, 2)(random)); };
      const T width = size(), height = size(), length = size(), radius = size() / 4;
      boxes.push_back(Box<T>({width, height}));
      capsules.push_back(random() % 8 ? Capsule<T>(length, radius) : Capsule<T>(length, radius, radius / 2));
      any_boxes.push_back(boxes.back());
      any_capsules.push_back(capsules.back());
      poses_a.push_back(random_pose<T>(0.4, random));
      poses_b.push_back(random_pose<T>(0.4, random));
    }
    const Bodies<T> a(boxes, poses_a), b(capsules, poses_b);
    expect_as_alone<T>(Batch<T>(a, b), any_boxes, poses_a, any_capsules, poses_b, nullptr);
    expect_as_alone<T>(Batch<T>(b, a), any_capsules, poses_b, any_boxes, poses_a, nullptr);
  }
}

TEST(PlaneBatches, PlacesThatAreNotThereAreRefused) {
  const std::vector<Circle<float>> shapes(3, Circle<float>(1));
  const std::vector<Pose2f> poses(3), two(2);
  const Bodies<float> bodies(shapes, poses);
  const std::vector<IdPair> pairs{{0, 1}, {2, 3}};
  EXPECT_THROW(Batch<float>(bodies, bodies, pairs), InvalidValue);
  EXPECT_THROW(Bodies<float>(shapes, two), InvalidValue);
  const std::vector<Circle<float>> four(4, Circle<float>(1));
  const std::vector<Pose2f> four_poses(4);
  EXPECT_THROW(Batch<float>(bodies, Bodies<float>(four, four_poses)), InvalidValue);
}

/// Rays of all sorts at a shape: from all around, from within, along axes, through corners, and what is none.
template <class T>
std::vector<Ray<T>> make_rays(const Shape<T>& shape, const Pose2<T>& pose, std::size_t count, std::mt19937& random) {
  const auto number = [&] { return static_cast<T>(random() % 2001) / T(1000) - T(1); };
  const auto place = [&] {
    const T x = number();
    return Vec2<T>{x, number()};
  };
  std::vector<Vec2<T>> corners{pose.translation};
  if (const auto* polygon = shape.template as<ConvexPolygon<T>>())
    for (const Vec2<T>& p : polygon->vertices()) corners.push_back(transform(pose, p));
  if (const auto* box = shape.template as<Box<T>>()) corners.push_back(transform(pose, box->half_extents()));
  std::vector<Ray<T>> rays;
  for (std::size_t i = 0; i < count; ++i) {
    Ray<T> ray{place() * T(3), place()};
    const Vec2<T> corner = corners[random() % corners.size()];
    if (i % 5 == 1) ray.direction = corner - ray.origin;
    if (i % 7 == 2) ray.origin = corner;
    if (i % 11 == 3) ray.direction.x = T(0);
    if (i % 13 == 4) ray.direction = {};
    if (i % 17 == 5) ray.origin.y = std::numeric_limits<T>::quiet_NaN();
    if (i % 19 == 6) ray.direction = ray.direction * T(1e-30);
    rays.push_back(ray);
  }
  return rays;
}

TYPED_TEST(PlaneBatch, RaysAreThoseOfEachAlone) {
  using T = TypeParam;
  std::mt19937 random(9);
  std::size_t hit_count = 0, rays_in_all = 0;
  for (int round = 0; round < 300; ++round) {
    const Shape<T> shape =
        round % 3 == 0 ? Shape<T>(Box<T>({T(1), T(0.6)})) : random_figure<T>(round % figure_kinds, 1, random).shape;
    Pose2<T> pose = random_pose<T>(0.6, random);
    if (round % 8 == 0) pose.rotation.cosine *= T(1.5), pose.rotation.sine *= T(1.5);
    const std::vector<Ray<T>> rays = make_rays(shape, pose, round % 150, random);
    const T length = round % 4 == 0 ? T(2) : std::numeric_limits<T>::infinity();
    std::vector<std::optional<RayHit<T>>> hits(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    raycast<T>(shape, pose, rays, hits, length);
    raycast_any<T>(shape, pose, rays, {reinterpret_cast<bool*>(any.data()), any.size()}, length);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const std::optional<RayHit<T>> alone = raycast(shape, pose, rays[i], length);
      ASSERT_EQ(hits[i].has_value(), alone.has_value()) << shape.name() << " " << i;
      ASSERT_EQ(any[i] != 0, raycast_any(shape, pose, rays[i], length)) << shape.name() << " " << i;
      ++rays_in_all;
      if (!alone) continue;
      ++hit_count;
      ASSERT_TRUE(same_bits(hits[i]->t, alone->t)) << shape.name() << " " << i;
      expect_same(hits[i]->point, alone->point);
      expect_same(hits[i]->normal, alone->normal);
      ASSERT_EQ(hits[i]->piece, alone->piece);
      ASSERT_EQ(hits[i]->status, alone->status);
    }
  }
  EXPECT_GT(hit_count, rays_in_all / 8);
  EXPECT_LT(hit_count, rays_in_all * 3 / 4);
  // Rays without a place for their answer are left out.
  const std::vector<Ray<T>> rays(9, Ray<T>{{T(-3), T(0)}, {T(1), T(0)}});
  std::vector<std::optional<RayHit<T>>> hits(6);
  raycast<T>(Box<T>({T(1), T(1)}), {}, rays, hits);
  for (const auto& hit : hits) EXPECT_EQ(hit->t, T(2.5));
  raycast<T>(Box<T>({T(1), T(1)}), {}, rays, hits, T(-1));
  for (const auto& hit : hits) EXPECT_FALSE(hit.has_value());
}

/// Motions that meet or pass, some of which turn.
template <class T>
std::vector<Velocity<T>> make_velocities(std::size_t count, std::mt19937& random) {
  std::vector<Velocity<T>> out;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2<T> linear = random_pose<T>(1, random).translation;
    out.push_back({linear, random() % 3 == 0 ? static_cast<T>(random() % 7) / T(3) - T(1) : T(0)});
  }
  return out;
}

template <class T>
void expect_casts_as_alone(const std::vector<std::optional<CastHit<T>>>& hits, const Batch<T>& batch,
                           const std::vector<Velocity<T>>& of_a, const std::vector<Velocity<T>>& of_b,
                           const CastOptions& options) {
  ASSERT_EQ(hits.size(), batch.size());
  std::size_t met = 0, turned = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const IdPair p = batch[i];
    const Velocity<T>&va = of_a[of_a.size() == 1 ? 0 : p.a], &vb = of_b[of_b.size() == 1 ? 0 : p.b];
    batch.a().visit(p.a, [&](const Shape<T>& a) {
      batch.b().visit(p.b, [&](const Shape<T>& b) {
        const auto alone = cast(a, batch.a().pose(p.a), va, b, batch.b().pose(p.b), vb, T(1), options);
        ASSERT_EQ(hits[i].has_value(), alone.has_value()) << a.name() << " and " << b.name() << ", pair " << i;
        if (!alone) return;
        ++met;
        turned += va.angular != 0 || vb.angular != 0;
        EXPECT_TRUE(same_bits(hits[i]->t, alone->t));
        EXPECT_TRUE(same_bits(hits[i]->depth, alone->depth));
        expect_same(hits[i]->point, alone->point);
        expect_same(hits[i]->normal, alone->normal);
        EXPECT_EQ(hits[i]->status, alone->status);
        EXPECT_EQ(hits[i]->piece_a, alone->piece_a);
        EXPECT_EQ(hits[i]->piece_b, alone->piece_b);
        if (::testing::Test::HasFailure()) FAIL() << a.name() << " and " << b.name() << ", pair " << i;
      });
    });
  }
  EXPECT_GT(met, batch.size() / 8);
  EXPECT_LT(met, batch.size());
  EXPECT_GT(turned, met / 8);
}

TYPED_TEST(PlaneBatch, CastsAreThoseOfEachAlone) {
  using T = TypeParam;
  std::mt19937 random(12);
  std::vector<Shape<T>> shapes;
  std::vector<Pose2<T>> poses;
  make_bodies<T>(300, shapes, poses);
  for (Pose2<T>& pose : poses) pose.translation = pose.translation * T(2);
  const std::vector<Velocity<T>> velocities = make_velocities<T>(shapes.size(), random), one{velocities[0]};
  const std::vector<IdPair> pairs = make_pairs<T>(shapes.size(), 5000);
  const std::vector<Pose2<T>> moved(poses.rbegin(), poses.rend());
  const Bodies<T> bodies(shapes, poses), others(shapes, moved);
  graze::testing::ThreadExecutor threads(4);
  for (const Separating separating : {Separating::hit, Separating::ignored}) {
    const CastOptions options{separating};
    std::vector<std::optional<CastHit<T>>> hits;
    cast(Batch<T>(bodies, bodies, pairs), velocities, velocities, T(1), hits, options);
    expect_casts_as_alone(hits, Batch<T>(bodies, bodies, pairs), velocities, velocities, options);
    cast(Batch<T>(bodies, bodies, pairs), velocities, velocities, T(1), hits, options, &threads);
    expect_casts_as_alone(hits, Batch<T>(bodies, bodies, pairs), velocities, velocities, options);
    cast(Batch<T>(bodies, others), one, velocities, T(1), hits, options);
    expect_casts_as_alone(hits, Batch<T>(bodies, others), one, velocities, options);
  }
  // One kind a side, held tightly.
  const std::vector<Box<T>> boxes(poses.size(), Box<T>({T(1), T(0.5)}));
  const std::vector<Circle<T>> circle(1, Circle<T>(T(0.8)));
  const Batch<T> tight(Bodies<T>(circle, poses), Bodies<T>(boxes, poses), pairs);
  std::vector<std::optional<CastHit<T>>> hits;
  cast(tight, velocities, velocities, T(1), hits);
  expect_casts_as_alone(hits, tight, velocities, velocities, {});
  const std::vector<Velocity<T>> too_few(2);
  EXPECT_THROW(cast(tight, too_few, velocities, T(1), hits), InvalidValue);
  EXPECT_THROW(cast(tight, velocities, too_few, T(1), hits), InvalidValue);
}

TYPED_TEST(PlaneBatch, NearestPointsAreThoseOfEachAlone) {
  using T = TypeParam;
  std::mt19937 random(13);
  graze::testing::ThreadExecutor threads(4);
  for (int kind = 0; kind < figure_kinds; ++kind) {
    const Shape<T> shape = random_figure<T>(kind, 1, random).shape;
    const Pose2<T> pose = random_pose<T>(1, random);
    std::vector<Vec2<T>> points;
    for (int i = 0; i < 5000; ++i) points.push_back(random_pose<T>(1, random).translation);
    std::vector<Closest<T>> one(points.size()), four(points.size());
    closest(shape, pose, points, one);
    closest(shape, pose, points, four, &threads);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Closest<T> alone = closest(shape, pose, points[i]);
      for (const Closest<T>& found : {one[i], four[i]}) {
        ASSERT_TRUE(same_bits(found.distance, alone.distance)) << shape.name();
        expect_same(found.point, alone.point);
        expect_same(found.normal, alone.normal);
        ASSERT_EQ(found.status, alone.status);
        ASSERT_TRUE(same_bits(found.error, alone.error));
      }
    }
    // Points without a place for their answer are left out.
    std::vector<Closest<T>> few(2);
    closest(shape, pose, points, few);
    EXPECT_TRUE(same_bits(few[1].distance, one[1].distance));
  }
}

}  // namespace
}  // namespace graze::plane
