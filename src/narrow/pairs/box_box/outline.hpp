// A rectangle and a parallelogram laid over each other: the outline of what they share, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. No corner is lost to rounding; one may come twice, and
// `simplify` takes those and the ones out that stand out too little to mean anything, as `simplify` does.
//
// Each of the eight sides, clipped by the other outline (Liang, Barsky 1984, "A new concept and method for line
// clipping"), is a side of the shared area or none, and begins at a corner of it; and sides of a convex area follow
// each other by their directions, which are the same four for any rectangle, with two of the parallelogram's in every
// half turn. So corners come out in order without a sort.
#pragma once

#include <utility>

#include "narrow/pairs/box_box/single_contact_polygon.hpp"

namespace graze::detail {

/// Two faces seen along a normal, in coordinates along the sides of the one that is a rectangle then. Both sides of a
/// parallelogram are four numbers, the one's x and y and the other's.
template <class S>
struct ClippedFaces {
  using Four = Packed<S, 4>;

  FlatPoint<S> half;      ///< of the rectangle, about the origin
  FlatPoint<S> center;    ///< the parallelogram's middle
  Four sides;             ///< u and v, half of its sides
  S turn;                 ///< their cross product
  Four to_uv;             ///< a place relative to the middle in units of u, and of v: by scalar products with these
  S apart;                ///< how far the faces are apart at the middle
  FlatPoint<S> slope;     ///< and how that changes
  S slack;                ///< rounding of a place
  FlatPoint<S> slack_uv;  ///< the same in units of u and v

  /// The outline of the shared area.
  ContactPolygon<S> shared() const {
    // Both sides' directions in the upper half plane, u's angle the smaller: the parallelogram stays the same.
    const Four zero(S(0));
    const auto lower = [&](const Four& x, const Four& y) { return (y < zero) | ((y == zero) & (x < zero)); };
    const auto mirrored = Four(turn) < zero, turned = lower(permuted<0, 0, 0, 0>(sides), permuted<1, 1, 1, 1>(sides));
    const auto other_turned = (mirrored & (!turned)) | ((!mirrored) & turned);
    const Four up = mixed<0, 1, 6, 7>(select(turned, -sides, sides), select(other_turned, -sides, sides));
    const auto crossed = lower(permuted<2, 2, 2, 2>(up), permuted<3, 3, 3, 3>(up));
    const Four pq = select(crossed, mixed<2, 3, 4, 5>(-up, up), up);
    return ContactPolygon<S>(of_rectangle(), of_parallelogram(pq), pq[0] > S(0), pq[2] > S(0));
  }

 private:
  /// Opposite sides are clipped as one and as its mirror image: against its direction a region begins where it ends
  /// along it, at the negative of the mirrored middle.
  static Four signs() { return {S(1), S(1), S(-1), S(-1)}; }

  /// The middles of a parallelogram's sides, in turn: about `at`, from the half sides' x (0) or y (1).
  template <int xy>
  static Four middles(const S& at, const Four& half_sides) {
    return Four(at) + mixed<2 + xy, 4 + xy, 6 + xy, xy>(-half_sides, half_sides);
  }

  /// Where along sides with those middles a region begins that reaches so far both ways, from -1 to 1 and back on the
  /// opposite ones; whether it does at all. `vanishing`: what a direction may rise by and be across.
  static std::pair<Four, typename Four::Mask> begin(const Four& half_sides, const Four& middle_x, const Four& middle_y,
                                                    const FlatPoint<S>& reach, const FlatPoint<S>& vanishing) {
    const Four least_rise{vanishing.x, vanishing.y, vanishing.x, vanishing.y},
        inverse = Four(S(1)) / select(abs(half_sides) > least_rise, half_sides, least_rise),
        inverse_x = permuted<0, 2, 0, 2>(inverse), inverse_y = permuted<1, 3, 1, 3>(inverse);
    const Four along_x = middle_x * signs() * inverse_x, along_y = middle_y * signs() * inverse_y;
    const Four half_x = Four(reach.x) * abs(inverse_x), half_y = Four(reach.y) * abs(inverse_y);
    const Four low = greatest(Four(S(-1)), greatest(-along_x - half_x, -along_y - half_y)),
               high = least(Four(S(1)), least(half_x - along_x, half_y - along_y));
    return {low * signs(), low <= high};
  }

  // A side that the slack alone lets pass doubles a corner; without it rounding might lose one.
  Corners<S> of_parallelogram(const Four& pq) const {
    const FlatPoint<S> reach{half.x + slack, half.y + slack}, vanishing{slack * S(epsilon<S>), slack * S(epsilon<S>)};
    const Four x = middles<0>(center.x, pq), y = middles<1>(center.y, pq);
    const auto [t, is] = begin(pq, x, y, reach, vanishing);
    return with_gaps(x + permuted<0, 2, 0, 2>(pq) * t, y + permuted<1, 3, 1, 3>(pq) * t, is);
  }
  Corners<S> of_rectangle() const {
    const FlatPoint<S> reach{S(1) + slack_uv.x, S(1) + slack_uv.y},
        vanishing{slack_uv.x * S(epsilon<S>), slack_uv.y * S(epsilon<S>)};
    const Four by_x = permuted<0, 2, 1, 3>(to_uv), half_sides = Four{half.x, half.x, half.y, half.y} * by_x,
               middle = Four(S(0) - center.x) * by_x + Four(S(0) - center.y) * permuted<1, 3, 0, 2>(to_uv);
    const Four x = middles<0>(middle[0], half_sides), y = middles<1>(middle[1], half_sides);
    const auto [t, is] = begin(half_sides, x, y, reach, vanishing);
    const Four ends{S(-1), S(1), S(1), S(-1)};
    return with_gaps(Four(half.x) * mixed<0, 5, 2, 7>(t, ends), Four(half.y) * mixed<4, 1, 6, 3>(t, ends), is);
  }
  Corners<S> with_gaps(const Four& x, const Four& y, const typename Four::Mask& are) const {
    return {x, y, Four(apart) + (x - Four(center.x)) * Four(slope.x) + (y - Four(center.y)) * Four(slope.y), are};
  }
};

}  // namespace graze::detail
