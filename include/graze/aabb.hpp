// Boxes aligned with the axes: the bounds that broad phases sort.
//
// Guarantee: `overlap` is closed (boxes that touch overlap), so that no touching pair is ever lost to its bounds.
#pragma once

#include <limits>

#include "graze/vec3.hpp"

namespace graze {

/// All points between `lower` and `upper`, both included. Empty when any lower exceeds its upper.
template <class T>
struct Aabb {
  Vec3<T> lower{}, upper{};  ///< the corners with the least and the greatest coordinates

  /// The empty box: the neutral element of `merged`.
  static constexpr Aabb empty() {
    constexpr T inf = std::numeric_limits<T>::infinity();
    return {{inf, inf, inf}, {-inf, -inf, -inf}};
  }
  /// All of space: the bounds of a half-space.
  static constexpr Aabb everything() {
    constexpr T inf = std::numeric_limits<T>::infinity();
    return {{-inf, -inf, -inf}, {inf, inf, inf}};
  }

  /// The middle.
  constexpr Vec3<T> center() const { return (lower + upper) * T(0.5); }
  /// Edge lengths.
  constexpr Vec3<T> extent() const { return upper - lower; }

  friend constexpr bool operator==(const Aabb&, const Aabb&) = default;
};

using Aabbf = Aabb<float>;
using Aabbd = Aabb<double>;

/// Whether two closed boxes have a point in common; touching counts.
template <class T>
constexpr bool overlap(const Aabb<T>& a, const Aabb<T>& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y &&
         a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}
/// The smallest box that contains both boxes.
template <class T>
constexpr Aabb<T> merged(const Aabb<T>& a, const Aabb<T>& b) {
  return {least(a.lower, b.lower), greatest(a.upper, b.upper)};
}
/// The smallest box that contains the box and the point.
template <class T>
constexpr Aabb<T> merged(const Aabb<T>& a, const Vec3<T>& p) {
  return {least(a.lower, p), greatest(a.upper, p)};
}
/// The box grown by `amount` on every side.
template <class T>
constexpr Aabb<T> inflated(const Aabb<T>& a, const T& amount) {
  const Vec3<T> d{amount, amount, amount};
  return {a.lower - d, a.upper + d};
}
/// Whether `inner` lies within `outer`; boundaries may coincide.
template <class T>
constexpr bool contains(const Aabb<T>& outer, const Aabb<T>& inner) {
  return outer.lower.x <= inner.lower.x && inner.upper.x <= outer.upper.x && outer.lower.y <= inner.lower.y &&
         inner.upper.y <= outer.upper.y && outer.lower.z <= inner.lower.z && inner.upper.z <= outer.upper.z;
}
/// Surface area, the cost that a bounding volume hierarchy minimises. Zero for an empty box.
template <class T>
constexpr T surface_area(const Aabb<T>& a) {
  const Vec3<T> e = a.extent();
  return e.x < T(0) ? T(0) : T(2) * (e.x * e.y + e.y * e.z + e.z * e.x);
}

}  // namespace graze
