// The outline of the intersection of a rectangle and a parallelogram, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. No corner is lost to rounding; one may come twice, and
// `simplify` removes duplicates and corners that hardly stand out.
//
// Each of the eight sides, clipped by the other outline (Liang, Barsky 1984, "A new concept and method for line
// clipping"), is a side of the intersection or empty, and begins at a corner of it; and the sides of a convex area
// follow each other by their directions, which are the same four for any rectangle, with two of the parallelogram's in
// every half turn. So corners come out in order without a sort.
#pragma once

#include <utility>

#include "narrow/pairs/box_box/single_contact_polygon.hpp"

namespace graze::detail {

/// Two faces seen along a normal, in coordinates along the sides of the reference face, which is a rectangle. The two
/// half sides of the parallelogram are stored in four numbers, x and y of the first and of the second.
template <class S>
struct ClippedFaces {
  using Four = Packed<S, 4>;

  FlatPoint<S> half;      ///< half lengths of the rectangle, about the origin
  FlatPoint<S> center;    ///< middle of the parallelogram
  Four sides;             ///< u and v, the half sides of the parallelogram
  S turn;                 ///< their cross product
  Four to_uv;             ///< coordinates of an offset from the middle in units of u and of v, by scalar products with
                          ///< these
  S apart;                ///< distance of the faces at the middle
  FlatPoint<S> slope;     ///< gradient of that distance
  S slack;                ///< rounding of a position
  FlatPoint<S> slack_uv;  ///< rounding of a position in units of u and v

  /// The outline of the intersection.
  ContactPolygon<S> shared() const {
    // Directions of both sides in the upper half plane, u's angle the smaller: the parallelogram stays the same.
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
  /// Signs of opposite sides, which are clipped as one side and its mirror image: in the opposite direction an interval
  /// begins where it ends in the original one, at the negative of the mirrored middle.
  static Four signs() { return {S(1), S(1), S(-1), S(-1)}; }

  /// The middles of a parallelogram's sides, in turn around it: `at` plus the half sides' x (0) or y (1).
  template <int xy>
  static Four middles(const S& at, const Four& half_sides) {
    return Four(at) + mixed<2 + xy, 4 + xy, 6 + xy, xy>(-half_sides, half_sides);
  }

  /// The parameters, from -1 to 1 and back on the opposite sides, at which sides with those middles enter a region that
  /// reaches so far both ways; and whether they do. `vanishing`: least component of a direction that is divided by.
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

  // The slack may let a side pass and so double a corner; without it rounding might lose one.
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
