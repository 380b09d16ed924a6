// Pairs of shapes that the box routines answer: boxes, rectangles, which are boxes of zero thickness, and untapered
// capsules, which are rounded boxes with a length along one axis only.
#pragma once

#include <optional>

#include "narrow/pairs/box_box/distance.hpp"
#include "narrow/pairs/closed_form_pair.hpp"

namespace graze {

template <template <class> class KindA, template <class> class KindB>
struct BoxLikePair : PairOfKinds<KindA, KindB> {
  /// The signed distance by the boxes' axes and corners; nothing where these do not prove it.
  template <class T>
  static std::optional<Distance<T>> distance(const InPlace<KindA<T>, T>& a, const InPlace<KindB<T>, T>& b) {
    if (!has_core(a.shape) || !has_core(b.shape)) return std::nullopt;
    const auto found = box_distance(placed(a), placed(b));
    if (!found.proven) return std::nullopt;
    return rounded<T>(found.at);
  }

 private:
  template <class C, class T>
  static PlacedBox<double> placed(const InPlace<C, T>& box) {
    return converted<double>(placed_box(rounded_core(box.shape, box.rounding()), box.pose));
  }
};

}  // namespace graze
