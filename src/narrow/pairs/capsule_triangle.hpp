// Capsule against triangle: an end of an untapered capsule, or its side across an edge or on the face of the triangle,
// in double.
#pragma once

#include "narrow/pairs/sphere_capsule_triangle_pair.hpp"
#include "simd/flatten.hpp"

namespace graze {

struct CapsuleTriangle : SphereCapsuleTrianglePair<Capsule> {
  template <class T>
  GRAZE_FLATTEN static std::optional<Distance<T>> distance(const InPlace<Capsule<T>, T>& a,
                                                           const InPlace<Triangle<T>, T>& b) {
    if (!has_untapered_side(a.shape)) return std::nullopt;
    return distance_of<T>(with_triangle(a.shape, a.rounding(), a.pose, b.shape, b.rounding(), b.pose));
  }
  template <class T, class M>
  static std::optional<T> contacts(const InPlace<Capsule<T>, T>& a, const InPlace<Triangle<T>, T>& b, T margin,
                                   M& manifold) {
    if (!has_untapered_side(a.shape)) return std::nullopt;
    return contact_of(with_triangle(a.shape, a.rounding(), a.pose, b.shape, b.rounding(), b.pose), margin, manifold);
  }
  template <class T, class M>
  static std::optional<T> more_contacts(const InPlace<Capsule<T>, T>& a, const InPlace<Triangle<T>, T>& b, T margin,
                                        M& manifold) {
    const auto of = rounded_core(a.shape, a.rounding());
    const auto found = side_contact(
        Rounded<AxisCore<double>, double>{{static_cast<double>(of.core.half_height)}, static_cast<double>(of.radius)},
        converted<double>(a.pose), rounded_in_double(b.shape, b.rounding()), converted<double>(b.pose),
        converted<double>(take_closest(manifold)), static_cast<double>(margin), true, answer_rounding<T>());
    return put_sides(converted<T>(found), ids_with_triangle, manifold);
  }
};

}  // namespace graze
