// Capsule against capsule: the nearest points of two segments, or two points for capsules side by side.
#pragma once

#include "narrow/pairs/one_contact_pair.hpp"

namespace graze {

struct CapsuleCapsule : OneContactPair<Capsule, Capsule> {
  template <class T, class M>
  static std::optional<T> more_contacts(const InPlace<Capsule<T>, T>& a, const InPlace<Capsule<T>, T>& b, T margin,
                                        M& manifold) {
    const CoreDistance<T> closest = take_closest(manifold);
    return put_sides(side_contact(rounded_core(a.shape, a.rounding()), a.pose, rounded_core(b.shape, b.rounding()),
                                  b.pose, closest, margin),
                     ids_with_sphere_capsule, manifold);
  }
};

}  // namespace graze
