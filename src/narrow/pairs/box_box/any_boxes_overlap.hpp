// The overlap test of two boxes or rectangles of any size and rounding, in double.
#pragma once

#include <optional>

#include "narrow/core/relative_frame.hpp"
#include "narrow/general.hpp"
#include "narrow/pairs/box_box/overlap.hpp"
#include "narrow/pairs/pair.hpp"
#include "simd/flatten.hpp"

namespace graze {

namespace detail {

/// Whether boxes of any size and rounding touch, from their separating axes, or only those of faces; nothing where
/// their rounding radii may bridge a gap that no axis measures.
template <class A, class B, class T>
[[gnu::noinline]] GRAZE_FLATTEN std::optional<bool> any_boxes_overlap(const InPlace<A, T>& a, const InPlace<B, T>& b,
                                                                      bool faces_only) {
  using Row = Packed<double, 3>;
  const ScaledBoxes<double> boxes(Row(converted<double>(core_of(a.shape).half)), PoseRows<double>(in_double(a.pose)),
                                  Row(converted<double>(core_of(b.shape).half)), PoseRows<double>(in_double(b.pose)));
  const Row& between = boxes.rows.translation;
  const double reach = static_cast<double>(a.rounding()) + static_cast<double>(b.rounding());
  const auto size = [](const auto& box) {
    return static_cast<double>(box.shape.core_extent()) + static_cast<double>(box.radius());
  };
  const double noise = noise_of(greatest(size(a), size(b)), Vec3d{between[0], between[1], between[2]} / boxes.scale);
  if (boxes_apart(boxes, (reach + noise) * boxes.scale, faces_only)) return false;
  if (faces_only || reach == 0 || !boxes_apart(boxes, noise * boxes.scale)) return true;
  return std::nullopt;
}

}  // namespace detail

}  // namespace graze
