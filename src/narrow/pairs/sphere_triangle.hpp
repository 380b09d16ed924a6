// Sphere against triangle: the nearest point of the triangle to the centre, in double.
#pragma once

#include "narrow/pairs/sphere_capsule_triangle_pair.hpp"
#include "simd/flatten.hpp"

namespace graze {

struct SphereTriangle : SphereCapsuleTrianglePair<Sphere> {
  template <class T>
  GRAZE_FLATTEN static std::optional<Distance<T>> distance(const InPlace<Sphere<T>, T>& a,
                                                           const InPlace<Triangle<T>, T>& b) {
    return distance_of<T>(with_triangle(a.shape, a.rounding(), a.pose, b.shape, b.rounding(), b.pose));
  }
  template <class T, class M>
  static std::optional<T> contacts(const InPlace<Sphere<T>, T>& a, const InPlace<Triangle<T>, T>& b, T margin,
                                   M& manifold) {
    return contact_of(with_triangle(a.shape, a.rounding(), a.pose, b.shape, b.rounding(), b.pose), margin, manifold);
  }
};

}  // namespace graze
