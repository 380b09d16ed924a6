// Capsules and segments against circles: the point of the segment nearest to the centre.
#pragma once

#include "plane/pairs/lane_pair.hpp"

namespace graze::plane {

/// A segment in a frame: its middle, half of it, and the point nearest to another.
template <class S>
struct LaneSegment {
  Vec2<S> center, half;
  S squared;  ///< length of the half

  [[gnu::always_inline]] LaneSegment(const LaneShape<S>& shape)
      : center{(shape.size[0] + shape.size[2]) * S(0.5), (shape.size[1] + shape.size[3]) * S(0.5)},
        half{(shape.size[2] - shape.size[0]) * S(0.5), (shape.size[3] - shape.size[1]) * S(0.5)},
        squared(length_squared(half)) {}
  [[gnu::always_inline]] LaneSegment(const LaneSegment& own, const Pose2<S>& pose)
      : center(transform(pose, own.center)), half(rotate(pose.rotation, own.half)), squared(own.squared) {}

  /// The parameter of the point of the segment nearest to another, from -1 to 1; 0 if the segment is a point.
  [[gnu::always_inline]] S parameter(const Vec2<S>& point) const {
    const auto extended = squared > S(0);
    return select(extended, clamped(dot(point - center, half) / select(extended, squared, S(1)), S(1)), S(0));
  }
  Vec2<S> at(const S& t) const { return center + half * t; }
  /// The vertex at an end, else the side on which a point lies that is `across` the half to the left.
  [[gnu::always_inline]] S feature(const S& t, const S& across) const {
    const auto end = abs(t) >= S(1);
    return select(end, vertex_number(select(t > S(0), S(1), S(0))), side_number(select(across > S(0), S(1), S(0))));
  }
};

struct SegmentPoint {
  static constexpr LaneCore a = LaneCore::segment, b = LaneCore::point;

  template <class S>
  [[gnu::always_inline]] static LaneNearest<S> nearest(const LanePair<S>& pair, const S&) {
    const S zero(0), one(1);
    const LaneSegment<S> segment(pair.a);
    const Vec2<S> point = pair.b_in_a.translation;
    const S t = segment.parameter(point);
    LaneNearest<S> out;
    out.a = segment.at(t);
    out.b = point;
    const Vec2<S> between = point - out.a;
    out.distance = length(between);
    const auto apart = out.distance > S(touching) * (max_abs(segment.center) + max_abs(segment.half));
    const S inverse_distance = one / select(apart, out.distance, one);
    out.normal = between * inverse_distance;
    if (!all(apart)) {
      // A centre on the segment has the normal to the side where rounding leaves it.
      const auto extended = segment.squared > zero;
      const Vec2<S> across = left(segment.half) / sqrt(select(extended, segment.squared, one));
      const S height = dot(across, between);
      const Vec2<S> upward = select(extended, across * sign_of(height), Vec2<S>{zero, one});
      out.normal = select(apart, out.normal, upward);
      out.distance = select(apart, out.distance, select(extended, abs(height), out.distance));
    }
    out.feature_a = segment.feature(t, cross(segment.half, between));
    out.feature_b = vertex_number(zero);
    return out;
  }
};

}  // namespace graze::plane
