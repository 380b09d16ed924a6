// The contact polygon across lanes: its corners in a ring of slots, and its simplification.
//
// Guarantee: in every lane the bits that the pair gives alone. Duplicate corners and corners that hardly stand out are
// removed as `simplify` of polygons does.
#pragma once

#include <limits>

#include "narrow/core/core.hpp"
#include "narrow/manifold/polygon.hpp"
#include "simd/packed.hpp"

namespace graze {

/// Largest number of corners of the intersection of a rectangle and a parallelogram.
inline constexpr std::size_t most_contact_slots = 8;

namespace detail {

/// Whether the angle of a direction is from 180 to below 360 degrees.
template <class S>
auto in_second_half(const FlatPoint<S>& d) {
  return (d.y < S(0)) | ((d.y == S(0)) & (d.x < S(0)));
}

/// The starts of the four sides of a face that are corners of an outline.
template <class S>
struct Corners {
  Packed<S, 4> x, y, apart;         ///< positions, and the distance of the faces there
  typename Packed<S, 4>::Mask are;  ///< false where the side has no corner
};

/// Corners in order, in fixed slots: lanes have them in different slots, so that each slot has a mask of the lanes with
/// a corner there. The polygon of a single pair (`single_contact_polygon.hpp`) has no gaps between slots, and its
/// operations process several slots at once.
template <class S>
class ContactPolygon {
 public:
  using Mask = decltype(S() < S());
  using T = typename LaneOf<S>::type;
  static constexpr bool single = false;
  /// Number of slots processed at a time: one, since many a slot is empty in all lanes.
  static constexpr int step = 1;
  using Some = Packed<S, step>;
  using Somes = typename Some::Mask;
  /// A number for each corner.
  using Column = S[most_contact_slots];
  using All = Column;

  Column x, y, apart;

  /// Merges the corners of a rectangle, whose sides run along x and y, and of a parallelogram, whose sides' directions
  /// p and q come after x; `p_first` and `q_first`: where they come before y.
  ContactPolygon(const Corners<S>& rectangle, const Corners<S>& parallelogram, const Mask& p_first,
                 const Mask& q_first) {
    const auto in_order = [&](const auto& of_rectangle, const auto& of_parallelogram,
                              auto(&slots)[most_contact_slots]) {
      std::remove_reference_t<decltype(slots)> all;
      of_rectangle.store(all);
      of_parallelogram.store(all + 4);
      for (std::size_t half = 0; half < most_contact_slots; half += 4) {
        const auto *r = all + half / 2, *p = r + 4;
        slots[half] = r[0];
        slots[half + 1] = select(p_first, p[0], r[1]);
        slots[half + 2] = select(q_first, p[1], select(p_first, r[1], p[0]));
        slots[half + 3] = select(q_first, r[1], p[1]);
      }
    };
    in_order(rectangle.x, parallelogram.x, x);
    in_order(rectangle.y, parallelogram.y, y);
    in_order(rectangle.apart, parallelogram.apart, apart);
    in_order(rectangle.are, parallelogram.are, is_);
  }

  /// Takes corners in order, each of which may be absent.
  ContactPolygon(const All& all_x, const All& all_y, const All& all_apart, const Mask (&all_are)[most_contact_slots]) {
    for (std::size_t i = 0; i < most_contact_slots; ++i) {
      x[i] = all_x[i];
      y[i] = all_y[i];
      apart[i] = all_apart[i];
      is_[i] = all_are[i];
    }
  }

  static constexpr std::size_t size() { return most_contact_slots; }
  S count() const {
    S sum(0);
    for (const Mask& is : is_) sum = sum + select(is, S(1), S(0));
    return sum;
  }
  /// The numbers from slot `i` on. `are`: which of these slots hold a corner; `stay`: which hold the deepest.
  static Some some(const Column& column, std::size_t i) { return Some(column[i]); }
  static void put(Column& column, std::size_t i, const Some& numbers) { column[i] = numbers[0]; }
  Somes are(std::size_t i) const { return Somes::of(is_[i]); }
  Somes stay(std::size_t i) const { return Some(S(static_cast<T>(i))) == Some(deepest_); }
  /// The sum of two to the power of each set slot, counted from slot `i`.
  static S as_bits(std::size_t i, const Somes& set) { return select(set[0], S(static_cast<T>(1 << i)), S(0)); }

  /// The distance of the faces at the deepest corner, the first of equal ones, which `simplify` keeps.
  S find_deepest() {
    const S none(std::numeric_limits<T>::infinity());
    S low = none;
    deepest_ = none;
    for (std::size_t i = 0; i < size(); ++i) {
      const Mask deeper = is_[i] & (apart[i] < low);
      low = select(deeper, apart[i], low);
      deepest_ = select(deeper, S(static_cast<T>(i)), deepest_);
    }
    return low;
  }

  /// The least distance, as `find_deepest` has it; `simplify` then keeps the corner that is deepest once the faces are
  /// tilted: `tilt` is how much nearer they come for each unit along x and y. Of corners that only rounding tells
  /// apart, that is one by its place.
  S find_deepest_tilted(const FlatPoint<S>& tilt) {
    const S none(std::numeric_limits<T>::infinity());
    S low = none, low_tilted = none;
    deepest_ = none;
    for (std::size_t i = 0; i < size(); ++i) {
      const S tilted = apart[i] - (x[i] * tilt.x + y[i] * tilt.y);
      const Mask deeper = is_[i] & (tilted < low_tilted);
      low = select(is_[i], least(low, apart[i]), low);
      low_tilted = select(deeper, tilted, low_tilted);
      deepest_ = select(deeper, S(static_cast<T>(i)), deepest_);
    }
    return low;
  }

  /// Marks corners, from slot `i` on, as removed; `close_up` completes the removal.
  void drop(std::size_t i, const Somes& corners) {
    const Mask one[step] = {corners[0]};
    drop(i, one);
  }
  void drop(std::size_t i, const Mask (&corners)[step]) {
    gone_ = gone_ | (is_[i] & corners[0]);
    is_[i] = is_[i] & (!corners[0]);
  }
  /// Completes the removal of corners. Returns whether there were any.
  bool close_up() {
    const bool found = any(gone_);
    gone_ = S(0) < S(0);
    return found;
  }
  const Mask* is() const { return is_; }

  /// Whether there is a corner in slot `i`, and its position.
  Mask has(std::size_t i) const { return is_[i]; }
  FlatPoint<S> at(std::size_t i) const { return {x[i], y[i]}; }
  const S& apart_at(std::size_t i) const { return apart[i]; }

 private:
  S deepest_;
  Mask is_[most_contact_slots];
  Mask gone_ = S(0) < S(0);
};

/// The numbers before and after each corner of a polygon that has a number at every corner; undefined for empty
/// slots.
template <class S>
class Around {
 public:
  using Some = typename ContactPolygon<S>::Some;
  using Column = typename ContactPolygon<S>::Column;

  Around(const ContactPolygon<S>& ring, const Column& values) {
    const auto* is = ring.is();
    S first = values[0], last = values[0];
    for (std::size_t i = most_contact_slots; i-- > 0;) first = select(is[i], values[i], first);
    for (std::size_t i = 0; i < most_contact_slots; ++i) last = select(is[i], values[i], last);
    for (std::size_t i = most_contact_slots; i-- > 0;) {
      after_[i] = first;
      first = select(is[i], values[i], first);
    }
    for (std::size_t i = 0; i < most_contact_slots; ++i) {
      before_[i] = last;
      last = select(is[i], values[i], last);
    }
  }
  /// The numbers of the neighbours of the corners from slot `i` on.
  Some before(std::size_t i) const { return Some(before_[i]); }
  Some after(std::size_t i) const { return Some(after_[i]); }

 private:
  S before_[most_contact_slots], after_[most_contact_slots];
};

/// Removes corners as `simplify` of polygons does: those that stand out by less than `near`, while no more than
/// `spared_area` is lost; the deepest, which must have been found, always stays. Where `simplify` of polygons removes
/// the single least corner each time, a pass here removes all corners that are less than their neighbours; as a rule
/// two passes do.
template <class S>
void simplify(ContactPolygon<S>& ring, const S& near) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  using Some = typename ContactPolygon<S>::Some;
  using Somes = typename Some::Mask;
  constexpr int step = ContactPolygon<S>::step;
  using Mask = typename ContactPolygon<S>::Mask;
  using Places = FlatPoint<Some>;
  const S near_squared = near * near;
  const Some most_merged(S(same_point<T>) * near_squared), infinity{S(std::numeric_limits<T>::infinity())}, zero(S(0));
  const auto places = [&](std::size_t i) { return Places{ring.some(ring.x, i), ring.some(ring.y, i)}; };
  // For a single pair the areas are summed up on demand: few have a corner to be removed.
  S budget(ContactPolygon<S>::single ? std::numeric_limits<T>::infinity() : T(0));
  typename ContactPolygon<S>::Column areas;
  const auto sum_up = [&](std::size_t i) {
    for (int k = 0; k < step; ++k) budget = budget + ring.some(areas, i)[k];
  };
  const auto spare = [&] { budget = abs(budget) * S(T(spared_area)); };
  const std::size_t size = ring.size();  // size before any removal
  Around<S> x(ring, ring.x), y(ring, ring.y);
  for (std::size_t i = 0; i < ring.size(); i += step) {
    const Places p = places(i), q{x.after(i), y.after(i)};
    const Somes are = ring.are(i);
    ring.put(areas, i, select(are, p.x * q.y - p.y * q.x, zero));
    if constexpr (!ContactPolygon<S>::single) sum_up(i);
    // Duplicate corners are removed first, all at once but for one.
    const Somes again = are & (distance_squared(p, q) <= most_merged) & (!ring.stay(i));
    ring.drop(i, again);
  }
  if constexpr (!ContactPolygon<S>::single) spare();
  for (bool first = true;; first = false) {
    if (ring.close_up()) {
      x = Around<S>(ring, ring.x);
      y = Around<S>(ring, ring.y);
    }
    const Some count(ring.count());
    const Somes of_many = count > Some(S(1)), of_more = count > Some(S(2));
    typename ContactPolygon<S>::Column lost;
    Somes movable = count < zero;
    for (std::size_t i = 0; i < ring.size(); i += step) {
      const Places before{x.before(i), y.before(i)}, p = places(i), after{x.after(i), y.after(i)};
      const Somes again = least(distance_squared(before, p), distance_squared(p, after)) <= most_merged;
      const Some corner = select(again, zero, abs(cross(before, p, after)));
      const Somes may = ring.are(i) & (!ring.stay(i)) & of_many & (of_more | again) & (corner <= Some(budget)) &
                        (corner * corner <= Some(near_squared) * distance_squared(before, after));
      ring.put(lost, i, select(may, corner, infinity));
      movable = movable | may;
    }
    if (!any(movable)) return;
    if (ContactPolygon<S>::single && first) {
      budget = S(0);
      for (std::size_t i = 0; i < size; i += step) sum_up(i);
      spare();
      movable = count < zero;
      for (std::size_t i = 0; i < ring.size(); i += step) {
        const Some found = ring.some(lost, i);
        const Somes may = found <= Some(budget);
        ring.put(lost, i, select(may, found, infinity));
        movable = movable | may;
      }
      if (!any(movable)) return;
    }
    const Around<S> around_lost(ring, lost), around_apart(ring, ring.apart);
    // Removing either end of a trapezoid's side costs the same: the shallower is removed, or rounding would choose.
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
