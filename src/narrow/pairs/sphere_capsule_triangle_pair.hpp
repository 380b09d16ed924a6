// The common part of spheres and capsules with triangles: their kernels.
#pragma once

#include "narrow/batch/one_contacts.hpp"
#include "narrow/pairs/pair.hpp"
#include "narrow/pairs/sphere_capsule_triangle_contact.hpp"

namespace graze {

template <template <class> class Kind>
struct SphereCapsuleTrianglePair : PairOfKinds<Kind, Triangle> {
  template <class T>
  static auto overlap_rows() {
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_row_overlaps<Kind<T>, T>);
  }
  template <class T>
  static auto distance_rows() {
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_row_distances<Kind<T>, T>);
  }
  template <class T>
  static auto contact_rows() {
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_row_contacts<Kind<T>, T>);
  }
  template <class T>
  static const std::uint32_t* features() {
    return ids_with_triangle.of;
  }
  template <class T, class Sink>
  static void visit_contacts(const PairRef<T>* pairs, std::size_t count, bool turned, Sink& sink) {
    visit_one_contacts<T>(GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_contacts<Kind<T>, T>), features<T>(),
                          pairs, count, turned, sink);
  }
};

}  // namespace graze
