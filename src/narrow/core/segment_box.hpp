// Segment against box: capsule against box.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core/core.hpp"

namespace graze {

/// A disjoint segment and box: nearest are an end of the segment and any point of the box, or a point of the segment
/// and one of an edge of the box.
template <class S>
CoreDistance<S> apart(const Vec3<S>& half, const Segment<S>& segment) {
  Vec3<S> best_a = closest_point_in_box(half, segment.a), best_b = segment.a;
  S least_squared = length_squared(best_b - best_a);
  const auto consider = [&](const Vec3<S>& a, const Vec3<S>& b) {
    const S squared = length_squared(b - a);
    const auto nearer = squared < least_squared;
    least_squared = select(nearer, squared, least_squared);
    best_a = select(nearer, a, best_a);
    best_b = select(nearer, b, best_b);
  };
  consider(closest_point_in_box(half, segment.b), segment.b);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int corner = 0; corner < 4; ++corner) {
      Vec3<S> from = half;
      from[(axis + 1) % 3] = corner & 1 ? half[(axis + 1) % 3] : -half[(axis + 1) % 3];
      from[(axis + 2) % 3] = corner & 2 ? half[(axis + 2) % 3] : -half[(axis + 2) % 3];
      Vec3<S> to = from;
      from[axis] = -half[axis];
      const Segment<S> edge{from, to};
      const auto [s, t] = closest_parameters(edge, segment);
      consider(point_at(edge, s), point_at(segment, t));
    }
  return {select(least_squared > S(0), length(best_b - best_a), S(0)), normalized(best_b - best_a), best_a, best_b};
}

/// The axis along which a segment and a box are furthest apart or overlap least.
template <class S>
struct SegmentBoxAxis {
  S separation;
  Vec3<S> normal;  ///< from the box to the segment
};

/// Calls `f(unit axis, whether it is one, axis number of the box, whether a product with the segment)` for the box's
/// three axes and their products with the segment.
template <class S, class F>
void visit_axes(const Vec3<S>& half, const Segment<S>& segment, F&& f) {
  const S one(1), zero(0);
  const Vec3<S> axes[3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
  for (std::size_t i = 0; i < 3; ++i) f(axes[i], half.x >= zero, i, false);
  const Vec3<S> u = normalized((segment.b - segment.a) * S(0.5), Vec3<S>{});
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<S> n = cross(axes[i], u);
    // The direction of a product of nearly parallel edges is mere rounding; the face axes answer within it.
    const S sine = length(n);
    const auto distinct = sine > S(16) * epsilon<S>;
    f(n / select(distinct, sine, one), distinct, i, true);
  }
}

template <class S>
SegmentBoxAxis<S> best_axis(const Vec3<S>& half, const Segment<S>& segment) {
  const Vec3<S> middle = (segment.a + segment.b) * S(0.5), reach = (segment.b - segment.a) * S(0.5);
  SegmentBoxAxis<S> best{S(-std::numeric_limits<float>::infinity()), {}};
  visit_axes(half, segment, [&](const Vec3<S>& n, const auto& valid, std::size_t, bool) {
    const S along = dot(n, middle);
    const Vec3<S> toward = select(along < S(0), -n, n);
    using std::abs;
    const S separation = abs(along) - abs(dot(n, reach)) - dot(graze::abs(n), half);
    const auto better = valid & (separation > best.separation);
    best.separation = select(better, separation, best.separation);
    best.normal = select(better, toward, best.normal);
  });
  return best;
}

/// The normal at a point of a box without its rounding error: no component along sides between whose ends the point is,
/// and none inward from a face.
template <class S>
Vec3<S> leaving(const Vec3<S>& normal, const BoxCore<S>& box, const Vec3<S>& at) {
  Vec3<S> left;
  for (std::size_t i = 0; i < 3; ++i)
    left[i] = select(at[i] >= box.half[i], greatest(normal[i], S(0)), S(0)) +
              select(at[i] <= -box.half[i], least(normal[i], S(0)), S(0));
  return left;
}

/// The distance of a segment from a box, which is A. Separating axes decide whether they overlap (van den Bergen 2003,
/// section 3.2). In an overlapping pair the segment is first moved out along the axis, just to touch: the nearest of
/// all pairs of features then are the deepest ones.
template <class S>
CoreDistance<S> core_distance(const BoxCore<S>& a, const SegmentCore<S>& b) {
  const SegmentBoxAxis<S> axis = best_axis(a.half, b.segment);
  const Vec3<S> out = axis.normal * -least(axis.separation, S(0));
  const CoreDistance<S> near = apart(a.half, Segment<S>{b.segment.a + out, b.segment.b + out});
  // The axis keeps its digits where the difference of two near points has few, so it is the normal wherever both are
  // the same line up to rounding.
  const S size = max_abs(a.half) + max_abs(b.segment.a) + max_abs(b.segment.b);
  const S noise = S(16) * epsilon<S> * size + b.error;
  const auto along_axis = (axis.separation <= S(0)) | (length(near.b - near.a - axis.normal * near.distance) <= noise);
  const S distance = select(axis.separation <= S(0), axis.separation, near.distance);
  // For two edges that cross the axis is the normal; for all other features one of the two corrections determines the
  // part of the normal that the other leaves.
  const Vec3<S> settled = -leaving(-leaving(near.normal, a, near.a), b.segment, near.b);
  const Vec3<S> normal = select(near.distance < size * S(near_part), renormalized(settled, near.normal), near.normal);
  return {distance, select(along_axis, axis.normal, normal), near.a, near.b - out};
}

/// Products of near-parallel edges have too few digits in float for the tolerance, and so have the nearest points.
template <>
inline constexpr bool evaluated_in_double<BoxCore<float>, SegmentCore<float>> = true;

}  // namespace graze
