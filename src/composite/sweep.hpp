// A box that moves along a straight line, against boxes that stand: how moving shapes descend a tree of bounds.
//
// Guarantee: no box that the moving one touches is lost to rounding, far from the origin and in float too.
#pragma once

#include <cmath>

#include "graze/aabb.hpp"

namespace graze {

/// A box that moves by `motion` in one unit of time.
template <class T>
struct Sweep {
  Aabb<T> box;
  Vec3<T> motion{};
};

/// The largest coordinate that is not infinite.
template <class T>
T finite_reach(const Aabb<T>& box) {
  T reach(0);
  for (const Vec3<T>& p : {box.lower, box.upper})
    for (std::size_t i = 0; i < 3; ++i)
      if (std::abs(p[i]) < std::numeric_limits<T>::infinity()) reach = greatest(reach, std::abs(p[i]));
  return reach;
}

/// The sweep grown by what rounding may do to its coordinates: they come of some ten operations, and `entry` adds
/// three.
template <class T>
Sweep<T> safe_sweep(const Aabb<T>& box, const Vec3<T>& motion, T margin) {
  const T rounding_error = T(16) * std::numeric_limits<T>::epsilon() * (finite_reach(box) + max_abs(motion));
  return {inflated(box, margin + rounding_error), motion};
}

/// When the moving box first touches one that stands: a time in [0, 1], or infinity (Kay, Kajiya 1986, "Ray tracing
/// complex scenes", on slabs).
template <class T>
T entry(const Aabb<T>& still, const Sweep<T>& sweep) {
  T first(0), last(1);
  constexpr T never = std::numeric_limits<T>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const T near = still.lower[i] - sweep.box.upper[i], far = still.upper[i] - sweep.box.lower[i], v = sweep.motion[i];
    if (v == T(0)) {
      if (near > T(0) || far < T(0)) return never;
      continue;
    }
    first = greatest(first, (v > T(0) ? near : far) / v);
    last = least(last, (v > T(0) ? far : near) / v);
  }
  return first <= last ? first : never;
}

/// The question of `visit_pieces` for the boxes that are reached by a time, the first reached first.
template <class T>
struct SweepQuestion {
  using Key = T;
  Sweep<T> sweep;

  T operator()(const Aabb<T>& still) const { return entry(still, sweep); }
  /// Finite, so that what is never reached is left out.
  T key(const T& time) const { return least(time, std::numeric_limits<T>::max()); }
};

}  // namespace graze
