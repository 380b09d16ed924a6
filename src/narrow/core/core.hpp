// The simplest cores, shapes without their rounding: points, segments and boxes. Closed forms are written for these,
// and so serve every shape that has such a core.
//
// Views of one convex shape; a routine takes the first one that gives it what it needs:
//
//   a closed form of a pair, alone or across lanes         Rounded<..Core, S>  core/core.hpp (`core_of`)
//   distance of a point from a cylinder or cone            FrustumCore         core/point_frustum.hpp
//   distance of tapered capsules                           BallHull            depth/ball_hulls.hpp
//   depth of bodies of revolution on one axis              RevolvedCore        depth/coaxial_depth.hpp
//   depth of sums of a box and an ellipsoid, by descent    SummedCore          core/minkowski.hpp
//     the same with first and second derivatives           SumSide             depth/core_sum.hpp
//   support points of cores with few corners, on lanes     ScannedShape        core/scanned_shape.hpp
//   support points of any convex shape (GJK, EPA)          ShapeCore           core/minkowski.hpp
//   faces and edges of few (separating axes), on lanes     FacetedShape        core/faceted_shape.hpp
//   faces, edges and vertices of any flat-sided shape      Polyhedron          sat/polyhedron.hpp
//   faces of any convex shape, and its rounded surface     Side                manifold/contact_side.hpp
//
// Rounded holds whichever scalar the routine computes in, ScannedShape and FacetedShape the shape's own; the others are
// in double. A view that holds no numbers of its own refers to the shape, which must outlive it.
#pragma once

#include <type_traits>

#include "graze/lines.hpp"
#include "graze/shape.hpp"
#include "graze/wide.hpp"
#include "simd/lane_of.hpp"

namespace graze {

template <class S>
struct PointCore {
  Vec3<S> point;
};
template <class S>
struct SegmentCore {
  Segment<S> segment;
  S error = S(0);  ///< distance by which rounding may have displaced its ends
};
/// A segment along Y about the origin.
template <class S>
struct AxisCore {
  S half_height;
};
template <class S>
struct BoxCore {
  Vec3<S> half;
};
/// The core of a triangle, which has routines of its own.
template <class S>
struct TriangleCore {
  Vec3<S> point[3];
};
/// The half-space y <= 0, which is determined by its pose alone.
struct PlaneCore {};
/// An `AxisCore` under a pose.
template <class S>
struct TurnedAxis {
  Vec3<S> middle, axis;  ///< `axis`: of unit length
  S half;

  Vec3<S> at(const S& along) const { return middle + axis * along; }
  /// The position on the segment nearest to a point at `along` on the line through it.
  S within(const S& along) const { return clamp(along, -half, half); }
};
/// Whether a point is the origin in all lanes.
template <class S>
bool is_origin(const Vec3<S>& point) {
  return all((point.x == S(0)) & (point.y == S(0)) & (point.z == S(0)));
}
/// Any other core, which is left to the general path.
struct NoCore {};

template <class S, class T>
PointCore<S> converted(const PointCore<T>& core) {
  return {converted<S>(core.point)};
}
template <class S, class T>
SegmentCore<S> converted(const SegmentCore<T>& core) {
  return {{converted<S>(core.segment.a), converted<S>(core.segment.b)}, static_cast<S>(core.error)};
}
template <class S, class T>
BoxCore<S> converted(const BoxCore<T>& core) {
  return {converted<S>(core.half)};
}

template <class T>
PointCore<T> core_of(const Sphere<T>& sphere) {
  return {sphere.center()};
}
/// The core of an untapered capsule; `has_core` is false for others.
template <class T>
SegmentCore<T> core_of(const Capsule<T>& capsule) {
  return {{{T(0), -capsule.half_height(), T(0)}, {T(0), capsule.half_height(), T(0)}}};
}
template <class T>
SegmentCore<T> core_of(const LineSegment<T>& segment) {
  return {{segment.point(0), segment.point(1)}};
}
template <class T>
BoxCore<T> core_of(const Box<T>& box) {
  return {box.half_extents()};
}
template <class T>
BoxCore<T> core_of(const Rectangle<T>& rectangle) {
  return {rectangle.as_box().half_extents()};
}
template <class C>
NoCore core_of(const C&) {
  return {};
}

/// Whether this object has the core that its type promises.
template <class C>
bool has_core(const C& concrete) {
  if constexpr (requires { concrete.tapered(); })
    return !concrete.tapered();
  else
    return !std::is_same_v<decltype(core_of(concrete)), NoCore>;
}

/// Whether a capsule is untapered and has a length, as closed forms for its side require.
template <class T>
bool has_untapered_side(const Capsule<T>& capsule) {
  const bool even = !capsule.tapered(), long_enough = capsule.half_height() > T(0);
  return even & long_enough;  // not &&: over many capsules each branch would be mispredicted
}

/// The machine epsilon of a scalar, or of a lane's scalar.
template <class S>
inline constexpr typename LaneOf<S>::type epsilon = std::numeric_limits<typename LaneOf<S>::type>::epsilon();

/// A core with its rounding radius.
template <class Core, class S>
struct Rounded {
  Core core;
  S radius;
};

/// The signed distance of two cores, in the frame of A: b - a = distance * normal, the normal unit, from A to B.
template <class S>
struct CoreDistance {
  S distance;
  Vec3<S> normal, a, b;
};

/// The nearest points of two cores; for cores that overlap, one common point.
template <class S>
struct CorePoints {
  Vec3<S> a, b;
};

template <class T, class S>
CoreDistance<T> converted(const CoreDistance<S>& d) {
  return {static_cast<T>(d.distance), converted<T>(d.normal), converted<T>(d.a), converted<T>(d.b)};
}
template <class S>
CoreDistance<S> mirrored(const CoreDistance<S>& d) {
  return {d.distance, -d.normal, d.b, d.a};
}

template <class M, class S>
CoreDistance<S> select(const M& condition, const CoreDistance<S>& yes, const CoreDistance<S>& no) {
  return {select(condition, yes.distance, no.distance), select(condition, yes.normal, no.normal),
          select(condition, yes.a, no.a), select(condition, yes.b, no.b)};
}

/// Whether the closed form of two cores has to be evaluated in double to meet float's tolerance.
template <class A, class B>
inline constexpr bool evaluated_in_double = false;

/// `v` scaled to unit length by one division; zero stays zero. Where its square would under- or overflow it is first
/// multiplied by a power of two, which changes none of its digits.
template <class S>
Vec3<S> direction_of(const Vec3<S>& v, const S& length_of_v) {
  using T = typename LaneOf<S>::type;
  constexpr bool single = sizeof(T) == 4;
  // Between these lengths both the square and the square of the length's last digit are normal numbers.
  constexpr T least_safe = single ? T(1e-12) : T(1e-138), most_safe = single ? T(1e19) : T(1e154);
  constexpr T up = single ? T(0x1p100) : T(0x1p800), down = single ? T(0x1p-100) : T(0x1p-800);
  const auto small = length_of_v<S(least_safe), large = length_of_v> S(most_safe);
  if (!any(small | large)) return v * (S(1) / length_of_v);
  const Vec3<S> w = v * select(small, S(up), select(large, S(down), S(1)));
  const S l = length(w);
  return w * (S(1) / select(l > S(0), l, S(1)));
}

/// The distance of two disjoint cores from their nearest points: along the line between them, or along the unit vector
/// `known` where that is the same line up to `noise`, the error of `b - a`: `known` has all its digits.
template <class S>
CoreDistance<S> between(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& known, const S& noise) {
  const Vec3<S> v = b - a;
  const S along = dot(v, known), d = length(v);
  const auto is_known = length_squared(v - known * along) <= noise * noise;
  if (!any(is_known)) return {d, direction_of(v, d), a, b};
  const Vec3<S> toward = select(along < S(0), -known, known);
  if (all(is_known)) return {d, toward, a, b};
  return {d, select(is_known, toward, direction_of(v, d)), a, b};
}

/// Distance of two cores, relative to their coordinates, below which the difference of their nearest points has lost
/// digits that matter for the gap along the normal.
inline constexpr double near_part = 1.0 / 64;

/// The normal of two cores, one of them a segment with the nearest point `at`, without its rounding error along the
/// segment: no component along it within it, and at an end none towards points further out along the normal.
template <class S>
Vec3<S> leaving(const Vec3<S>& normal, const Segment<S>& segment, const Vec3<S>& at) {
  const auto is = [](const Vec3<S>& p, const Vec3<S>& q) { return (p.x == q.x) & (p.y == q.y) & (p.z == q.z); };
  const Vec3<S> d = segment.b - segment.a;
  const S whole = dot(d, d), part = dot(normal, d) / select(whole > S(0), whole, S(1));
  const auto at_a = is(at, segment.a), at_b = is(at, segment.b);
  return normal - d * select(at_b, least(part, S(0)), select(at_a, greatest(part, S(0)), part));
}

/// The unit vector of a corrected normal `left`, or `normal` itself where little is left.
template <class S>
Vec3<S> renormalized(const Vec3<S>& left, const Vec3<S>& normal) {
  const S l = length(left);
  const auto some = l > S(0.5);
  return select(some, left / select(some, l, S(1)), normal);
}

}  // namespace graze
