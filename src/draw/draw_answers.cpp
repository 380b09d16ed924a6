// The drawing of shapes and of the answers of queries.
#include <algorithm>

#include "draw/in_space.hpp"
#include "draw/motion_copies.hpp"
#include "draw/points.hpp"
#include "graze/draw.hpp"

namespace graze {

namespace {

using draw_detail::draw_points;
using draw_detail::in_space;

template <class AnyShape, class AnyPose>
void draw_shape(DebugDraw& on, const AnyShape& shape, const AnyPose& pose, DrawLayer layer, DrawMeaning meaning) {
  if (on.wants(layer)) on.polygons(tessellate(shape, pose, on.area().center, on.area().size), layer, meaning);
}

template <class AnyDistance>
void draw_distance(DebugDraw& on, const AnyDistance& d) {
  if (!on.wants(DrawLayer::distances)) return;
  const Vec3d a = in_space(d.a), b = in_space(d.b);
  on.line(a, b, DrawLayer::distances, DrawMeaning::gap);
  on.point(a, DrawLayer::distances, DrawMeaning::a);
  on.point(b, DrawLayer::distances, DrawMeaning::b);
}

/// Draws a hit of a ray or of a moving body.
template <class AnyHit>
void draw_hit(DebugDraw& on, const AnyHit& hit, DrawLayer layer) {
  on.point(in_space(hit.point), layer, DrawMeaning::contact);
  on.arrow(in_space(hit.point), in_space(hit.normal), layer, DrawMeaning::normal);
}

template <class AnyRay, class T, class AnyHit>
void draw_ray(DebugDraw& on, const AnyRay& ray, T length, const std::optional<AnyHit>& hit) {
  if (!on.wants(DrawLayer::rays)) return;
  const Vec3d origin = in_space(ray.origin), way = normalized(in_space(ray.direction), Vec3d{});
  if (hit) {
    on.line(origin, in_space(hit->point), DrawLayer::rays, DrawMeaning::path);
    return draw_hit(on, *hit, DrawLayer::rays);
  }
  // A ray without an end leaves the area.
  const double out = graze::length(origin - on.area().center) + on.area().size;
  const Vec3d end = origin + way * std::min(double(length), out);
  on.line(origin, end, DrawLayer::rays, DrawMeaning::path);
  on.arrow(end, way, DrawLayer::rays, DrawMeaning::path);
}

template <class T>
double rate(const Vec3<T>& turning) {
  return length(converted<double>(turning));
}
double rate(double turning) { return std::abs(turning); }

template <class AnyShape, class AnyPose, class AnyVelocity, class T, class AnyHit>
void draw_cast(DebugDraw& on, const AnyShape& shape, const AnyPose& pose, const AnyVelocity& velocity, T duration,
               const std::optional<AnyHit>& hit) {
  if (!on.wants(DrawLayer::casts)) return;
  const T until = hit ? hit->t : duration;
  const int copies = draw_detail::motion_copies(rate(velocity.angular), double(until));
  for (int i = 1; i < copies && until > T(0); ++i)
    draw_shape(on, shape, pose_at(pose, velocity, until * T(i) / T(copies)), DrawLayer::casts, DrawMeaning::ghost);
  const AnyPose last = pose_at(pose, velocity, until);
  draw_shape(on, shape, last, DrawLayer::casts, hit ? DrawMeaning::touching : DrawMeaning::moving);
  on.line(in_space(pose.translation), in_space(last.translation), DrawLayer::casts, DrawMeaning::path);
  if (hit) draw_hit(on, *hit, DrawLayer::casts);
}

}  // namespace

template <class T>
void draw(DebugDraw& on, const Shape<T>& shape, const Pose<T>& pose, DrawMeaning meaning) {
  draw_shape(on, shape, pose, DrawLayer::shapes, meaning);
}
template <class T>
void draw(DebugDraw& on, const plane::Shape<T>& shape, const plane::Pose2<T>& pose, DrawMeaning meaning) {
  draw_shape(on, shape, pose, DrawLayer::shapes, meaning);
}

template <class T>
void draw(DebugDraw& on, const Aabb<T>& box, DrawLayer layer, DrawMeaning meaning) {
  const bool bounded = max_abs(box.extent()) < std::numeric_limits<T>::infinity();
  if (!on.wants(layer) || !bounded || !(box.lower.x <= box.upper.x)) return;
  const Vec3d corners[2] = {in_space(box.lower), in_space(box.upper)};
  const auto corner = [&](std::size_t i) {
    return Vec3d{corners[i & 1].x, corners[i >> 1 & 1].y, corners[i >> 2 & 1].z};
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 8; ++i) {
      const std::size_t along = std::size_t{1} << axis;
      if ((i & along) != 0 || corner(i) == corner(i | along)) continue;
      // An edge of a flat box falls upon another of a lower number.
      bool again = false;
      for (std::size_t side = 0; side < 3; ++side)
        again = again || (side != axis && (i >> side & 1) != 0 && corners[0][side] == corners[1][side]);
      if (!again) on.line(corner(i), corner(i | along), layer, meaning);
    }
}

template <class T>
void draw(DebugDraw& on, const Manifold<T>& manifold) {
  draw_points(on, manifold.normal, std::span(std::as_const(manifold.points).begin(), manifold.points.size()));
}
template <class T>
void draw(DebugDraw& on, const plane::Manifold<T>& manifold) {
  draw_points(on, manifold.normal, std::span(std::as_const(manifold.points).begin(), manifold.points.size()));
}

template <class T>
void draw(DebugDraw& on, const Distance<T>& distance) {
  draw_distance(on, distance);
}
template <class T>
void draw(DebugDraw& on, const plane::Distance<T>& distance) {
  draw_distance(on, distance);
}

template <class T>
void draw(DebugDraw& on, const Ray<T>& ray, T length, const std::optional<RayHit<T>>& hit) {
  draw_ray(on, ray, length, hit);
}
template <class T>
void draw(DebugDraw& on, const plane::Ray<T>& ray, T length, const std::optional<plane::RayHit<T>>& hit) {
  draw_ray(on, ray, length, hit);
}

template <class T>
void draw(DebugDraw& on, const Shape<T>& shape, const Pose<T>& pose, const Velocity<T>& velocity, T duration,
          const std::optional<CastHit<T>>& hit) {
  draw_cast(on, shape, pose, velocity, duration, hit);
}
template <class T>
void draw(DebugDraw& on, const plane::Shape<T>& shape, const plane::Pose2<T>& pose, const plane::Velocity<T>& velocity,
          T duration, const std::optional<plane::CastHit<T>>& hit) {
  draw_cast(on, shape, pose, velocity, duration, hit);
}

#define GRAZE_DRAW_ANSWERS(T)                                                                                          \
  template void draw(DebugDraw&, const Shape<T>&, const Pose<T>&, DrawMeaning);                                        \
  template void draw(DebugDraw&, const plane::Shape<T>&, const plane::Pose2<T>&, DrawMeaning);                         \
  template void draw(DebugDraw&, const Aabb<T>&, DrawLayer, DrawMeaning);                                              \
  template void draw(DebugDraw&, const Manifold<T>&);                                                                  \
  template void draw(DebugDraw&, const plane::Manifold<T>&);                                                           \
  template void draw(DebugDraw&, const Distance<T>&);                                                                  \
  template void draw(DebugDraw&, const plane::Distance<T>&);                                                           \
  template void draw(DebugDraw&, const Ray<T>&, T, const std::optional<RayHit<T>>&);                                   \
  template void draw(DebugDraw&, const plane::Ray<T>&, T, const std::optional<plane::RayHit<T>>&);                     \
  template void draw(DebugDraw&, const Shape<T>&, const Pose<T>&, const Velocity<T>&, T,                               \
                     const std::optional<CastHit<T>>&);                                                                \
  template void draw(DebugDraw&, const plane::Shape<T>&, const plane::Pose2<T>&, const plane::Velocity<T>&, T,         \
                     const std::optional<plane::CastHit<T>>&)
GRAZE_DRAW_ANSWERS(float);
GRAZE_DRAW_ANSWERS(double);
#undef GRAZE_DRAW_ANSWERS

}  // namespace graze
