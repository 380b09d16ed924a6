// The same bodies for Debian's Box2D 2.4, and what it is asked. It has no capsules, asks its `b2DistanceProxy` instead
// where that does, and rounds all polygons a little.
#pragma once

#ifdef GRAZE_BENCH_BOX2D
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>

#include "plane_pairs.hpp"

namespace graze::plane {

struct Box2dBody {
  b2CircleShape circle;
  b2PolygonShape polygon;
  bool is_circle = false;
  b2DistanceProxy proxy;
  b2Vec2 ends[2];
  b2Transform pose;
};

inline void fill(Box2dBody& body, const Item& item, const Pose2f& pose) {
  body.pose.p = {pose.translation.x, pose.translation.y};
  body.pose.q.s = pose.rotation.sine;
  body.pose.q.c = pose.rotation.cosine;
  if (const auto* circle = item.shape.as<Circle<float>>()) {
    body.is_circle = true;
    body.circle.m_radius = circle->radius();
    body.proxy.Set(&body.circle, 0);
  } else if (const auto* box = item.shape.as<Box<float>>()) {
    body.polygon.SetAsBox(box->half_extents().x, box->half_extents().y);
    if (item.shape.rounding() != 0) body.polygon.m_radius = item.shape.rounding();
    body.proxy.Set(&body.polygon, 0);
  } else if (const auto* capsule = item.shape.as<Capsule<float>>()) {
    body.ends[0] = {0, -capsule->half_height()};
    body.ends[1] = {0, capsule->half_height()};
    body.proxy.Set(body.ends, 2, capsule->radius_top());
  } else if (const auto* segment = item.shape.as<Segment<float>>()) {
    body.ends[0] = {segment->a().x, segment->a().y};
    body.ends[1] = {segment->b().x, segment->b().y};
    body.proxy.Set(body.ends, 2, 0);
  } else {
    std::vector<b2Vec2> points;
    for (const Vec2f& v : item.vertices) points.push_back({v.x, v.y});
    body.polygon.Set(points.data(), static_cast<int>(points.size()));
    body.proxy.Set(&body.polygon, 0);
  }
}

/// Its points in the world too, as all others have them.
inline void box2d_manifold(const Box2dBody& a, const Box2dBody& b) {
  b2Manifold manifold;
  manifold.pointCount = 0;
  if (a.is_circle)
    b2CollideCircles(&manifold, &a.circle, a.pose, &b.circle, b.pose);
  else if (b.is_circle)
    b2CollidePolygonAndCircle(&manifold, &a.polygon, a.pose, &b.circle, b.pose);
  else
    b2CollidePolygons(&manifold, &a.polygon, a.pose, &b.polygon, b.pose);
  if (manifold.pointCount == 0) return;
  b2WorldManifold world;
  world.Initialize(&manifold, a.pose, a.is_circle ? a.circle.m_radius : a.polygon.m_radius, b.pose,
                   b.is_circle ? b.circle.m_radius : b.polygon.m_radius);
  kept = kept + double(world.separations[0]);
}

inline void box2d_distance(const Box2dBody& a, const Box2dBody& b) {
  b2DistanceInput input;
  input.proxyA = a.proxy;
  input.proxyB = b.proxy;
  input.transformA = a.pose;
  input.transformB = b.pose;
  input.useRadii = true;
  b2SimplexCache cache;
  cache.count = 0;
  b2DistanceOutput output;
  b2Distance(&output, &cache, &input);
  kept = kept + double(output.distance);
}

/// B moves without turning. Box2D answers a fraction of the way.
inline void box2d_cast(const Box2dBody& a, const Box2dBody& b, const b2Vec2& way) {
  b2ShapeCastInput input;
  input.proxyA = a.proxy;
  input.proxyB = b.proxy;
  input.transformA = a.pose;
  input.transformB = b.pose;
  input.translationB = way;
  b2ShapeCastOutput output;
  if (b2ShapeCast(&output, &input)) kept = kept + double(output.lambda);
}

inline b2Sweep box2d_sweep(const b2Transform& from, const b2Vec2& way, float turn) {
  b2Sweep sweep;
  sweep.localCenter = {0, 0};
  sweep.c0 = from.p;
  sweep.c = from.p + way;
  sweep.a0 = from.q.GetAngle();
  sweep.a = sweep.a0 + turn;
  sweep.alpha0 = 0;
  return sweep;
}
inline void box2d_impact(const Box2dBody& a, const Box2dBody& b, const b2Sweep& at_a, const b2Sweep& sweep_b) {
  b2TOIInput input;
  input.proxyA = a.proxy;
  input.proxyB = b.proxy;
  input.sweepA = at_a;
  input.sweepB = sweep_b;
  input.tMax = 1;
  b2TOIOutput output;
  b2TimeOfImpact(&output, &input);
  kept = kept + double(output.t);
}

inline void box2d_ray(const Box2dBody& a, const b2Vec2& from, const b2Vec2& way) {
  b2RayCastInput input;
  input.p1 = from;
  input.p2 = from + way;
  input.maxFraction = 1;
  b2RayCastOutput output;
  const b2Shape& shape = a.is_circle ? static_cast<const b2Shape&>(a.circle) : a.polygon;
  if (shape.RayCast(&output, input, a.pose, 0)) kept = kept + double(output.fraction);
}

/// Whether it has the shape as such, and not only as points.
inline bool box2d_has(const Shapef& s) {
  return s.as<Circle<float>>() || s.as<Box<float>>() || s.as<ConvexPolygon<float>>();
}

}  // namespace graze::plane
#endif
