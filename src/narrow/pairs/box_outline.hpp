// A rectangle and a parallelogram laid over each other: the outline of what they share, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. No corner is lost to rounding; one may come twice, and
// `drop_idle_corners` takes those and the ones out that stand out too little to mean anything, as `simplify` does.
//
// Each of the eight sides, clipped by the other outline (Liang, Barsky 1984, "A new concept and method for line
// clipping"), is a side of the shared area or none, and begins at a corner of it; and sides of a convex area follow
// each other by their directions, which are the same four for any rectangle, with two of the parallelogram's in every
// half turn. So corners come out in order without a sort.
#pragma once

#include <utility>

#include "narrow/pairs/single_ring.hpp"

namespace graze {

namespace detail {

/// Four sides, clipped by a region that is a box in some coordinates.
template <class S>
struct Sides {
  using Four = Several<S, 4>;
  /// In those coordinates, one over what a side rises along either.
  Four inverse_x, inverse_y;

  /// Where along sides with those middles a region begins that reaches so far both ways, from -1 to 1; whether it does
  /// at all.
  std::pair<Four, typename Four::Mask> begin(const Four& x, const Four& y, const FlatPoint<S>& reach) const {
    const Four along_x = x * inverse_x, along_y = y * inverse_y;
    const Four half_x = Four(reach.x) * abs(inverse_x), half_y = Four(reach.y) * abs(inverse_y);
    const Four low = greatest(Four(S(-1)), greatest(-along_x - half_x, -along_y - half_y)),
               high = least(Four(S(1)), least(half_x - along_x, half_y - along_y));
    return {low, low <= high};
  }
};

/// Two faces seen along a normal, in coordinates along the sides of the one that is a rectangle then.
template <class S>
struct LaidOver {
  using Mask = decltype(S() < S());

  FlatPoint<S> half;          ///< of the rectangle, about the origin
  FlatPoint<S> center, u, v;  ///< the parallelogram: its middle and half of its sides
  FlatPoint<S> to_u, to_v;    ///< a place relative to the middle in units of u and of v: by scalar products with these
  S apart;                    ///< how far the faces are apart at the middle
  FlatPoint<S> slope;         ///< and how that changes
  S slack;                    ///< rounding of a place
  FlatPoint<S> slack_uv;      ///< the same in units of u and v

  FlatPoint<S> in_uv(const FlatPoint<S>& p) const {
    const S x = p.x - center.x, y = p.y - center.y;
    return {x * to_u.x + y * to_u.y, x * to_v.x + y * to_v.y};
  }
  /// The outline of the shared area.
  Ring<S> shared() const {
    // Both sides' directions in the upper half plane, u's angle the smaller: the parallelogram stays the same.
    const auto flip = [](const Mask& m, const FlatPoint<S>& d) {
      return FlatPoint<S>{select(m, -d.x, d.x), select(m, -d.y, d.y)};
    };
    const Mask mirrored = u.x * v.y - u.y * v.x < S(0), turn = in_second_half(u);
    const FlatPoint<S> first = flip(turn, u), second = flip((mirrored & (!turn)) | ((!mirrored) & turn), v);
    const Mask crossed = in_second_half(second);
    const FlatPoint<S> p{select(crossed, -second.x, first.x), select(crossed, -second.y, first.y)},
        q{select(crossed, first.x, second.x), select(crossed, first.y, second.y)};
    return Ring<S>(of_rectangle(), of_parallelogram(p, q), p.x > S(0), q.x > S(0));
  }

 private:
  using Four = Several<S, 4>;

  /// Opposite sides are clipped as one and as its mirror image: against its direction a region begins where it ends
  /// along it, at the negative of the mirrored middle.
  static Four signs() { return {S(1), S(1), S(-1), S(-1)}; }

  /// Sides along two directions, in turn.
  static Sides<S> sides(const FlatPoint<S>& along, const FlatPoint<S>& then, const FlatPoint<S>& vanishing) {
    const Four rise{along.x, along.y, then.x, then.y}, least_rise{vanishing.x, vanishing.y, vanishing.x, vanishing.y},
        inverse = Four(S(1)) / select(abs(rise) > least_rise, rise, least_rise);
    return {{inverse[0], inverse[2], inverse[0], inverse[2]}, {inverse[1], inverse[3], inverse[1], inverse[3]}};
  }

  // A side that the slack alone lets pass doubles a corner; without it rounding might lose one.
  Corners<S> of_parallelogram(const FlatPoint<S>& p, const FlatPoint<S>& q) const {
    const FlatPoint<S> reach{half.x + slack, half.y + slack}, vanishing{slack * S(epsilon<S>), slack * S(epsilon<S>)};
    const Four x = Four(center.x) + Four{-q.x, p.x, q.x, -p.x}, y = Four(center.y) + Four{-q.y, p.y, q.y, -p.y};
    const auto [begin, is] = sides(p, q, vanishing).begin(x * signs(), y * signs(), reach);
    const Four t = begin * signs();
    return with_gaps(x + Four{p.x, q.x, p.x, q.x} * t, y + Four{p.y, q.y, p.y, q.y} * t, is);
  }
  Corners<S> of_rectangle() const {
    const FlatPoint<S> reach{S(1) + slack_uv.x, S(1) + slack_uv.y},
        vanishing{slack_uv.x * S(epsilon<S>), slack_uv.y * S(epsilon<S>)};
    const FlatPoint<S> x_uv{half.x * to_u.x, half.x * to_v.x}, y_uv{half.y * to_u.y, half.y * to_v.y},
        middle = in_uv({S(0), S(0)});
    const Four x = Four(middle.x) + Four{-y_uv.x, x_uv.x, y_uv.x, -x_uv.x},
               y = Four(middle.y) + Four{-y_uv.y, x_uv.y, y_uv.y, -x_uv.y};
    const auto [begin, is] = sides(x_uv, y_uv, vanishing).begin(x * signs(), y * signs(), reach);
    const Four t = begin * signs();
    return with_gaps(Four(half.x) * Four{t[0], S(1), t[2], S(-1)}, Four(half.y) * Four{S(-1), t[1], S(1), t[3]}, is);
  }
  Corners<S> with_gaps(const Four& x, const Four& y, const typename Four::Mask& are) const {
    return {x, y, Four(apart) + (x - Four(center.x)) * Four(slope.x) + (y - Four(center.y)) * Four(slope.y), are};
  }
};

}  // namespace detail

}  // namespace graze
