// Capsule against rectangle: as against a box of no thickness.
#pragma once

#include "narrow/pairs/box_box/box_like_pair.hpp"

namespace graze {

struct CapsuleRectangle : BoxLikePair<Capsule, Rectangle> {
  static constexpr bool overlaps_by_distance = true;

  template <class T>
  static std::optional<Distance<T>> distance(const InPlace<Capsule<T>, T>& a, const InPlace<Rectangle<T>, T>& b) {
    if (const auto found = BoxLikePair::distance(a, b)) return found;
    return closed_form_distance(a, b);
  }
};

}  // namespace graze
