// The common part of pairs that touch in one point, or in two where capsules lie side by side: spheres and untapered
// capsules with each other, and spheres with boxes.
#pragma once

#include "narrow/batch/one_contacts.hpp"
#include "narrow/pairs/sphere_capsule_contacts.hpp"

namespace graze {

template <template <class> class KindA, template <class> class KindB>
struct OneContactPair : ClosedFormPair<KindA, KindB> {
  static constexpr bool closed_form_rows = true, one_contact_kernels = true;

  template <class T>
  static std::optional<Distance<T>> distance(const InPlace<KindA<T>, T>& a, const InPlace<KindB<T>, T>& b) {
    if (!has_core(a.shape) || !has_core(b.shape)) return std::nullopt;
    const auto pair =
        sphere_capsule_pair(rounded_core(a.shape, a.rounding()), a.pose, rounded_core(b.shape, b.rounding()), b.pose);
    const CoreDistance<T> d = pair.in_world(pair.core(pair.nearest()));
    return Distance<T>{d.distance, d.normal, d.a, d.b};
  }
  template <class T, class M>
  static std::optional<T> contacts(const InPlace<KindA<T>, T>& a, const InPlace<KindB<T>, T>& b, T margin,
                                   M& manifold) {
    return regular_contact(a, b, margin, manifold);
  }

  template <class T>
  static auto overlap_rows() {
    return GRAZE_KERNEL(chosen_isa(), row_overlaps<KindA<T>, KindB<T>, T>);
  }
  template <class T>
  static auto distance_rows() {
    return GRAZE_KERNEL(chosen_isa(), row_distances<KindA<T>, KindB<T>, T>);
  }
  template <class T>
  static auto contact_rows() {
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_row_contacts<KindA<T>, KindB<T>, T>);
  }
  template <class T>
  static const std::uint32_t* features() {
    return feature_ids_with(static_cast<const KindB<T>*>(nullptr)).of;
  }
  template <class T, class Sink>
  static void visit_contacts(const PairRef<T>* pairs, std::size_t count, bool turned, Sink& sink) {
    visit_one_contacts<T>(GRAZE_KERNEL(chosen_isa(), sphere_capsule_contacts<KindA<T>, KindB<T>, T>), features<T>(),
                          pairs, count, turned, sink);
  }
};

}  // namespace graze
