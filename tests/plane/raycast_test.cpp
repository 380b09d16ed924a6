// Rays in the plane: misses of rays without end, any hit and all hits, against the hits of the pieces one by one.
#include <gtest/gtest.h>

#include <random>

#include "graze/plane/cast.hpp"

namespace graze::plane {
namespace {

TEST(PlaneRaycast, ARayWithoutEndThatMissesHitsNothing) {
  const std::vector<Vec2d> triangle{{0, 0}, {1, 0}, {0, 1}};
  for (const Shaped& shape :
       {Shaped(Box<double>({1, 1})), Shaped(Box<double>({1, 1}), 0.2), Shaped(Circle<double>(1)),
        Shaped(Segment<double>({-1, 0}, {1, 0})), Shaped(Capsule<double>(1, 0.2)),
        Shaped(ConvexPolygon<double>(triangle)), Shaped(Polygon<double>(triangle)),
        Shaped(Chain<double>(triangle, true)), Shaped(Ellipse<double>({1, 0.5})), Shaped(Box<double>({0, 0}))}) {
    EXPECT_FALSE(raycast(shape, Pose2d{}, Ray<double>{{-4, 5}, {1, -0.1}})) << shape.name();
    EXPECT_FALSE(raycast(shape, Pose2d{}, Ray<double>{{-4, 0.1}, {-1, 0}})) << shape.name();
    EXPECT_FALSE(raycast_any(shape, Pose2d{}, Ray<double>{{-4, 5}, {1, -0.1}})) << shape.name();
  }
}

/// A chain of many segments with steps up and down.
Chain<double> terrain(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> height(-1, 1);
  std::vector<Vec2d> points;
  for (int i = 0; i <= count; ++i) points.push_back({double(i), height(random)});
  return Chain<double>(points);
}

TEST(PlaneRaycast, AllHitsAreThoseOfThePieces) {
  const Chain<double> chain = terrain(300);
  const Pose2d pose{{3, -2}, Rot2d::from_angle(0.4)};
  std::mt19937 random(6);
  std::uniform_real_distribution<double> u(-1, 1);
  std::size_t total = 0, misses = 0;
  for (int round = 0; round < 300; ++round) {
    const Vec2d from = transform(pose, Vec2d{150 + 200 * u(random), 3 * u(random)});
    const Ray<double> ray{from, rotate(pose.rotation, Vec2d{u(random), 0.2 * u(random)})};
    const double length = round % 2 ? std::numeric_limits<double>::infinity() : 100;
    std::vector<RayHit<double>> hits, alone;
    raycast_all(Shaped(chain, 0.05), pose, ray, hits, length);
    for (std::uint32_t i = 0; i < chain.pieces().size(); ++i) {
      const auto ends = chain.pieces().vertices(i);
      if (auto hit = raycast(Shaped(Segment<double>(ends[0], ends[1]), 0.05), pose, ray, length)) {
        hit->piece = i;
        alone.push_back(*hit);
      }
    }
    std::stable_sort(alone.begin(), alone.end(), [](auto& p, auto& q) { return p.t < q.t; });
    ASSERT_EQ(hits.size(), alone.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
      EXPECT_EQ(hits[i].t, alone[i].t);
      EXPECT_EQ(hits[i].piece, alone[i].piece);
    }
    const auto first = raycast(Shaped(chain, 0.05), pose, ray, length);
    ASSERT_EQ(first.has_value(), !hits.empty());
    EXPECT_EQ(raycast_any(Shaped(chain, 0.05), pose, ray, length), !hits.empty());
    if (first) {
      EXPECT_EQ(first->t, hits[0].t);
    }
    total += hits.size();
    misses += hits.empty();
  }
  EXPECT_GT(total, 500u);
  EXPECT_GT(misses, 20u);
}

TEST(PlaneRaycast, ATraceChangesNothing) {
  const Shaped shapes[] = {Shaped(terrain(20)), Shaped(Ellipse<double>({3, 1})), Shaped(Box<double>({3, 1}), 0.2),
                           Shaped(HalfPlane<double>())};
  std::mt19937 random(8);
  std::uniform_real_distribution<double> u(-1, 1);
  for (const Shaped& shape : shapes)
    for (int round = 0; round < 200; ++round) {
      const Ray<double> ray{{20 * u(random), 4 * u(random)}, {u(random), u(random)}};
      Trace trace;
      const auto with = raycast(shape, Pose2d{}, ray, 30.0, &trace), without = raycast(shape, Pose2d{}, ray, 30.0);
      ASSERT_EQ(with.has_value(), without.has_value());
      EXPECT_FALSE(trace.method.empty());
      if (with) {
        EXPECT_TRUE(with->t == without->t && with->normal == without->normal && with->piece == without->piece);
      }
    }
}

TEST(PlaneCast, AllContactsOfACastAreThoseOfThePieces) {
  const Shaped two(Compound<double>({{Box<double>({1, 1}), {{0, 0}, {}}}, {Circle<double>(0.5), {{0, 3}, {}}}}));
  const Shaped bar(Box<double>({0.5, 6}));
  std::vector<CastHit<double>> hits;
  cast_all(two, Pose2d{{0, 0}, {}}, {}, bar, Pose2d{{-5, 1}, {}}, Velocity<double>{{1, 0}, 0}, 10.0, hits);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].t, 4.25);
  EXPECT_EQ(hits[1].t, 4.25);
  EXPECT_EQ(hits[0].piece_a, 0u);
  EXPECT_EQ(hits[1].piece_a, 1u);
  Trace trace;
  const auto first = cast(two, Pose2d{}, {}, bar, Pose2d{{-5, 1}, {}}, Velocity<double>{{1, 0}, 0}, 10.0, {}, &trace);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->t, 4.25);
  EXPECT_EQ(trace.pieces, 2u);
}

}  // namespace
}  // namespace graze::plane
