// Rays at convex shapes, each kind with its own function, in the shape's frame.
#pragma once

#include "rays/convex_raycast.hpp"
#include "rays/planes.hpp"
#include "rays/point_distance.hpp"
#include "rays/quadrics.hpp"

namespace graze::rays {

template <class T>
double wide(T value) {
  return static_cast<double>(value);
}

/// Distance at which an advancing ray counts as hitting. A user's support function answers in the shape's scalar, and
/// is as exact as that.
template <class C, class T>
double slack_of(const C& concrete, T rounding) {
  const double unit = std::is_same_v<C, UserConvex<T>> ? 8 * wide(std::numeric_limits<T>::epsilon()) : 0;
  return greatest(rounding_error, unit) * (wide(concrete.core_extent()) + wide(rounding));
}

/// The hit by advancement. Out of line, so that the closed forms are short enough to be inlined; the ray by value, so
/// that its numbers need no place in memory for those.
template <class T, class C, class DistanceAt>
[[gnu::noinline]] MaybeHit rounded(const C& concrete, T rounding, LocalRay ray, DistanceAt gap) {
  return hit_rounded(ray, gap, wide(rounding), wide(concrete.core_extent()), slack_of(concrete, rounding));
}

template <class T>
MaybeHit cast_at(const Sphere<T>& s, T rounding, const LocalRay& ray, BackFaces) {
  return hit_sphere(ray, converted<double>(s.center()), wide(s.radius()) + wide(rounding));
}

template <class T>
MaybeHit cast_at(const Capsule<T>& c, T rounding, const LocalRay& ray, BackFaces) {
  const double h = wide(c.half_height()), m = wide(rounding);
  return hit_balls(ray, {0, -h, 0}, wide(c.radius_bottom()) + m, {0, h, 0}, wide(c.radius_top()) + m);
}

template <class T>
MaybeHit cast_at(const LineSegment<T>& s, T rounding, const LocalRay& ray, BackFaces) {
  return hit_balls(ray, converted<double>(s.point(0)), wide(rounding), converted<double>(s.point(1)), wide(rounding));
}

template <class T>
MaybeHit cast_at(const Box<T>& box, T rounding, const LocalRay& ray, BackFaces) {
  const Vec3d half = converted<double>(box.half_extents());
  if (rounding > T(0)) return rounded(box, rounding, ray, DistanceToBox{half});
  return hit_box(ray, half);
}

template <class T>
MaybeHit cast_at(const Rectangle<T>& rectangle, T rounding, const LocalRay& ray, BackFaces back) {
  return cast_at(rectangle.as_box(), rounding, ray, back);
}

template <class T>
MaybeHit cast_at(const Cylinder<T>& c, T rounding, const LocalRay& ray, BackFaces) {
  const double h = wide(c.half_height()), bottom = wide(c.radius_bottom()), top = wide(c.radius_top());
  if (rounding > T(0)) return rounded(c, rounding, ray, DistanceToFrustum{{h, bottom, top}});
  return hit_cylinder(ray, Frustum(h, bottom, top));
}

template <class T>
MaybeHit cast_at(const Ellipsoid<T>& e, T rounding, const LocalRay& ray, BackFaces) {
  if (rounding > T(0)) return rounded(e, rounding, ray, DistanceBySupport<Ellipsoid<T>>{e});
  return hit_ellipsoid(ray, converted<double>(e.radii()));
}

template <class T>
MaybeHit cast_at(const Triangle<T>& t, T rounding, const LocalRay& ray, BackFaces back) {
  const Vec3d p[3] = {converted<double>(t.point(0)), converted<double>(t.point(1)), converted<double>(t.point(2))};
  if (rounding > T(0)) return rounded(t, rounding, ray, DistanceToTriangle{p[0], p[1], p[2]});
  return hit_polygon(
      ray, 3, [&](std::size_t i) { return p[i]; }, back == BackFaces::hit);
}

template <class T>
MaybeHit cast_at(const ConvexHull<T>& hull, T rounding, const LocalRay& ray, BackFaces) {
  if (rounding > T(0)) return rounded(hull, rounding, ray, DistanceBySupport<ConvexHull<T>>{hull});
  return hit_hull(ray, hull.data());
}

template <class T>
MaybeHit cast_at(const UserConvex<T>& user, T rounding, const LocalRay& ray, BackFaces) {
  return rounded(user, rounding, ray, DistanceBySupport<UserConvex<T>>{user});
}

template <class T>
MaybeHit cast_at(const HalfSpace<T>&, T rounding, const LocalRay& ray, BackFaces) {
  return hit_half_space(ray, wide(rounding));
}

/// Whether a kind is cast at without a test of its bounding ball, which would cost as much as the answer.
template <class C>
inline constexpr bool cast_at_once = false;
template <class T>
inline constexpr bool cast_at_once<Sphere<T>> = true;
template <class T>
inline constexpr bool cast_at_once<Box<T>> = true;
template <class T>
inline constexpr bool cast_at_once<HalfSpace<T>> = true;

/// The hit where the ray enters a convex shape of one kind or crosses a triangle, in the shape's own frame.
template <class C, class T>
MaybeHit hit_convex(const C& concrete, T rounding, const LocalRay& ray, BackFaces back) {
  if constexpr (!cast_at_once<C>)
    if (!near_ball(ray, ball_around(concrete, rounding))) return {};
  return cast_at(concrete, rounding, ray, back);
}

}  // namespace graze::rays
