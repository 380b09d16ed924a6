// Segment against box: capsule against box.
#pragma once

#include "graze/geometry.hpp"
#include "narrow/core.hpp"

namespace graze {

/// A segment and a box that are apart: nearest are an end of the segment and any point of the box, or a point of the
/// segment and one of an edge of the box.
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

/// The axis along which a segment and a box are furthest apart or least deep: the box's three, and their products
/// with the segment. `edge` is the box axis of a product, or 3.
template <class S>
struct SegmentBoxAxis {
  S separation;
  Vec3<S> normal;  ///< from the box to the segment
  S edge;
};

template <class S>
SegmentBoxAxis<S> best_axis(const Vec3<S>& half, const Segment<S>& segment) {
  const Vec3<S> middle = (segment.a + segment.b) * S(0.5), reach = (segment.b - segment.a) * S(0.5);
  SegmentBoxAxis<S> best{S(-std::numeric_limits<float>::infinity()), {}, S(3)};
  const auto consider = [&](const Vec3<S>& n, const S& edge, const auto& valid) {
    const S along = dot(n, middle);
    const Vec3<S> toward = select(along < S(0), -n, n);
    using std::abs;
    const S separation = abs(along) - abs(dot(n, reach)) - dot(graze::abs(n), half);
    const auto better = valid & (separation > best.separation);
    best.separation = select(better, separation, best.separation);
    best.normal = select(better, toward, best.normal);
    best.edge = select(better, edge, best.edge);
  };
  const S one(1), zero(0);
  const Vec3<S> axes[3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
  for (const Vec3<S>& axis : axes) consider(axis, S(3), one > zero);
  const Vec3<S> u = normalized(reach, Vec3<S>{});
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<S> n = cross(axes[i], u);
    // Nearly parallel: the product's direction is rounding, and the face axes answer within it.
    const S sine = length(n);
    const auto distinct = sine > S(16) * epsilon<S>;
    consider(n / select(distinct, sine, one), S(static_cast<float>(i)), distinct);
  }
  return best;
}

/// Where an overlapping segment is deepest along `axis`, in parameters of the segment.
template <class S>
S deepest_parameter(const Vec3<S>& half, const Segment<S>& segment, const SegmentBoxAxis<S>& axis) {
  const Vec3<S> d = segment.b - segment.a;
  const S slope = dot(axis.normal, d), whole = length(d);
  using std::abs;
  // Along a face: the middle of what lies over it.
  S from(0), to(1);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto moving = abs(d[i]) > S(0);
    const auto across = moving & (abs(axis.normal[i]) < S(0.5));
    const S inverse = S(1) / select(moving, d[i], S(1));
    const S t0 = (-half[i] - segment.a[i]) * inverse, t1 = (half[i] - segment.a[i]) * inverse;
    from = select(across, greatest(from, least(t0, t1)), from);
    to = select(across, least(to, greatest(t0, t1)), to);
  }
  const S middle = clamp((from + to) * S(0.5), S(0), S(1));
  const auto flat = abs(slope) <= S(16) * epsilon<S> * whole;
  const S on_face = select(flat, middle, select(slope < S(0), S(1), S(0)));

  // Against an edge: the point nearest to the edge that faces the segment.
  const auto edge_axis = [&](std::size_t i) { return axis.edge == S(static_cast<float>(i)); };
  Vec3<S> from_corner{select(axis.normal.x < S(0), -half.x, half.x), select(axis.normal.y < S(0), -half.y, half.y),
                      select(axis.normal.z < S(0), -half.z, half.z)};
  Vec3<S> to_corner = from_corner;
  for (std::size_t i = 0; i < 3; ++i) {
    from_corner[i] = select(edge_axis(i), -half[i], from_corner[i]);
    to_corner[i] = select(edge_axis(i), half[i], to_corner[i]);
  }
  const S on_edge = closest_parameters(Segment<S>{from_corner, to_corner}, segment).t;
  return select(axis.edge < S(3), on_edge, on_face);
}

/// The box is A. Separating axes decide whether they overlap (van den Bergen 2003, section 3.2); apart, the nearest of
/// all pairs of features.
template <class S>
CoreDistance<S> core_distance(const BoxCore<S>& a, const SegmentCore<S>& b) {
  const SegmentBoxAxis<S> axis = best_axis(a.half, b.segment);
  const Vec3<S> deep = point_at(b.segment, deepest_parameter(a.half, b.segment, axis));
  const CoreDistance<S> inside{axis.separation, axis.normal, deep - axis.normal * axis.separation, deep};
  const CoreDistance<S> outside = apart(a.half, b.segment);
  // The axis keeps its digits where the difference of two near points has few, so it is the normal wherever both are
  // the same line up to rounding.
  const S noise = S(16) * epsilon<S> * (max_abs(a.half) + max_abs(b.segment.a) + max_abs(b.segment.b));
  const auto separate = (axis.separation > S(0)) & (outside.distance > noise);
  const auto along_axis = !separate | (length(outside.b - outside.a - axis.normal * outside.distance) <= noise);
  return {select(separate, outside.distance, inside.distance), select(along_axis, inside.normal, outside.normal),
          select(separate, outside.a, inside.a), select(separate, outside.b, inside.b)};
}

}  // namespace graze
