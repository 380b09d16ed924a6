// Box or rectangle against rectangle, which is a box of zero thickness.
#pragma once

#include "narrow/batch/pair_kernels.hpp"
#include "narrow/pairs/box_box/any_boxes_overlap.hpp"
#include "narrow/pairs/box_box/box_like_pair.hpp"

namespace graze {

template <template <class> class Kind>
struct BoxRectangle : BoxLikePair<Kind, Rectangle> {
  template <class T>
  static std::optional<bool> overlap(const InPlace<Kind<T>, T>& a, const InPlace<Rectangle<T>, T>& b) {
    return detail::any_boxes_overlap(a, b, false);
  }

  template <class T>
  static auto distance_rows() {
    return GRAZE_KERNEL(chosen_isa(), box_row_distances<Kind<T>, Rectangle<T>, T>);
  }
};

}  // namespace graze
