// Sphere against triangle: the nearest point of the triangle to the centre, in double.
#pragma once

#include "narrow/batch/one_contacts.hpp"
#include "narrow/pairs/pair.hpp"
#include "narrow/pairs/sphere_capsule_triangle_contact.hpp"
#include "simd/flatten.hpp"

namespace graze {

struct SphereTriangle {
  template <class T>
  using A = Sphere<T>;
  template <class T>
  using B = Triangle<T>;

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

  template <class T>
  static auto overlap_rows() {
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_row_overlaps<Sphere<T>, T>);
  }
  template <class T>
  static auto distance_rows() {
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_row_distances<Sphere<T>, T>);
  }
  template <class T>
  static auto contact_rows() {
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_row_contacts<Sphere<T>, T>);
  }
  template <class T>
  static const std::uint32_t* features() {
    return ids_with_triangle.of;
  }
  template <class T, class Sink>
  static void visit_contacts(const PairRef<T>* pairs, std::size_t count, bool turned, Sink& sink) {
    visit_one_contacts<T>(GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_contacts<Sphere<T>, T>), features<T>(),
                          pairs, count, turned, sink);
  }
};

}  // namespace graze
