// Sphere against sphere, with an overlap test without a root.
#pragma once

#include "narrow/pairs/one_contact_pair.hpp"

namespace graze {

struct SphereSphere : OneContactPair<Sphere, Sphere> {
  static constexpr bool overlaps_by_distance = false;

  template <class T>
  static std::optional<bool> overlap(const InPlace<Sphere<T>, T>& a, const InPlace<Sphere<T>, T>& b) {
    const auto pair =
        sphere_capsule_pair(rounded_core(a.shape, a.rounding()), a.pose, rounded_core(b.shape, b.rounding()), b.pose);
    return spheres_overlap(pair.a.point, a.radius(), pair.b.point, b.radius());
  }
};

}  // namespace graze
