// Capsule against rectangle, which is a box of zero thickness.
#pragma once

#include "narrow/batch/pair_kernels.hpp"
#include "narrow/pairs/box_box/box_like_pair.hpp"

namespace graze {

struct CapsuleRectangle : BoxLikePair<Capsule, Rectangle> {
  static constexpr bool overlaps_by_distance = true;

  template <class T>
  static std::optional<Distance<T>> distance(const InPlace<Capsule<T>, T>& a, const InPlace<Rectangle<T>, T>& b) {
    if (const auto found = BoxLikePair::distance(a, b)) return found;
    return closed_form_distance(a, b);
  }

  template <class T>
  static auto overlap_rows() {
    return GRAZE_KERNEL(chosen_isa(), box_like_row_overlaps<Capsule<T>, Rectangle<T>, T>);
  }
  template <class T>
  static auto distance_rows() {
    return GRAZE_KERNEL(chosen_isa(), box_row_distances<Capsule<T>, Rectangle<T>, T>);
  }
};

}  // namespace graze
