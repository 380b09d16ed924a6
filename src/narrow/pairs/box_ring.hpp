// The corners of an outline in a ring of slots, across lanes, and the ones taken out that mean nothing.
//
// Guarantee: in every lane the bits that the pair gives alone. Corners that come twice and those that stand out too
// little to mean anything are taken out as `simplify` does.
#pragma once

#include <limits>

#include "lanes/several.hpp"
#include "narrow/core.hpp"
#include "narrow/outline.hpp"

namespace graze {

/// As many corners as a rectangle and a parallelogram laid over each other can have.
inline constexpr std::size_t most_box_points = 8;

namespace detail {

/// Whether a direction is in the second half turn, from 180 to below 360 degrees.
template <class S>
auto in_second_half(const FlatPoint<S>& d) {
  return (d.y < S(0)) | ((d.y == S(0)) & (d.x < S(0)));
}

/// What the four sides of a face begin with: corners of an outline, where they are any.
template <class S>
struct Corners {
  Several<S, 4> x, y, apart;         ///< where, and how far the faces are apart there
  typename Several<S, 4>::Mask are;  ///< false: there is none
};

/// Corners in order. Lanes have them in different slots, so that each slot has a mask that tells whether there is one.
/// Those of a single pair close up, and what is done to all of them is done with the last.
template <class S>
class Ring {
 public:
  using Mask = decltype(S() < S());
  using T = typename LaneOf<S>::type;
  static constexpr bool single = std::is_arithmetic_v<S>;
  /// So many corners are done at a time: of lanes each by itself, since many a slot has none in any lane.
  static constexpr int step = single ? 4 : 1;
  using Some = Several<S, step>;
  using Somes = typename Some::Mask;
  /// A number of each corner, with room before the first one for the last, and behind that for the first.
  using Column = S[most_box_points + 2];

  Column x{}, y{}, apart{};
  std::size_t size() const {
    if constexpr (single)
      return size_;
    else
      return most_box_points;
  }

  /// From the corners of a rectangle, whose sides run along x and y, and of a parallelogram, whose sides' directions p
  /// and q come after x; `p_first` and `q_first` where they come before y.
  Ring(const Corners<S>& rectangle, const Corners<S>& parallelogram, const Mask& p_first, const Mask& q_first) {
    const auto in_order = [&](const auto(&all)[most_box_points], auto* slots) {
      for (std::size_t half = 0; half < most_box_points; half += 4) {
        const auto *r = all + half / 2, *p = r + 4;
        slots[half] = r[0];
        slots[half + 1] = select(p_first, p[0], r[1]);
        slots[half + 2] = select(q_first, p[1], select(p_first, r[1], p[0]));
        slots[half + 3] = select(q_first, r[1], p[1]);
      }
    };
    const auto gather = [&](const auto& of_rectangle, const auto& of_parallelogram, auto(&all)[most_box_points]) {
      of_rectangle.store(all);
      of_parallelogram.store(all + 4);
    };
    S all_x[most_box_points], all_y[most_box_points], all_apart[most_box_points];
    Mask all_are[most_box_points];
    gather(rectangle.x, parallelogram.x, all_x);
    gather(rectangle.y, parallelogram.y, all_y);
    gather(rectangle.apart, parallelogram.apart, all_apart);
    gather(rectangle.are, parallelogram.are, all_are);
    if constexpr (single) {
      constexpr std::size_t numbers[most_box_points] = {0, 1, 2, 3, 4, 5, 6, 7};
      std::size_t order[most_box_points];
      in_order(numbers, order);
      for (const std::size_t i : order) append(all_x[i], all_y[i], all_apart[i], all_are[i]);
      join_ends();
    } else {
      in_order(all_x, x + 1);
      in_order(all_y, y + 1);
      in_order(all_apart, apart + 1);
      in_order(all_are, is_);
    }
  }

  /// From corners in order, each of which may be none.
  using All = S[most_box_points];
  Ring(const All& all_x, const All& all_y, const All& all_apart, const Mask (&all_are)[most_box_points]) {
    for (std::size_t i = 0; i < most_box_points; ++i) {
      if constexpr (single) {
        append(all_x[i], all_y[i], all_apart[i], all_are[i]);
      } else {
        x[i + 1] = all_x[i];
        y[i + 1] = all_y[i];
        apart[i + 1] = all_apart[i];
        is_[i] = all_are[i];
      }
    }
    if constexpr (single) join_ends();
  }

  /// The numbers from place `i` on; and of which of them there is a corner.
  static Some some(const Column& column, std::size_t i) { return Some::load(column + 1 + i); }
  Somes are(std::size_t i) const {
    if constexpr (single)
      return numbers(i) < Some(S(size_));
    else
      return Somes::of(is_[i]);
  }
  Somes stay(std::size_t i) const { return numbers(i) == Some(deepest_); }
  /// Two to the power of the places from `i` on.
  static Some powers(std::size_t i) {
    const S first(static_cast<T>(1 << i));
    if constexpr (single)
      return Some(S(1), S(2), S(4), S(8)) * Some(first);
    else
      return Some(first);
  }
  S count() const {
    if constexpr (single) return S(size_);
    S sum(0);
    for (std::size_t i = 0; i < size(); ++i) sum = sum + select(is_[i], S(1), S(0));
    return sum;
  }

  /// How far the faces are apart at the deepest corner, the first such, which is to stay.
  S find_deepest() {
    const Some none{S(std::numeric_limits<T>::infinity())};
    const auto least_of = [](const Some& a) {
      S low = a[0];
      for (int k = 1; k < step; ++k) low = least(low, a[k]);
      return low;
    };
    Some low = none, first = none;
    for (std::size_t i = 0; i < size(); i += step) {
      const Some here = some(apart, i);
      const Somes deeper = are(i) & (here < low);
      low = select(deeper, here, low);
      first = select(deeper, numbers(i), first);
    }
    const S least_apart = least_of(low);
    deepest_ = least_of(select(low == Some(least_apart), first, none));
    return least_apart;
  }

  /// Takes corners out, of those from place `i` on; they are gone after `close_up`.
  void drop(std::size_t i, const Somes& corners) {
    if (single && !any(corners)) return;
    Mask all[step];
    corners.store(all);
    drop(i, all);
  }
  void drop(std::size_t i, const Mask (&corners)[step]) {
    for (std::size_t k = 0; k < step; ++k) {
      if constexpr (single) {
        gone_[i + k] = corners[k];
        gaps_ |= corners[k];
      } else {
        is_[i + k] = is_[i + k] & (!corners[k]);
      }
    }
  }
  void close_up() {
    if constexpr (single) {
      if (!gaps_) return;
      std::size_t kept = 0, deepest = 0;
      for (std::size_t i = 0; i < size(); ++i) {
        x[kept + 1] = x[i + 1];
        y[kept + 1] = y[i + 1];
        apart[kept + 1] = apart[i + 1];
        if (S(i) == deepest_) deepest = kept;
        kept += !gone_[i];
        gone_[i] = false;
      }
      size_ = kept;
      deepest_ = S(deepest);
      gaps_ = false;
      join_ends();
    }
  }
  /// Makes the corners of a column a ring.
  void join_ends(Column& column) const {
    column[0] = column[size_];
    column[size_ + 1] = column[1];
  }
  const Mask* is() const requires(!single) { return is_; }

  /// Whether there is a corner at place `i`, and where.
  Mask has(std::size_t i) const {
    if constexpr (single)
      return i < size_;
    else
      return is_[i];
  }
  FlatPoint<S> at(std::size_t i) const { return {x[i + 1], y[i + 1]}; }

 private:
  /// One more of a single pair; the next is put in its place if it is none.
  void append(const S& at_x, const S& at_y, const S& how_far, bool is) {
    x[size_ + 1] = at_x;
    y[size_ + 1] = at_y;
    apart[size_ + 1] = how_far;
    size_ += is;
  }
  /// The places from `i` on.
  static Some numbers(std::size_t i) {
    const S first(static_cast<T>(i));
    if constexpr (single)
      return Some(S(0), S(1), S(2), S(3)) + Some(first);
    else
      return Some(first);
  }
  void join_ends() {
    join_ends(x);
    join_ends(y);
    join_ends(apart);
  }

  std::size_t size_ = 0;  ///< of a single pair
  S deepest_;
  Mask is_[single ? 1 : most_box_points];      ///< of lanes
  bool gone_[single ? most_box_points : 1]{};  ///< of a single pair, while there are gaps
  bool gaps_ = false;
};

/// Of a number of each corner in a ring, that of the corner before it and of the one that follows; where there is no
/// corner, whatever.
template <class S>
class Around {
 public:
  using Some = typename Ring<S>::Some;
  using Column = typename Ring<S>::Column;

  Around(const Ring<S>& ring, const Column& column) : column_(column) {
    if constexpr (!Ring<S>::single) {
      const auto* is = ring.is();
      const S* values = column + 1;
      S first = values[0], last = values[0];
      for (std::size_t i = most_box_points; i-- > 0;) first = select(is[i], values[i], first);
      for (std::size_t i = 0; i < most_box_points; ++i) last = select(is[i], values[i], last);
      for (std::size_t i = most_box_points; i-- > 0;) {
        after_[i] = first;
        first = select(is[i], values[i], first);
      }
      for (std::size_t i = 0; i < most_box_points; ++i) {
        before_[i] = last;
        last = select(is[i], values[i], last);
      }
    }
  }
  /// For the corners from place `i` on.
  Some before(std::size_t i) const {
    if constexpr (Ring<S>::single)
      return Some::load(column_ + i);
    else
      return Some(before_[i]);
  }
  Some after(std::size_t i) const {
    if constexpr (Ring<S>::single)
      return Some::load(column_ + 2 + i);
    else
      return Some(after_[i]);
  }

 private:
  const Column& column_;
  S before_[Ring<S>::single ? 1 : most_box_points], after_[Ring<S>::single ? 1 : most_box_points];
};

/// Drops corners as `simplify` does: those that stand out by less than `near`, while no more than `spared_area` is
/// lost; the deepest, which has been found, always stays. Where `simplify` takes the least of all, each pass takes
/// those that are less than their neighbours, which are gone in two passes as a rule.
template <class S>
void drop_idle_corners(Ring<S>& ring, const S& near) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  using Some = typename Ring<S>::Some;
  using Somes = typename Some::Mask;
  constexpr int step = Ring<S>::step;
  using Mask = typename Ring<S>::Mask;
  using Places = FlatPoint<Some>;
  const S near_squared = near * near;
  const Some together(S(same_point<T>) * near_squared), infinity{S(std::numeric_limits<T>::infinity())}, zero(S(0));
  const auto places = [&](std::size_t i) { return Places{ring.some(ring.x, i), ring.some(ring.y, i)}; };
  S budget(0);
  {
    const Around<S> x(ring, ring.x), y(ring, ring.y);
    for (std::size_t i = 0; i < ring.size(); i += step) {
      const Places p = places(i), q{x.after(i), y.after(i)};
      const Somes are = ring.are(i);
      const Some area = select(are, p.x * q.y - p.y * q.x, zero);
      for (int k = 0; k < step; ++k) budget = budget + area[k];
      // Corners that came twice go first, all at once but for one.
      const Somes again = are & (distance_squared(p, q) <= together) & (!ring.stay(i));
      ring.drop(i, again);
    }
    budget = abs(budget) * S(T(spared_area));
  }
  for (;;) {
    ring.close_up();
    const Around<S> x(ring, ring.x), y(ring, ring.y);
    const Some count(ring.count());
    const Somes of_many = count > Some(S(1)), of_more = count > Some(S(2));
    typename Ring<S>::Column lost{};
    Somes movable = count < zero;
    for (std::size_t i = 0; i < ring.size(); i += step) {
      const Places before{x.before(i), y.before(i)}, p = places(i), after{x.after(i), y.after(i)};
      const Somes again = least(distance_squared(before, p), distance_squared(p, after)) <= together;
      const Some corner = select(again, zero, abs(cross(before, p, after)));
      const Somes may = ring.are(i) & (!ring.stay(i)) & of_many & (of_more | again) & (corner <= Some(budget)) &
                        (corner * corner <= Some(near_squared) * distance_squared(before, after));
      select(may, corner, infinity).store(lost + 1 + i);
      movable = movable | may;
    }
    if (!any(movable)) return;
    if constexpr (Ring<S>::single) ring.join_ends(lost);
    const Around<S> around_lost(ring, lost), around_apart(ring, ring.apart);
    // Both ends of a trapezoid's side cost the same: the shallower goes, or rounding would choose.
    const auto level = [&](const Some& p, const Some& q) { return abs(p - q) <= Some(S(T(same_cost))) * least(p, q); };
    Mask dropped = ring.count() < S(0);
    for (std::size_t i = 0; i < ring.size(); i += step) {
      const Some before = around_lost.before(i), after = around_lost.after(i), here = ring.some(lost, i),
                 apart = ring.some(ring.apart, i);
      const Somes like_before = level(here, before), like_after = level(here, after);
      const Somes rather = ((like_before & (apart >= around_apart.before(i))) | ((!like_before) & (here < before))) &
                           ((like_after & (apart > around_apart.after(i))) | ((!like_after) & (here < after))) &
                           ring.are(i);
      Mask go[step];
      for (int k = 0; k < step; ++k) {
        go[k] = rather[k] & (here[k] <= budget);
        budget = select(go[k], budget - here[k], budget);
        dropped = dropped | go[k];
      }
      ring.drop(i, go);
    }
    if (!any(dropped)) return;
  }
}

}  // namespace detail

}  // namespace graze
