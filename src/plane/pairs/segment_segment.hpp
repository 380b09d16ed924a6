// Capsules and segments against each other: an end of one is nearest to the other, or they cross.
//
// Guarantee: segments that cross are as deep as the shortest translation that separates them is long, which is along
// the normal of one of them.
#pragma once

#include "plane/pairs/segment_point.hpp"

namespace graze::plane {

struct SegmentSegment {
  static constexpr LaneCore a = LaneCore::segment, b = LaneCore::segment;

  template <class S>
  [[gnu::always_inline]] static LaneNearest<S> nearest(const LanePair<S>& pair, const S&) {
    const S zero(0), one(1), minus(-1);
    const LaneSegment<S> of_a(pair.a), of_b(LaneSegment<S>(pair.b), pair.b_in_a);
    // Each end and the point of the other segment nearest to it; their places as multiples of the halves.
    S at_a = minus, at_b = of_b.parameter(of_a.at(minus)), best = square_at(of_a, of_b, at_a, at_b);
    const auto offer = [&](const S& t, const S& u) {
      const S squared = square_at(of_a, of_b, t, u);
      const auto better = squared < best;
      best = select(better, squared, best);
      at_a = select(better, t, at_a);
      at_b = select(better, u, at_b);
    };
    offer(one, of_b.parameter(of_a.at(one)));
    offer(of_a.parameter(of_b.at(minus)), minus);
    offer(of_a.parameter(of_b.at(one)), one);

    LaneNearest<S> out;
    out.a = of_a.at(at_a);
    out.b = of_b.at(at_b);
    const Vec2<S> between = out.b - out.a;
    out.distance = sqrt(best);
    out.feature_a = of_a.feature(at_a, cross(of_a.half, between));
    out.feature_b = of_b.feature(at_b, -cross(of_b.half, between));

    const Vec2<S> offset = of_b.center - of_a.center;
    const S turn = abs(cross(of_a.half, of_b.half)), off_a = cross(of_a.half, offset), off_b = cross(of_b.half, offset);
    const S noise = S(touching) * (max_abs(offset) + max_abs(of_a.half) + max_abs(of_b.half) + max_abs(of_a.center));
    const auto crossing = (turn > zero) & (abs(off_a) <= turn) & (abs(off_b) <= turn);
    const auto on_axis = crossing | (out.distance <= noise);
    out.normal = between / select(on_axis, one, out.distance);
    if (any(on_axis)) take_axis(of_a, of_b, on_axis, crossing, turn, off_a, off_b, out);
    return out;
  }

 private:
  template <class S>
  [[gnu::always_inline]] static S square_at(const LaneSegment<S>& of_a, const LaneSegment<S>& of_b, const S& t,
                                            const S& u) {
    return length_squared(of_b.at(u) - of_a.at(t));
  }
  /// Fills the answer of segments that cross or touch: along the normal of the one that gives the larger gap.
  template <class M, class S>
  [[gnu::always_inline]] static void take_axis(const LaneSegment<S>& of_a, const LaneSegment<S>& of_b, const M& on_axis,
                                               const M& crossing, const S& turn, const S& off_a, const S& off_b,
                                               LaneNearest<S>& out) {
    const S zero(0), one(1), none(-std::numeric_limits<double>::infinity());
    const auto long_a = of_a.squared > zero, long_b = of_b.squared > zero;
    const S length_a = sqrt(select(long_a, of_a.squared, one)), length_b = sqrt(select(long_b, of_b.squared, one));
    const S gap_a = select(long_a, (abs(off_a) - turn) / length_a, none),
            gap_b = select(long_b, (abs(off_b) - turn) / length_b, none);
    const auto by_b = gap_b > gap_a, by_none = (!long_a) & (!long_b);
    const Vec2<S> normal_a = left(of_a.half) * (sign_of(off_a) / length_a),
                  normal_b = left(of_b.half) * (sign_of(off_b) / length_b);
    const Vec2<S> n = select(by_none, Vec2<S>{zero, one}, select(by_b, normal_b, normal_a));
    const S gap = select(crossing, select(by_b, gap_b, gap_a), out.distance);
    // The end of the other segment that lies deepest, and its foot on the axis's segment.
    const S deep_a = sign_of(dot(of_a.half, n)), deep_b = -sign_of(dot(of_b.half, n));
    const Vec2<S> end_a = of_a.at(deep_a), end_b = of_b.at(deep_b);
    const auto moved = on_axis & crossing;
    out.a = select(moved, select(by_b, end_a, end_b - n * gap), out.a);
    out.b = select(moved, select(by_b, end_a + n * gap, end_b), out.b);
    const auto up = [&](const S& t) { return vertex_number(select(t > zero, one, zero)); };
    out.feature_a = select(moved, select(by_b, up(deep_a), of_a.feature(zero, dot(left(of_a.half), n))), out.feature_a);
    out.feature_b =
        select(moved, select(by_b, of_b.feature(zero, -dot(left(of_b.half), n)), up(deep_b)), out.feature_b);
    out.normal = select(on_axis, n, out.normal);
    out.distance = select(on_axis, gap, out.distance);
  }
};

}  // namespace graze::plane
