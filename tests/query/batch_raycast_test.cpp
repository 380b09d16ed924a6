// Many rays at a time: bit by bit what each gets alone, whatever stands beside it and whichever instructions are used.
#include "graze/batch_raycast.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "common/specimen.hpp"
#include "rays/box_rays.hpp"

namespace graze::testing {
namespace {

using rays::BlockHits;
using rays::RayBlock;

template <class T>
using Hits = std::vector<std::optional<RayHit<T>>>;

template <class T>
Hits<T> batch(const Shape<T>& shape, const Pose<T>& pose, const std::vector<Ray<T>>& rays, T length, BackFaces back) {
  Hits<T> hits(rays.size(), RayHit<T>{T(-7), {}, {}, 7});
  raycast<T>(shape, pose, rays, hits, length, back);
  return hits;
}

/// Every number the same to the bit, but for a zero's sign.
template <class T>
bool same(const std::optional<RayHit<T>>& a, const std::optional<RayHit<T>>& b) {
  if (!a || !b) return !a && !b;
  return a->t == b->t && a->point == b->point && a->normal == b->normal && a->piece == b->piece;
}

/// From near and far, from inside, along axes and edges; some that are none.
template <class T>
std::vector<Ray<T>> random_rays(Random& random, std::size_t count, float scale, const Vec3<T>& center) {
  std::vector<Ray<T>> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const float reach = i % 7 == 0 ? 0.3f : i % 11 == 0 ? 1000.0f : 3.0f;
    Ray<T> ray{center + converted<T>(random_vector(random, reach * scale)), {}};
    const Vec3<T> target = center + converted<T>(random_vector(random, 0.5f * scale));
    ray.direction = (target - ray.origin) * T(uniform(random, 0.01f, 10));
    if (i % 5 == 0) ray.direction[random() % 3] = T(0);
    if (i % 13 == 0) ray.direction = {T(0), T(i % 2 == 0 ? 1 : -1), T(0)};
    if (i % 17 == 0) ray.origin = center;
    if (i % 41 == 0) ray.direction = {};
    if (i % 43 == 0) ray.origin.x = std::numeric_limits<T>::quiet_NaN();
    if (i % 47 == 0) ray.direction.z = std::numeric_limits<T>::infinity();
    rays.push_back(ray);
  }
  return rays;
}

template <class T>
std::vector<Shape<T>> shapes(Random& random, float scale) {
  std::vector<Shape<T>> all;
  for (int kind = 0; kind < kind_count; ++kind)
    for (int i = 0; i < 2; ++i) {
      Specimen specimen = random_specimen(static_cast<Kind>(kind), scale, random);
      if (i == 0) specimen.margin = 0;
      all.push_back(build<T>(specimen));
    }
  const T s(scale);
  const Shape<T> mesh = Mesh<T>({{-s, T(0), -s}, {s, T(0), -s}, {s, T(0), s}, {-s, s, s}}, {{0, 1, 2}, {0, 2, 3}});
  all.push_back(mesh);
  all.push_back(HeightField<T>(3, 3, {T(0), s, T(0), s, T(0), s, T(0), s, T(0)}, s, s));
  all.push_back(Compound<T>({{mesh, {}}, {Sphere<T>(s / T(2)), {{s, T(0), T(0)}, {}}}}));
  all.push_back(Box<T>(Vec3<T>{s, T(0), s}));
  all.push_back(Box<T>(Vec3<T>{s, T(0), T(0)}));
  all.push_back(Sphere<T>(T(0)));
  all.insert(all.end(),
             {Capsule<T>(s, s / T(4)), Capsule<T>(s, s / T(2), T(0)), Capsule<T>(s / T(4), T(0), s),
              Capsule<T>(T(0), s), Cylinder<T>(s / T(2), s / T(2)), Cylinder<T>(s / T(2), T(0), s),
              Cylinder<T>(T(0), s), Ellipsoid<T>(Vec3<T>{s, s / T(2), s / T(64)}), Ellipsoid<T>(Vec3<T>{s, T(0), s})});
  return all;
}

template <class T>
class BatchRaycast : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(BatchRaycast, Scalars);

TYPED_TEST(BatchRaycast, AnswersAsForEachRayAlone) {
  using T = TypeParam;
  Random random(1);
  for (const float scale : {1e-4f, 1.0f, 1e4f})
    for (const Shape<T>& shape : shapes<T>(random, scale)) {
      const Pose<T> pose{converted<T>(random_vector(random, 10 * scale)),
                         random() % 3 == 0 ? Quat<T>{} : normalized(converted<T>(random_rotation(random)))};
      const T length = random() % 2 == 0 ? std::numeric_limits<T>::infinity() : T(3 * scale);
      const BackFaces back = random() % 2 == 0 ? BackFaces::hit : BackFaces::ignored;
      std::vector<Ray<T>> rays = random_rays<T>(random, 150, scale, pose.translation);
      Hits<T> alone;
      std::vector<char> any;
      for (const Ray<T>& ray : rays) {
        alone.push_back(raycast(shape, pose, ray, length, back));
        any.push_back(raycast_any(shape, pose, ray, length, back));
      }
      const Hits<T> together = batch(shape, pose, rays, length, back);
      bool found[200] = {};
      raycast_any<T>(shape, pose, rays, found, length, back);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_TRUE(same(together[i], alone[i])) << shape.name() << ", ray " << i << " at scale " << scale;
        ASSERT_EQ(found[i], any[i] != 0) << shape.name() << ", ray " << i << " at scale " << scale;
      }
      // In another order, and in pieces of any length.
      std::vector<std::size_t> order;
      for (std::size_t i = 0; i < rays.size(); ++i) order.push_back(i);
      for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
      for (std::size_t first = 0; first < order.size();) {
        const std::size_t count = std::min<std::size_t>(1 + random() % 70, order.size() - first);
        std::vector<Ray<T>> some;
        for (std::size_t i = 0; i < count; ++i) some.push_back(rays[order[first + i]]);
        const Hits<T> part = batch(shape, pose, some, length, back);
        for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(same(part[i], alone[order[first + i]])) << shape.name();
        first += count;
      }
    }
}

TYPED_TEST(BatchRaycast, LengthsThatAreNoneHitNothing) {
  using T = TypeParam;
  Random random(4);
  for (const Shape<T>& shape : shapes<T>(random, 100))
    for (const T length : {T(-1), T(-100), std::numeric_limits<T>::quiet_NaN()}) {
      const std::vector<Ray<T>> rays = random_rays<T>(random, 100, 100, {});
      for (const auto& hit : batch<T>(shape, {}, rays, length, BackFaces::hit)) EXPECT_FALSE(hit) << shape.name();
      bool found[100];
      raycast_any<T>(shape, {}, rays, found, length);
      EXPECT_EQ(std::count(found, found + 100, true), 0) << shape.name();
      for (const Ray<T>& ray : rays) EXPECT_FALSE(raycast<T>(shape, {}, ray, length)) << shape.name();
    }
}

TYPED_TEST(BatchRaycast, FillsNoMoreThanThereIsRoomFor) {
  using T = TypeParam;
  const std::vector<Ray<T>> rays(70, {{T(0), T(0), T(-5)}, {T(0), T(0), T(1)}});
  Hits<T> hits(66);
  raycast<T>(Sphere<T>(T(1)), {}, rays, std::span(hits).first(65));
  EXPECT_TRUE(hits[64]);
  EXPECT_FALSE(hits[65]);
  raycast<T>(Sphere<T>(T(1)), {}, {}, hits);
  EXPECT_TRUE(hits[0]);
}

template <class T>
struct BlockAnswers {
  RayBlock block{};
  BlockHits<T> hits{};
};
/// Expects the same states, and the same hits of the rays that hit; returns how many do.
template <class T>
std::size_t expect_same(const BlockAnswers<T>& a, const BlockAnswers<T>& b) {
  std::size_t met = 0;
  for (std::size_t i = 0; i < RayBlock::size; ++i) {
    EXPECT_EQ(a.block.state[i], b.block.state[i]);
    if (a.block.state[i] != rays::ray_hit) continue;
    EXPECT_EQ(a.hits.t[i], b.hits.t[i]);
    ++met;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(a.hits.point[k][i], b.hits.point[k][i]);
      EXPECT_EQ(a.hits.normal[k][i], b.hits.normal[k][i]);
    }
  }
  return met;
}

TYPED_TEST(BatchRaycast, GivesTheSameBitsAtEveryLevel) {
  using T = TypeParam;
  using namespace rays;
  Random random(2);
  std::size_t met = 0;
  const auto answers = [&](Isa level, const std::vector<Ray<T>>& rays, const BlockFrame& frame,
                           const BlockShape& shape) {
    BlockAnswers<T> a;
    GRAZE_KERNEL(level, block_to_local<T>)(a.block, &rays[0].origin.x, rays.size(), 1e9, frame);
    GRAZE_KERNEL(level, block_hits)(a.block, RayBlock::size, shape);
    GRAZE_KERNEL(level, block_to_world<T>)(a.block, RayBlock::size, frame, T(1e9), a.hits);
    return a;
  };
  for (const auto kind : {BlockShape::ball, BlockShape::half_space, BlockShape::triangle, BlockShape::ball_cone,
                          BlockShape::frustum, BlockShape::ellipsoid})
    for (int round = 0; round < 20; ++round) {
      BlockShape shape;
      shape.kind = kind;
      shape.radius = static_cast<double>(uniform(random, 0.1f, 2));
      shape.other_radius = shape.radius * (round % 2 == 0 ? 1 : 0.95);
      shape.around = 1e100;
      for (auto& p : shape.points)
        for (double& v : p) v = static_cast<double>(uniform(random, 0.1f, 2));
      const Mat3d turn = rotation_matrix(normalized(converted<double>(random_rotation(random))));
      BlockFrame frame{{1, -2, 3}, {}};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) frame.rotation[i][k] = turn.row[i][k];
      const auto rays = random_rays<T>(random, RayBlock::size - 3, 2, {T(1), T(-2), T(3)});
      const BlockAnswers<T> first = answers(Isa::baseline, rays, frame, shape);
      for (const Isa level : {Isa::avx2, Isa::avx512})
        if (isa_available(level)) met += expect_same(first, answers(level, rays, frame, shape));
    }
  EXPECT_TRUE(met > 500 || !isa_available(Isa::avx2)) << met;
}

TYPED_TEST(BatchRaycast, GivesTheSameBitsForABoxAtEveryLevel) {
  using T = TypeParam;
  Random random(3);
  std::size_t met = 0;
  const auto answers = [](Isa level, const std::vector<Ray<T>>& from, T length, const rays::TurnedBox& box) {
    BlockAnswers<T> a;
    GRAZE_KERNEL(level, rays_at_box<T>)(a.block, &from[0].origin.x, from.size(), length, box, a.hits);
    return a;
  };
  for (int round = 0; round < 50; ++round) {
    const Vec3<T> half{T(uniform(random, 0.1f, 2)), T(round % 5), T(uniform(random, 0.1f, 2))};
    const Pose<T> pose{{T(1), T(-2), T(3)}, converted<T>(random_rotation(random))};
    const rays::TurnedBox box(half, pose);
    const auto some = random_rays<T>(random, RayBlock::size - 3, 2, pose.translation);
    const T length(round % 3 == 0 ? 4 : 1e9);
    const BlockAnswers<T> first = answers(Isa::baseline, some, length, box);
    for (std::size_t i = 0; i < some.size(); ++i) {
      RayHit<T> hit;
      const bool hits = GRAZE_KERNEL(Isa::baseline, ray_at_box<T>)(half, pose, some[i], length, hit);
      ASSERT_EQ(first.block.state[i] != rays::ray_missed, hits);
    }
    for (const Isa level : {Isa::avx2, Isa::avx512})
      if (isa_available(level)) met += expect_same(first, answers(level, some, length, box));
  }
  EXPECT_TRUE(met > 500 || !isa_available(Isa::avx2)) << met;
}

}  // namespace
}  // namespace graze::testing
