// The outline of the intersection of a rectangle and a triangle, across lanes; also with an edge or a vertex in the
// place of the triangle.
//
// Guarantee: in every lane the bits that the pair gives alone. No corner is lost to rounding; one may come twice, and
// `simplify` removes duplicates and corners that hardly stand out.
//
// Each of the seven sides, clipped by the other outline (Liang, Barsky 1984, "A new concept and method for line
// clipping"), is a side of the intersection or empty, and begins at a corner of it; and the sides of a convex area
// follow each other by their directions. The rectangle's directions are always the same four, and the first of the
// triangle's, by its angle, is within the first half turn and the last within the second: few slots remain for each.
#pragma once

#include "narrow/pairs/box_box/single_contact_polygon.hpp"

namespace graze::detail {

using graze::select;  // beside those for corners

/// A corner at the beginning of a side, if there is one.
template <class S>
struct Corner {
  FlatPoint<S> at;
  decltype(S() < S()) is;  ///< false: there is no corner
};
template <class M, class S>
Corner<S> select(const M& condition, const Corner<S>& yes, const Corner<S>& no) {
  Corner<S> corner{{select(condition, yes.at.x, no.at.x), select(condition, yes.at.y, no.at.y)}, no.is};
  corner.is = (condition & yes.is) | ((!condition) & no.is);
  return corner;
}

/// The contact polygon of the slots that hold a corner; `apart(position)` is the distance of the two faces there.
template <class S, class Apart>
ContactPolygon<S> ring_of(const Corner<S> (&slots)[most_contact_slots], const Apart& apart) {
  typename ContactPolygon<S>::All x, y, how_far;
  decltype(S() < S()) are[most_contact_slots];
  for (std::size_t i = 0; i < most_contact_slots; ++i) {
    x[i] = slots[i].at.x;
    y[i] = slots[i].at.y;
    how_far[i] = apart(slots[i].at);
    are[i] = slots[i].is;
  }
  return {x, y, how_far, are};
}

/// A vertex of the triangle projected along the normal.
template <class S>
struct FlatVertex {
  FlatPoint<S> at;
  S apart;   ///< distance beyond the rectangle's plane, along the normal
  S number;  ///< its number in the triangle
};
template <class M, class S>
FlatVertex<S> select(const M& condition, const FlatVertex<S>& yes, const FlatVertex<S>& no) {
  return {{select(condition, yes.at.x, no.at.x), select(condition, yes.at.y, no.at.y)},
          select(condition, yes.apart, no.apart),
          select(condition, yes.number, no.number)};
}

/// Rotates three vertices so that the second or the third comes first where its mask is set; at most one is.
template <class M, class S>
void begin_with(const M& second, const M& third, FlatVertex<S> (&v)[3]) {
  const FlatVertex<S> a = v[0], b = v[1], c = v[2];
  v[0] = select(second, b, select(third, c, a));
  v[1] = select(second, c, select(third, a, b));
  v[2] = select(second, a, select(third, b, c));
}

/// A side of the triangle as a line.
template <class S>
struct FlatSide {
  FlatPoint<S> from, along;
  S per_x, per_y;  ///< one over the components of `along`, or over a tiny number where these vanish
  S slack;         ///< rounding of `left_of`

  FlatSide() = default;
  FlatSide(const FlatPoint<S>& begin, const FlatPoint<S>& end, const S& rounding)
      : from(begin), along{end.x - begin.x, end.y - begin.y} {
    using std::abs;
    const S vanishing = rounding * S(epsilon<S>);
    const auto inverse = [&](const S& d) { return S(1) / select(abs(d) > vanishing, d, vanishing); };
    per_x = inverse(along.x);
    per_y = inverse(along.y);
    slack = rounding * (abs(along.x) + abs(along.y));
  }
  S length_squared() const { return along.x * along.x + along.y * along.y; }
  /// The signed distance of a point to the left of the line, times the length.
  S left_of(const FlatPoint<S>& p) const { return along.x * (p.y - from.y) - along.y * (p.x - from.x); }
};

/// An interval of a line, from `low` to `high`; empty where these are the other way round.
template <class S>
struct LineInterval {
  S low, high;
  auto is() const { return low <= high; }
  template <class M>
  void cut(const M& from, const S& at) {
    low = select(from, greatest(low, at), low);
    high = select(from, high, least(high, at));
  }
};

/// A rectangle about the origin and a triangle.
template <class S>
struct RectangleAndTriangle {
  using Mask = decltype(S() < S());

  FlatPoint<S> half;
  /// Counter-clockwise, the one of the smallest angle first; for an edge, the edge; for a vertex, one of zero length.
  const FlatSide<S> (&side)[3];
  Mask whole;  ///< the shape is a triangle
  Mask edge;   ///< the shape is an edge
  S rounding;  ///< rounding of a position

  /// Finds the corners. Ends of an edge within `most_merged` of each other, squared, are one.
  void corners(Corner<S> (&slots)[most_contact_slots], const S& most_merged) const {
    const Mask none = half.x < S(0);
    const LineInterval<S> on[] = {on_side(side[0]), on_side(side[1]), on_side(side[2])};
    const auto at = [&](std::size_t i, const S& t, const Mask& is) {
      return Corner<S>{{side[i].from.x + side[i].along.x * t, side[i].from.y + side[i].along.y * t}, is};
    };
    slots[0] = at(0, on[0].low, on[0].is());
    slots[1] = at(0, on[0].high, on[0].is() & edge);
    slots[1].is = slots[1].is & (distance_squared(slots[0].at, slots[1].at) > most_merged);
    for (std::size_t i = 2; i < most_contact_slots; ++i) slots[i] = {{S(0), S(0)}, none};
    if (!any(whole)) return;

    const Corner<S> a0 = slots[0], a1 = at(1, on[1].low, on[1].is()), a2 = at(2, on[2].low, on[2].is());
    const LineInterval<S> bottom = on_x(-half.y), top = on_x(half.y), right = on_y(half.x), left = on_y(-half.x);
    const Corner<S> r0{{bottom.low, -half.y}, bottom.is()}, r1{{half.x, right.low}, right.is()},
        r2{{top.high, half.y}, top.is()}, r3{{-half.x, left.high}, left.is()};
    // Order of the rectangle's sides among the triangle's.
    const FlatPoint<S>&d0 = side[0].along, &d1 = side[1].along, &d2 = side[2].along;
    const Mask first_half = !in_second_half(d1), a0_before_r1 = d0.x > S(0), a1_before_r1 = first_half & (d1.x > S(0)),
               a1_before_r3 = first_half | (d1.x < S(0)), a2_before_r3 = d2.x < S(0);
    const Corner<S> in_order[most_contact_slots - 1] = {
        r0,
        select(a0_before_r1, a0, r1),
        select(a1_before_r1, a1, select(a0_before_r1, r1, a0)),
        select(a1_before_r1, r1, select(first_half, a1, r2)),
        select(first_half, r2, select(a1_before_r3, a1, r3)),
        select(a1_before_r3, select(a2_before_r3, a2, r3), a1),
        select(a2_before_r3, r3, a2),
    };
    for (std::size_t i = 0; i + 1 < most_contact_slots; ++i) slots[i] = select(whole, in_order[i], slots[i]);
  }

 private:
  /// The interval of a triangle's side, in parameters from 0 to 1, within the rectangle.
  LineInterval<S> on_side(const FlatSide<S>& s) const {
    const FlatPoint<S> reach{half.x + rounding, half.y + rounding};
    const S x0 = (-reach.x - s.from.x) * s.per_x, x1 = (reach.x - s.from.x) * s.per_x,
            y0 = (-reach.y - s.from.y) * s.per_y, y1 = (reach.y - s.from.y) * s.per_y;
    return {greatest(S(0), greatest(least(x0, x1), least(y0, y1))),
            least(S(1), least(greatest(x0, x1), greatest(y0, y1)))};
  }
  /// The interval of a rectangle's side within the triangle: along x at the height `y`, or along y at `x`.
  LineInterval<S> on_x(const S& y) const {
    LineInterval<S> found{-half.x, half.x};
    for (const FlatSide<S>& s : side)
      found.cut(s.per_y < S(0), s.from.x + (s.along.x * (y - s.from.y) + s.slack) * s.per_y);
    return found;
  }
  LineInterval<S> on_y(const S& x) const {
    LineInterval<S> found{-half.y, half.y};
    for (const FlatSide<S>& s : side)
      found.cut(s.per_x > S(0), s.from.y + (s.along.y * (x - s.from.x) - s.slack) * s.per_x);
    return found;
  }
};

}  // namespace graze::detail
