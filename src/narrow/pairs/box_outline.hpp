// A rectangle and a parallelogram laid over each other: the outline of what they share, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. No corner is lost to rounding; one may come twice, and
// `drop_idle_corners` takes those and the ones out that stand out too little to mean anything, as `simplify` does.
//
// Each of the eight sides, clipped by the other outline (Liang, Barsky 1984, "A new concept and method for line
// clipping"), is a side of the shared area or none, and begins at a corner of it; and sides of a convex area follow each
// other by their directions, which are the same four for any rectangle, with two of the parallelogram's in every half
// turn. So corners come out in order without a sort.
#pragma once

#include <utility>

#include "narrow/core.hpp"
#include "narrow/outline.hpp"

namespace graze {

/// As many corners as a rectangle and a parallelogram laid over each other can have.
inline constexpr std::size_t most_box_points = 8;

namespace detail {

using graze::select;  // beside the one for corners

/// A corner where a side begins, while it is one.
template <class S>
struct Corner {
  FlatPoint<S> at;
  decltype(S() < S()) is;  ///< false: there is none
};
template <class M, class S>
Corner<S> select(const M& condition, const Corner<S>& yes, const Corner<S>& no) {
  Corner<S> corner{{select(condition, yes.at.x, no.at.x), select(condition, yes.at.y, no.at.y)}, no.is};
  corner.is = (condition & yes.is) | ((!condition) & no.is);
  return corner;
}

/// Sides that run along one direction, clipped by a region that is a box in some coordinates.
template <class S>
class Sides {
 public:
  /// In those coordinates a side runs from its middle by `along` both ways, and the region to `reach` both ways.
  Sides(const FlatPoint<S>& along, const FlatPoint<S>& reach, const FlatPoint<S>& vanishing) {
    using std::abs;
    const auto inverse = [&](const S& d, const S& v) { return S(1) / select(abs(d) > v, d, v); };
    x_ = inverse(along.x, vanishing.x);
    y_ = inverse(along.y, vanishing.y);
    half_x_ = reach.x * abs(x_);
    half_y_ = reach.y * abs(y_);
  }
  /// Where along a side with that middle the region begins, from -1 to 1; whether it does at all.
  std::pair<S, decltype(S() < S())> begin(const FlatPoint<S>& middle) const {
    const S x = middle.x * x_, y = middle.y * y_;
    const S low = greatest(S(-1), greatest(-x - half_x_, -y - half_y_)),
            high = least(S(1), least(half_x_ - x, half_y_ - y));
    return {low, low <= high};
  }

 private:
  S x_, y_, half_x_, half_y_;
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
  S apart_at(const FlatPoint<S>& p) const { return apart + (p.x - center.x) * slope.x + (p.y - center.y) * slope.y; }

  void corners(Corner<S> (&slots)[most_box_points]) const {
    // Both sides' directions in the upper half plane, u's angle the smaller: the parallelogram stays the same.
    const auto lower = [](const FlatPoint<S>& d) { return (d.y < S(0)) | ((d.y == S(0)) & (d.x < S(0))); };
    const auto flip = [](const Mask& m, const FlatPoint<S>& d) {
      return FlatPoint<S>{select(m, -d.x, d.x), select(m, -d.y, d.y)};
    };
    const Mask mirrored = u.x * v.y - u.y * v.x < S(0), turn = lower(u);
    const FlatPoint<S> first = flip(turn, u), second = flip((mirrored & (!turn)) | ((!mirrored) & turn), v);
    const Mask crossed = lower(second);
    const FlatPoint<S> p{select(crossed, -second.x, first.x), select(crossed, -second.y, first.y)},
        q{select(crossed, first.x, second.x), select(crossed, first.y, second.y)};

    // A side that the slack alone lets pass doubles a corner; without it rounding might lose one.
    const FlatPoint<S> reach{half.x + slack, half.y + slack}, vanishing{slack * S(epsilon<S>), slack * S(epsilon<S>)};
    const Sides<S> along_p(p, reach, vanishing), along_q(q, reach, vanishing);
    const auto of_parallelogram = [&](const Sides<S>& sides, const FlatPoint<S>& along, const S& sign,
                                      const FlatPoint<S>& middle) {
      // Against the direction the region begins where it ends along it: at the negative of the mirrored middle.
      const auto [begin, is] = sides.begin({middle.x * sign, middle.y * sign});
      const S t = begin * sign;
      return Corner<S>{{middle.x + along.x * t, middle.y + along.y * t}, is};
    };
    const FlatPoint<S> below{center.x - q.x, center.y - q.y}, above{center.x + q.x, center.y + q.y},
        right{center.x + p.x, center.y + p.y}, left{center.x - p.x, center.y - p.y};
    const Corner<S> p0 = of_parallelogram(along_p, p, S(1), below), p1 = of_parallelogram(along_q, q, S(1), right),
                    p2 = of_parallelogram(along_p, p, S(-1), above), p3 = of_parallelogram(along_q, q, S(-1), left);

    const FlatPoint<S> reach_uv{S(1) + slack_uv.x, S(1) + slack_uv.y},
        vanishing_uv{slack_uv.x * S(epsilon<S>), slack_uv.y * S(epsilon<S>)};
    const FlatPoint<S> x_uv{half.x * to_u.x, half.x * to_v.x}, y_uv{half.y * to_u.y, half.y * to_v.y},
        middle_uv = in_uv({S(0), S(0)});
    const Sides<S> along_x(x_uv, reach_uv, vanishing_uv), along_y(y_uv, reach_uv, vanishing_uv);
    const auto of_rectangle = [&](const Sides<S>& sides, const FlatPoint<S>& offset, const S& sign) {
      const auto [begin, is] = sides.begin({(middle_uv.x + offset.x) * sign, (middle_uv.y + offset.y) * sign});
      return std::pair{begin * sign, is};
    };
    const auto [t0, is0] = of_rectangle(along_x, {-y_uv.x, -y_uv.y}, S(1));
    const auto [t1, is1] = of_rectangle(along_y, x_uv, S(1));
    const auto [t2, is2] = of_rectangle(along_x, y_uv, S(-1));
    const auto [t3, is3] = of_rectangle(along_y, {-x_uv.x, -x_uv.y}, S(-1));
    const Corner<S> r0{{half.x * t0, -half.y}, is0}, r1{{half.x, half.y * t1}, is1}, r2{{half.x * t2, half.y}, is2},
        r3{{-half.x, half.y * t3}, is3};

    const Mask p_first = p.x > S(0), q_first = q.x > S(0);  // before the upright side
    slots[0] = r0;
    slots[1] = select(p_first, p0, r1);
    slots[2] = select(q_first, p1, select(p_first, r1, p0));
    slots[3] = select(q_first, r1, p1);
    slots[4] = r2;
    slots[5] = select(p_first, p2, r3);
    slots[6] = select(q_first, p3, select(p_first, r3, p2));
    slots[7] = select(q_first, r3, p3);
  }
};

/// A place among the slots, counted in lanes.
template <class S>
S slot_number(std::size_t i) {
  return S(static_cast<typename LaneOf<S>::type>(i));
}

/// Of values in a ring of slots, for each slot the value of the corner before it and of the one that follows; of a slot
/// without a corner, whatever.
template <class S>
struct Around {
  S before[most_box_points], after[most_box_points];

  template <class Value>
  Around(const Corner<S> (&slots)[most_box_points], const Value& value) {
    S first = value(0), last = value(0);
    for (std::size_t i = most_box_points; i-- > 0;) first = select(slots[i].is, value(i), first);
    for (std::size_t i = 0; i < most_box_points; ++i) last = select(slots[i].is, value(i), last);
    for (std::size_t i = most_box_points; i-- > 0;) {
      after[i] = first;
      first = select(slots[i].is, value(i), first);
    }
    for (std::size_t i = 0; i < most_box_points; ++i) {
      before[i] = last;
      last = select(slots[i].is, value(i), last);
    }
  }
};

/// Drops corners as `simplify` does: those that stand out by less than `near`, while no more than `spared_area` is lost;
/// the deepest always stays. Where `simplify` takes the least of all, each pass takes those that are less than their
/// neighbours, which are gone in two passes as a rule. `apart` is how far apart the faces are at each corner.
template <class S>
void drop_idle_corners(Corner<S> (&slots)[most_box_points], const S (&apart)[most_box_points], const S& near) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S near_squared = near * near, together = S(same_point<T>) * near_squared,
          infinity(std::numeric_limits<T>::infinity());
  const auto x = [&](std::size_t i) -> const S& { return slots[i].at.x; };
  const auto y = [&](std::size_t i) -> const S& { return slots[i].at.y; };
  S least_apart = infinity, deepest(-1), budget(0);
  for (std::size_t i = 0; i < most_box_points; ++i) {
    const Mask deeper = slots[i].is & (apart[i] < least_apart);
    least_apart = select(deeper, apart[i], least_apart);
    deepest = select(deeper, slot_number<S>(i), deepest);
  }
  {
    const Around<S> around_x(slots, x), around_y(slots, y);
    for (std::size_t i = 0; i < most_box_points; ++i) {
      const FlatPoint<S> p = slots[i].at, q{around_x.after[i], around_y.after[i]};
      budget = budget + select(slots[i].is, p.x * q.y - p.y * q.x, S(0));
      // Corners that came twice go first, all at once but for one.
      const Mask again = slots[i].is & (distance_squared(p, q) <= together) & (deepest != slot_number<S>(i));
      slots[i].is = slots[i].is & (!again);
    }
    budget = abs(budget) * S(T(spared_area));
  }
  for (;;) {
    const Around<S> around_x(slots, x), around_y(slots, y);
    S count(0), lost[most_box_points];
    for (std::size_t i = 0; i < most_box_points; ++i) count = count + select(slots[i].is, S(1), S(0));
    Mask some = count < S(0);
    for (std::size_t i = 0; i < most_box_points; ++i) {
      const FlatPoint<S> before{around_x.before[i], around_y.before[i]}, p = slots[i].at,
                                                                         after{around_x.after[i], around_y.after[i]};
      const Mask again = least(distance_squared(before, p), distance_squared(p, after)) <= together;
      const S corner = select(again, S(0), abs(cross(before, p, after)));
      const Mask may = slots[i].is & (deepest != slot_number<S>(i)) & (count > S(1)) & ((count > S(2)) | again) &
                       (corner <= budget) & (corner * corner <= near_squared * distance_squared(before, after));
      lost[i] = select(may, corner, infinity);
      some = some | may;
    }
    if (!any(some)) return;
    const Around<S> around_lost(slots, [&](std::size_t i) -> const S& { return lost[i]; }),
        around_apart(slots, [&](std::size_t i) -> const S& { return apart[i]; });
    // Both ends of a trapezoid's side cost the same: the shallower goes, or rounding would choose.
    const auto level = [&](const S& p, const S& q) { return abs(p - q) <= S(T(same_cost)) * least(p, q); };
    Mask dropped = count < S(0);
    for (std::size_t i = 0; i < most_box_points; ++i) {
      const S &before = around_lost.before[i], &after = around_lost.after[i];
      const Mask like_before = level(lost[i], before), like_after = level(lost[i], after);
      const Mask rather =
          ((like_before & (apart[i] >= around_apart.before[i])) | ((!like_before) & (lost[i] < before))) &
          ((like_after & (apart[i] > around_apart.after[i])) | ((!like_after) & (lost[i] < after)));
      const Mask goes = slots[i].is & (lost[i] <= budget) & rather;
      budget = select(goes, budget - lost[i], budget);
      slots[i].is = slots[i].is & (!goes);
      dropped = dropped | goes;
    }
    if (!any(dropped)) return;
  }
}

}  // namespace detail

}  // namespace graze
