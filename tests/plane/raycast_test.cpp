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

/// When a ray is behind all edges of a polygon, in extended precision: from the last one that it enters to the first
/// that it leaves.
struct LongSpan {
  long double enters = 0, leaves = std::numeric_limits<long double>::infinity();
};
template <class T>
LongSpan behind_edges(const std::vector<Vec2<T>>& vertices, const Ray<T>& ray) {
  using Long = Vec2<long double>;
  const Long direction = converted<long double>(ray.direction), origin = converted<long double>(ray.origin);
  LongSpan span;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Long p = converted<long double>(vertices[i]), q = converted<long double>(vertices[(i + 1) % vertices.size()]);
    const Long n = right(q - p);
    const long double above = dot(n, origin - p), toward = -dot(n, direction) / length(direction);
    if (toward > 0) span.enters = std::max(span.enters, above / toward);
    if (toward < 0) span.leaves = std::min(span.leaves, above / toward);
    if (toward == 0 && above > 0) span.leaves = -1;
  }
  return span;
}

/// Rays from outside, a third of them at a vertex, at polygons of 3 to 12 vertices and at boxes.
template <class T>
void expect_rays_as_behind_edges(T scale) {
  std::mt19937 random(12);
  std::uniform_real_distribution<T> u(-1, 1);
  int hits = 0, misses = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<Vec2<T>> vertices;
    const T h = scale * (u(random) + T(1.5)), w = scale * (u(random) + T(1.5));
    Shape<T> shape = Box<T>({2 * h, 2 * w});
    if (round % 4 == 0) {
      vertices = {{-h, -w}, {h, -w}, {h, w}, {-h, w}};
    } else {
      for (int i = 0; i < 3 + round % 10; ++i) {
        const Rot2<T> turn = Rot2<T>::from_angle(T(3.2) * u(random));
        vertices.push_back({h * turn.cosine, w * turn.sine});
      }
      const ConvexPolygon<T> polygon(vertices);
      vertices.assign(polygon.vertices().begin(), polygon.vertices().end());
      shape = polygon;
    }
    const Vec2<T> from = Vec2<T>{Rot2<T>::from_angle(3 * u(random)).cosine, u(random)} * (6 * scale);
    const Vec2<T> at = round % 3 == 0 ? vertices[0] : Vec2<T>{h * u(random), w * u(random)};
    const Ray<T> ray{from, round % 5 == 0 ? at - from : (at - from) / length(at - from)};
    const LongSpan span = behind_edges(vertices, ray);
    if (!(span.enters > 0)) continue;
    const auto hit = raycast(shape, Pose2<T>{}, ray);
    // What passes through less than rounding makes of the ray may be hit or not.
    const long double inside = span.leaves - span.enters;
    const long double rounding =
        1e3L * static_cast<long double>(std::numeric_limits<T>::epsilon()) * static_cast<long double>(scale);
    if (inside > rounding) {
      ASSERT_TRUE(hit) << round;
    }
    if (inside < -rounding) {
      ASSERT_FALSE(hit) << round;
    }
    ++(hit ? hits : misses);
    if (hit && inside > rounding) {
      ASSERT_NEAR(double(hit->t), double(span.enters), double(rounding)) << round;
    }
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(misses, 50);
}
TEST(PlaneRaycast, PolygonsAreMetWhereTheRayIsBehindAllEdges) {
  for (const float scale : {1e-3f, 1.0f, 1e6f}) expect_rays_as_behind_edges<float>(scale);
  for (const double scale : {1e-4, 1.0, 1e20}) expect_rays_as_behind_edges<double>(scale);
}

}  // namespace
}  // namespace graze::plane
