// Circles against each other: their centres.
#pragma once

#include "plane/pairs/lane_pair.hpp"

namespace graze::plane {

struct PointPoint {
  static constexpr LaneCore a = LaneCore::point, b = LaneCore::point;

  template <class S>
  [[gnu::always_inline]] static LaneNearest<S> nearest(const LanePair<S>& pair, const S&) {
    const S zero(0), one(1);
    const Vec2<S> between = pair.b_in_a.translation;
    const S squared = length_squared(between), distance = sqrt(squared);
    const auto apart = squared > zero;
    const S inverse_distance = one / select(apart, distance, one);
    LaneNearest<S> out;
    out.distance = distance;
    out.normal = select(apart, between * inverse_distance, Vec2<S>{zero, one});
    out.a = {zero, zero};
    out.b = between;
    out.feature_a = out.feature_b = vertex_number(zero);
    return out;
  }
};

}  // namespace graze::plane
