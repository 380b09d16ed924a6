// Boxes against circles: the point of the box nearest to the centre.
#pragma once

#include "plane/pairs/lane_pair.hpp"

namespace graze::plane {

/// The corner of a box in the quadrant of `signs` (1 or -1 each): counter-clockwise from the lower left.
template <class S>
[[gnu::always_inline]] inline S corner_number(const Vec2<S>& signs) {
  const auto right = signs.x > S(0), up = signs.y > S(0);
  return select(up, select(right, S(2), S(3)), select(right, S(1), S(0)));
}
/// The edge of a box across which a direction along an axis points: below, right, above, left.
template <class S>
[[gnu::always_inline]] inline S edge_number(const S& along_x, const Vec2<S>& signs) {
  return select(along_x != S(0), select(signs.x > S(0), S(1), S(3)), select(signs.y > S(0), S(2), S(0)));
}

struct BoxPoint {
  static constexpr LaneCore a = LaneCore::box, b = LaneCore::point;

  template <class S>
  [[gnu::always_inline]] static LaneNearest<S> nearest(const LanePair<S>& pair, const S&) {
    const S zero(0), one(1);
    const Vec2<S> half{pair.a.size[0], pair.a.size[1]}, point = pair.b_in_a.translation;
    const Vec2<S> signs{sign_of(point.x), sign_of(point.y)}, over = abs(point) - half;
    const Vec2<S> out_by{greatest(over.x, zero), greatest(over.y, zero)};
    const S distance = sqrt(length_squared(out_by));
    const auto outside = distance > zero, past_x = over.x > zero, past_y = over.y > zero, x_axis = over.x > over.y;
    const S inverse_distance = one / select(outside, distance, one);
    const S axis_x = select(x_axis, one, zero), axis_y = one - axis_x;
    const Vec2<S> foot{select(past_x, half.x, abs(point.x)), select(past_y, half.y, abs(point.y))};
    LaneNearest<S> out;
    out.distance = select(outside, distance, greatest(over.x, over.y));
    out.normal = {signs.x * select(outside, out_by.x * inverse_distance, axis_x),
                  signs.y * select(outside, out_by.y * inverse_distance, axis_y)};
    out.a = {signs.x * select(outside, foot.x, select(x_axis, half.x, abs(point.x))),
             signs.y * select(outside, foot.y, select(x_axis, abs(point.y), half.y))};
    out.b = point;
    out.feature_a =
        select(past_x & past_y, vertex_number(corner_number(signs)), side_number(edge_number(axis_x, signs)));
    out.feature_b = vertex_number(zero);
    return out;
  }
};

}  // namespace graze::plane
