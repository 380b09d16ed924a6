// The solid half-space y <= 0, bounded by an infinite plane.
//
// Guarantee: unbounded and yet in every pair: its queries need only the other shape's support point along its normal.
#pragma once

#include "graze/aabb.hpp"
#include "graze/pose.hpp"

namespace graze {

/// All points with y <= 0, its surface normal +Y; a margin moves the surface up.
template <class T>
class HalfSpace {
 public:
  static constexpr const char* name = "plane";

  T core_radius() const { return T(0); }
  T core_extent() const { return T(0); }

  /// All of space, or half of it where the normal is exactly an axis of the world.
  Aabb<T> core_bounds(const Pose<T>& pose) const {
    const Vec3<T> n = rotate(pose.rotation, Vec3<T>{T(0), T(1), T(0)});
    Aabb<T> bounds = Aabb<T>::everything();
    for (std::size_t i = 0; i < 3; ++i) {
      if (n[(i + 1) % 3] != T(0) || n[(i + 2) % 3] != T(0)) continue;
      (n[i] > T(0) ? bounds.upper : bounds.lower)[i] = pose.translation[i];
    }
    return bounds;
  }
};

}  // namespace graze
