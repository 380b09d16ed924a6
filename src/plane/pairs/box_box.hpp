// Boxes against boxes and segments: four separating axes, and the corners where two of these are nearest.
//
// Guarantee: the least overlap is exact, since the edges of the Minkowski difference of two boxes are parallel to those
// of the boxes. A segment is a box without a width.
#pragma once

#include "plane/pairs/box_point.hpp"
#include "plane/pairs/segment_point.hpp"

namespace graze::plane {

/// The kinds of shapes that `nearest_boxes` takes for B.
enum class SecondBox { box, segment };

/// The gaps of two boxes along their four axes, and the axis of the largest.
template <class S>
struct BoxAxes {
  using Mask = decltype(S(0) < S(0));
  Vec2<S> offset_b;  ///< from A's centre to B's, in B's frame
  S gap;             ///< the largest
  Mask of_b, along_x;

  [[gnu::always_inline]] BoxAxes(const Vec2<S>& half_a, const Vec2<S>& half_b, const Pose2<S>& b_in_a)
      : offset_b(inverse_rotate(b_in_a.rotation, b_in_a.translation)) {
    const S cosine = abs(b_in_a.rotation.cosine), sine = abs(b_in_a.rotation.sine);
    const Vec2<S> reach_a{cosine * half_a.x + sine * half_a.y, sine * half_a.x + cosine * half_a.y};
    const Vec2<S> reach_b{cosine * half_b.x + sine * half_b.y, sine * half_b.x + cosine * half_b.y};
    const Vec2<S> gap_a = abs(b_in_a.translation) - (half_a + reach_b), gap_b = abs(offset_b) - (half_b + reach_a);
    const S largest_a = greatest(gap_a.x, gap_a.y), largest_b = greatest(gap_b.x, gap_b.y);
    of_b = largest_b > largest_a;
    along_x = select(of_b, gap_b.x >= gap_b.y, gap_a.x >= gap_a.y);
    gap = select(of_b, largest_b, largest_a);
  }
};

/// The points that realise the gap along an axis: the corner of the incident box that lies deepest, and its foot on the
/// reference edge. In A's frame.
template <SecondBox second, class S>
[[gnu::always_inline]] inline LaneNearest<S> nearest_along_axis(const BoxAxes<S>& axes, const Vec2<S>& half_a,
                                                                const Vec2<S>& half_b, const Pose2<S>& b_in_a) {
  const S zero(0), one(1);
  const auto of_b = axes.of_b, along_x = axes.along_x;
  const Rot2<S> r = b_in_a.rotation;
  // In the frame of the reference box.
  const Vec2<S> half = select(of_b, half_b, half_a), incident = select(of_b, half_a, half_b);
  const Vec2<S> offset = select(of_b, -axes.offset_b, b_in_a.translation);
  const S sine = select(of_b, -r.sine, r.sine);
  const S s = sign_of(select(along_x, offset.x, offset.y));
  const Vec2<S> n{select(along_x, s, zero), select(along_x, zero, s)};
  const Rot2<S> turn{r.cosine, sine};
  const Vec2<S> inward = -inverse_rotate(turn, n);
  const Vec2<S> corner{sign_of(inward.x), sign_of(inward.y)};
  const Vec2<S> vertex = offset + rotate(turn, Vec2<S>{corner.x * incident.x, corner.y * incident.y});
  // The corner may lie beside the reference edge where the edges are in line with each other.
  const Vec2<S> foot{select(along_x, s * half.x, clamped(vertex.x, half.x)),
                     select(along_x, clamped(vertex.y, half.y), s * half.y)};
  const S reference_side = edge_number(select(along_x, one, zero), n);
  const S corner_feature = vertex_number(corner_number(corner));

  LaneNearest<S> out;
  out.distance = axes.gap;
  const Vec2<S> foot_a = select(of_b, transform(b_in_a, foot), foot), n_a = select(of_b, rotate(r, n), n);
  const Vec2<S> other = foot_a + n_a * axes.gap;
  out.normal = select(of_b, -n_a, n_a);
  out.a = select(of_b, other, foot_a);
  out.b = select(of_b, foot_a, other);
  if constexpr (second == SecondBox::segment) {
    const auto side_b = side_number(select(n.x > zero, zero, one));
    out.feature_a = select(of_b, corner_feature, side_number(reference_side));
    out.feature_b = select(of_b, side_b, vertex_number(select(corner.y > zero, one, zero)));
  } else {
    out.feature_a = select(of_b, corner_feature, side_number(reference_side));
    out.feature_b = select(of_b, side_number(reference_side), corner_feature);
  }
  return out;
}

/// The corner of one of two boxes that are apart which is nearest to the other.
template <class S>
struct NearestCorner {
  using Mask = decltype(S(0) < S(0));
  S squared = S(std::numeric_limits<double>::infinity());
  Vec2<S> vertex{}, corner{};  ///< in the other box's frame, and by its signs in its own
  Mask of_a{};

  [[gnu::always_inline]] void offer(const Vec2<S>& half, const Vec2<S>& center, const Vec2<S>& x, const Vec2<S>& y,
                                    const Vec2<S>& signs, const Mask& from_a) {
    const Vec2<S> at = center + x * signs.x + y * signs.y, over = abs(at) - half;
    const Vec2<S> out_by{greatest(over.x, S(0)), greatest(over.y, S(0))};
    const S square = length_squared(out_by);
    const auto better = square < squared;
    squared = select(better, square, squared);
    vertex = select(better, at, vertex);
    corner = select(better, signs, corner);
    of_a = select(better, from_a, of_a);
  }
};

template <SecondBox second, class S>
[[gnu::always_inline]] inline LaneNearest<S> nearest_by_corner(const Vec2<S>& offset_b, const Vec2<S>& half_a,
                                                               const Vec2<S>& half_b, const Pose2<S>& b_in_a) {
  const S zero(0), one(1), minus(-1);
  const Rot2<S> r = b_in_a.rotation;
  const auto yes = zero < one, no = one < zero;
  NearestCorner<S> best;
  const Vec2<S> x_b = Vec2<S>{r.cosine, r.sine} * half_b.x, y_b = Vec2<S>{-r.sine, r.cosine} * half_b.y;
  const Vec2<S> x_a = Vec2<S>{r.cosine, -r.sine} * half_a.x, y_a = Vec2<S>{r.sine, r.cosine} * half_a.y;
  for (const S& y : {minus, one}) {
    best.offer(half_a, b_in_a.translation, x_b, y_b, {one, y}, no);
    if constexpr (second == SecondBox::box) best.offer(half_a, b_in_a.translation, x_b, y_b, {minus, y}, no);
    best.offer(half_b, -offset_b, x_a, y_a, {minus, y}, yes);
    best.offer(half_b, -offset_b, x_a, y_a, {one, y}, yes);
  }
  const Vec2<S> half = select(best.of_a, half_b, half_a);
  const Vec2<S> foot{clamped(best.vertex.x, half.x), clamped(best.vertex.y, half.y)};
  const Vec2<S> between = best.vertex - foot, signs{sign_of(best.vertex.x), sign_of(best.vertex.y)};
  LaneNearest<S> out;
  out.distance = sqrt(best.squared);
  const S inverse_distance = one / select(best.squared > zero, out.distance, one);
  // From the box to the corner beside it.
  const Vec2<S> n = select(best.of_a, rotate(r, between * inverse_distance), between * inverse_distance);
  out.normal = select(best.of_a, -n, n);
  out.a = select(best.of_a, transform(b_in_a, best.vertex), foot);
  out.b = select(best.of_a, transform(b_in_a, foot), best.vertex);
  const auto past_x = between.x != zero, past_y = between.y != zero;
  const S own = vertex_number(corner_number(best.corner));
  const S other =
      select(past_x & past_y, vertex_number(corner_number(signs)), side_number(edge_number(between.x, signs)));
  if constexpr (second == SecondBox::segment) {
    const auto up = [&](const S& y) { return vertex_number(select(y > zero, one, zero)); };
    out.feature_a = select(best.of_a, own, other);
    out.feature_b = select(best.of_a, select(past_y, up(signs.y), side_number(select(signs.x > zero, zero, one))),
                           up(best.corner.y));
  } else {
    out.feature_a = select(best.of_a, own, other);
    out.feature_b = select(best.of_a, other, own);
  }
  return out;
}

/// The nearest points of two boxes about their origins; those of boxes further apart than `limit` need not be right
/// beyond that.
template <SecondBox second, class S>
[[gnu::always_inline]] inline LaneNearest<S> nearest_boxes(const Vec2<S>& half_a, const Vec2<S>& half_b,
                                                           const Pose2<S>& b_in_a, const S& limit) {
  const BoxAxes<S> axes(half_a, half_b, b_in_a);
  LaneNearest<S> out = nearest_along_axis<second>(axes, half_a, half_b, b_in_a);
  const auto apart = (axes.gap > S(0)) & (axes.gap <= limit);
  if (!any(apart)) return out;
  const LaneNearest<S> by_corner = nearest_by_corner<second>(axes.offset_b, half_a, half_b, b_in_a);
  // A corner that touches up to rounding has no direction of its own.
  const S noise = S(touching) * (max_abs(b_in_a.translation) + max_abs(half_a) + max_abs(half_b));
  const auto corner = apart & (by_corner.distance > noise);
  out.distance = select(corner, by_corner.distance, out.distance);
  out.normal = select(corner, by_corner.normal, out.normal);
  out.a = select(corner, by_corner.a, out.a);
  out.b = select(corner, by_corner.b, out.b);
  out.feature_a = select(corner, by_corner.feature_a, out.feature_a);
  out.feature_b = select(corner, by_corner.feature_b, out.feature_b);
  return out;
}

struct BoxBox {
  static constexpr LaneCore a = LaneCore::box, b = LaneCore::box;

  template <class S>
  [[gnu::always_inline]] static LaneNearest<S> nearest(const LanePair<S>& pair, const S& limit) {
    const Vec2<S> half_a{pair.a.size[0], pair.a.size[1]}, half_b{pair.b.size[0], pair.b.size[1]};
    return nearest_boxes<SecondBox::box>(half_a, half_b, pair.b_in_a, limit);
  }
};

struct BoxSegment {
  static constexpr LaneCore a = LaneCore::box, b = LaneCore::segment;

  template <class S>
  [[gnu::always_inline]] static LaneNearest<S> nearest(const LanePair<S>& pair, const S& limit) {
    const S zero(0), one(1);
    const LaneSegment<S> segment(pair.b);
    const auto extended = segment.squared > zero;
    const S length = sqrt(select(extended, segment.squared, one));
    const Vec2<S> up = select(extended, segment.half / length, Vec2<S>{zero, one});
    const Pose2<S> upright{segment.center, {up.y, -up.x}};
    const Vec2<S> half_a{pair.a.size[0], pair.a.size[1]}, half_b{zero, select(extended, length, zero)};
    return nearest_boxes<SecondBox::segment>(half_a, half_b, compose(pair.b_in_a, upright), limit);
  }
};

}  // namespace graze::plane
