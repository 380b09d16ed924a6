// The nearest points of two cores: what every query in the plane stands on.
//
// Guarantee: answers for every pair of kinds, in A's frame. Polygons exactly, from the edges of their Minkowski
// difference; curved cores within `goal` times their size, or `bounded` with a proven error.
#pragma once

#include <limits>

#include "graze/result.hpp"
#include "plane/core.hpp"

namespace graze::plane {

/// The signed distance of two cores, rounding aside, and the points that realise it.
struct Nearest {
  double distance = 0;
  Vec2d normal{0, 1};  ///< unit, from A to B
  CorePoint a{}, b{};  ///< on the cores, both in A's frame
  Status status = Status::converged;
  double error = 0;
};

/// The gap between the bounds of a curved core's distance at which the search ends, relative to the size of the pair: a
/// tenth of the tolerance for double, and in the reach of doubles' rounding.
inline constexpr double goal = 1e-11;

/// Cores that are no further apart than this, relative to their size and the way between their origins, touch: some
/// sixteen operations have made the distance, each half a unit off, and others would find an overlap.
inline constexpr double touching_rounding = 16 * std::numeric_limits<double>::epsilon();

/// The nearest points of any two cores. `size`: of the pair, which the goal refers to.
template <class T>
Nearest nearest(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size);

/// The gap that remains between the bounds of a curved pair's distance: the goal, or what rounding of the support
/// points leaves (a user's are in T), which lie as far from the origin as the cores do from each other.
template <class T>
double accuracy(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size);

/// The nearest points of two polygons. `size`: no less than any vertex is from the origin of its core.
template <class T>
Nearest nearest_polygons(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size);

/// The nearest points of two polygons by the walk around their Minkowski difference, also where another way is faster.
template <class T>
Nearest nearest_by_walk(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a);

/// The nearest points of two bounded cores by their support functions.
template <class T>
Nearest nearest_curved(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size);

}  // namespace graze::plane
