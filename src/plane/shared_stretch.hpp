// The stretch that two sides facing each other share across a normal.
//
// Guarantee: written once for one pair and for lanes, in the same order of operations, so that both decide alike.
#pragma once

#include <cmath>

#include "plane/nearest.hpp"

namespace graze::plane {

/// The coordinates of the two ends of a side, added up: what the rounding of places along it refers to.
template <class S>
[[gnu::always_inline]] inline S reach_of(const Vec2<S>& p, const Vec2<S>& q) {
  using std::abs;
  return abs(p.x) + abs(p.y) + abs(q.x) + abs(q.y);
}

/// Whether two sides share more across the normal than a part of their ends and of the way between their origins: the
/// rounding of these, or where the normal was searched for its error. Along the way from a vertex to a vertex, the
/// edges that begin there share a point, or nothing, as rounding has it.
template <class S>
[[gnu::always_inline]] inline auto share_a_stretch(const S& low, const S& high, const S& reach_a, const S& reach_b,
                                                   const Vec2<S>& way, double part = touching_rounding) {
  using std::abs;
  return high - low > S(part) * (reach_a + reach_b + abs(way.x) + abs(way.y));
}

}  // namespace graze::plane
