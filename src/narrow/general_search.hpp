// Differences, goals and starts of the general path's searches, shared with its explanation, so that the steps shown
// are those of the answer.
#pragma once

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/core/hull_support.hpp"
#include "narrow/core/minkowski.hpp"
#include "narrow/core/scanned_shape.hpp"
#include "narrow/gjk/gjk.hpp"

namespace graze {

/// Goals of the iterations: well within the library's tolerance, since closest points and normals of smooth shapes lose
/// half the digits of the distance.
inline constexpr double distance_goal = 1e-13;
inline constexpr double depth_goal = 1e-11;

template <class T>
using Difference = MinkowskiDifference<ShapeCore<T>, ShapeCore<T>>;

/// Two shapes whose corners are scanned, with their difference.
template <class T>
struct ScannedPair {
  ScannedPair(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a)
      : corners_a(a),
        corners_b(b),
        difference(corners_a.view(), corners_b.view(), greatest(corners_a.extent(), corners_b.extent()), b_in_a) {}

  ScannedShape<T> corners_a, corners_b;
  HullDifference<T> difference;
};
/// Whether a pair is a hull and another scannable shape: all other pairs have routines of their own.
template <class T>
bool are_scanned(const Shape<T>& a, const Shape<T>& b) {
  return (is_hull(a) || is_hull(b)) && is_scannable(a) && is_scannable(b);
}

/// The goals of a distance search. `noise`: rounding of the distance; `limit`: largest distance of interest.
inline GjkGoal distance_goals(double size, double noise, double limit) {
  return {distance_goal * size + noise, greatest(limit + noise, noise)};
}
/// The goals of an overlap search. A gap within rounding counts as touching, as it does for the distance.
inline GjkGoal overlap_goals(double size, double noise, double reach) {
  return {distance_goal * size + noise, reach + noise, reach + noise};
}

template <class Difference, class Observer = Unobserved>
GjkResult search(const Difference& difference, const GjkGoal& goal, const Observer& observer = {}) {
  return gjk(difference, goal, observer);
}
template <class T, class Observer = Unobserved>
GjkResult search(HullDifference<T>& difference, const GjkGoal& goal, const Observer& observer = {}) {
  return gjk_spread(difference, goal, observer);
}

/// Calls `f(difference)` with the difference of two bounded shapes' cores for distance searches.
template <class T, class F>
decltype(auto) with_distance_difference(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, F&& f) {
  if (are_scanned(a, b)) {
    ScannedPair<T> scanned(a, b, b_in_a);
    return f(scanned.difference);
  }
  const ShapeCore<T> core_a(a), core_b(b);
  const Difference<T> difference(core_a, core_b, b_in_a);
  return f(difference);
}

/// Calls `f(difference)` with the difference for overlap searches. Few corners are cheaper to transform one by one than
/// all together before the first query: a ball with a hull takes two thirds of the time, so does a box.
template <class T, class F>
decltype(auto) with_overlap_difference(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, F&& f) {
  if (is_hull(a) && is_hull(b) && are_scanned(a, b)) {
    ScannedPair<T> scanned(a, b, b_in_a);
    return f(scanned.difference);
  }
  const ShapeCore<T> core_a(a), core_b(b);
  const Difference<T> difference(core_a, core_b, b_in_a);
  return f(difference);
}

}  // namespace graze
