// The box queries of a hierarchy of bounds over the boxes of a table.
//
// Guarantee: the answers of the interface (`BroadPhase`), whatever the hierarchy. A hierarchy has `for_each(enter,
// see)`, which calls `see(place)` for all boxes except below where `enter(bounds)` refuses.
#pragma once

#include "broad/boxes.hpp"

namespace graze {

/// The sorted ids of all boxes for which `accept(box)` holds, looked for where `enter(bounds)` holds.
template <class T, class Hierarchy, class Enter, class Accept>
void collect(const Hierarchy& hierarchy, const BoxTable<T>& boxes, const Enter& enter, const Accept& accept,
             std::vector<std::uint32_t>& out) {
  out.clear();
  hierarchy.for_each(enter, [&](std::uint32_t place) {
    if (accept(boxes[place].box)) out.push_back(boxes[place].id);
  });
  std::sort(out.begin(), out.end());
}

template <class T, class Hierarchy>
void query(const Hierarchy& hierarchy, const BoxTable<T>& boxes, const Aabb<T>& box, std::vector<std::uint32_t>& out) {
  const auto accept = [&](const Aabb<T>& other) { return overlap(other, box); };
  collect(hierarchy, boxes, accept, accept, out);
}

/// Sweeps a box. The bounds of a node must not be missed where a box in it is just hit: hence a wider box for nodes.
template <class T, class Hierarchy>
void sweep(const Hierarchy& hierarchy, const BoxTable<T>& boxes, const Aabb<T>& box, const Vec3<T>& motion,
           std::vector<std::uint32_t>& out) {
  const SweptBox<T> accept(box, motion);
  const Aabb<T> wide = widened_for_sweep(box, motion);
  if (!has_finite_ends(wide)) return boxes.collect(out, accept);
  collect(hierarchy, boxes, SweptBox<T>(wide, motion), accept, out);
}

}  // namespace graze
