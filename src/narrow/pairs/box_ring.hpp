// The corners of an outline in a ring of slots, across lanes, and the ones taken out that mean nothing.
//
// Guarantee: in every lane the bits that the pair gives alone. Corners that come twice and those that stand out too little
// to mean anything are taken out as `simplify` does.
#pragma once

#include <limits>

#include "lanes/several.hpp"
#include "narrow/core.hpp"
#include "narrow/outline.hpp"

namespace graze {

/// As many corners as a rectangle and a parallelogram laid over each other can have.
inline constexpr std::size_t most_box_points = 8;

namespace detail {

/// What the four sides of a face begin with: corners of an outline, where they are any.
template <class S>
struct Corners {
  Several<S, 4> x, y, apart;         ///< where, and how far the faces are apart there
  typename Several<S, 4>::Mask are;  ///< false: there is none
};

/// A place among the slots, counted in lanes.
template <class S>
S slot_number(std::size_t i) {
  return S(static_cast<typename LaneOf<S>::type>(i));
}

/// Corners in order. Lanes have them in different slots, so that each slot has a mask that tells whether there is one. Those
/// of a single pair close up, and what is done to all of them is done with the last.
template <class S>
struct Ring {
  using Mask = decltype(S() < S());
  static constexpr bool single = std::is_arithmetic_v<S>;

  S x[most_box_points], y[most_box_points], apart[most_box_points];
  Mask is[most_box_points], stays[most_box_points];
  std::size_t size = most_box_points;

  Ring() = default;
  /// From the corners of a rectangle, whose sides run along x and y, and of a parallelogram, whose sides' directions p and
  /// q come after x; `p_first` and `q_first` where they come before y.
  Ring(const Corners<S>& rectangle, const Corners<S>& parallelogram, const Mask& p_first, const Mask& q_first) {
    const auto in_order = [&](const auto(&all)[most_box_points], auto(&slots)[most_box_points]) {
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
      size = 0;
      for (const std::size_t i : order) {
        x[size] = all_x[i];
        y[size] = all_y[i];
        apart[size] = all_apart[i];
        is[size] = true;
        size += all_are[i];
      }
    } else {
      in_order(all_x, x);
      in_order(all_y, y);
      in_order(all_apart, apart);
      in_order(all_are, is);
    }
  }

  FlatPoint<S> at(std::size_t i) const { return {x[i], y[i]}; }

  /// How far the faces are apart at the deepest corner, the first such, which `stays`.
  S find_deepest() {
    S least_apart(std::numeric_limits<typename LaneOf<S>::type>::infinity()), deepest(-1);
    for (std::size_t i = 0; i < size; ++i) {
      const Mask deeper = is[i] & (apart[i] < least_apart);
      least_apart = select(deeper, apart[i], least_apart);
      deepest = select(deeper, slot_number<S>(i), deepest);
    }
    for (std::size_t i = 0; i < size; ++i) stays[i] = deepest == slot_number<S>(i);
    return least_apart;
  }

  /// Closes gaps up where corners are gone.
  void close_up() {
    if constexpr (single) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < size; ++i) {
        x[kept] = x[i];
        y[kept] = y[i];
        apart[kept] = apart[i];
        stays[kept] = stays[i];
        const bool keep = is[i];
        is[kept] = true;
        kept += keep;
      }
      size = kept;
    }
  }
};

/// Of values of the corners, for each the value of the corner before it and of the one that follows; where there is no
/// corner, whatever.
template <class S>
class Around {
 public:
  Around(const Ring<S>& ring, const S (&values)[most_box_points]) : values_(values), size_(ring.size) {
    if constexpr (!Ring<S>::single) {
      S first = values[0], last = values[0];
      for (std::size_t i = most_box_points; i-- > 0;) first = select(ring.is[i], values[i], first);
      for (std::size_t i = 0; i < most_box_points; ++i) last = select(ring.is[i], values[i], last);
      for (std::size_t i = most_box_points; i-- > 0;) {
        after_[i] = first;
        first = select(ring.is[i], values[i], first);
      }
      for (std::size_t i = 0; i < most_box_points; ++i) {
        before_[i] = last;
        last = select(ring.is[i], values[i], last);
      }
    }
  }
  const S& before(std::size_t i) const {
    if constexpr (Ring<S>::single)
      return values_[(i == 0 ? size_ : i) - 1];
    else
      return before_[i];
  }
  const S& after(std::size_t i) const {
    if constexpr (Ring<S>::single)
      return values_[i + 1 == size_ ? 0 : i + 1];
    else
      return after_[i];
  }

 private:
  const S (&values_)[most_box_points];
  std::size_t size_;
  S before_[Ring<S>::single ? 1 : most_box_points], after_[Ring<S>::single ? 1 : most_box_points];
};

/// Drops corners as `simplify` does: those that stand out by less than `near`, while no more than `spared_area` is lost;
/// the deepest, which `find_deepest` has marked, always stays. Where `simplify` takes the least of all, each pass takes
/// those that are less than their neighbours, which are gone in two passes as a rule.
template <class S>
void drop_idle_corners(Ring<S>& ring, const S& near) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S near_squared = near * near, together = S(same_point<T>) * near_squared,
          infinity(std::numeric_limits<T>::infinity());
  S budget(0);
  {
    const Around<S> x(ring, ring.x), y(ring, ring.y);
    for (std::size_t i = 0; i < ring.size; ++i) {
      const FlatPoint<S> p = ring.at(i), q{x.after(i), y.after(i)};
      budget = budget + select(ring.is[i], p.x * q.y - p.y * q.x, S(0));
      // Corners that came twice go first, all at once but for one.
      const Mask again = ring.is[i] & (distance_squared(p, q) <= together) & (!ring.stays[i]);
      ring.is[i] = ring.is[i] & (!again);
    }
    budget = abs(budget) * S(T(spared_area));
  }
  for (;;) {
    ring.close_up();
    const Around<S> x(ring, ring.x), y(ring, ring.y);
    S count(0), lost[most_box_points];
    for (std::size_t i = 0; i < ring.size; ++i) count = count + select(ring.is[i], S(1), S(0));
    Mask some = count < S(0);
    for (std::size_t i = 0; i < ring.size; ++i) {
      const FlatPoint<S> before{x.before(i), y.before(i)}, p = ring.at(i), after{x.after(i), y.after(i)};
      const Mask again = least(distance_squared(before, p), distance_squared(p, after)) <= together;
      const S corner = select(again, S(0), abs(cross(before, p, after)));
      const Mask may = ring.is[i] & (!ring.stays[i]) & (count > S(1)) & ((count > S(2)) | again) & (corner <= budget) &
                       (corner * corner <= near_squared * distance_squared(before, after));
      lost[i] = select(may, corner, infinity);
      some = some | may;
    }
    if (!any(some)) return;
    const Around<S> around_lost(ring, lost), around_apart(ring, ring.apart);
    // Both ends of a trapezoid's side cost the same: the shallower goes, or rounding would choose.
    const auto level = [&](const S& p, const S& q) { return abs(p - q) <= S(T(same_cost)) * least(p, q); };
    Mask dropped = count < S(0);
    for (std::size_t i = 0; i < ring.size; ++i) {
      const S &before = around_lost.before(i), &after = around_lost.after(i);
      const Mask like_before = level(lost[i], before), like_after = level(lost[i], after);
      const Mask rather =
          ((like_before & (ring.apart[i] >= around_apart.before(i))) | ((!like_before) & (lost[i] < before))) &
          ((like_after & (ring.apart[i] > around_apart.after(i))) | ((!like_after) & (lost[i] < after)));
      const Mask goes = ring.is[i] & (lost[i] <= budget) & rather;
      budget = select(goes, budget - lost[i], budget);
      ring.is[i] = ring.is[i] & (!goes);
      dropped = dropped | goes;
    }
    if (!any(dropped)) return;
  }
}

}  // namespace detail

}  // namespace graze
