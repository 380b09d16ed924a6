// Contacts of many pairs of triangles, by the kernels for them.
//
// Guarantee: for each pair the answer of `convex_contacts`, bit for bit.
#pragma once

#include "narrow/batch/box_batch.hpp"
#include "narrow/pairs/triangle_triangle/contacts.hpp"

namespace graze {

/// Finds the contacts of up to `most_chunk` pairs of triangles without rounding, as `visit_contacts` does.
template <class T, class Apart, class Met, class Unknown>
void visit_triangle_pair_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Met& met,
                                  const Unknown& unknown) {
  const Isa level = chosen_isa();
  FoundTriangles<T> found[most_chunk];
  GRAZE_KERNEL(level, triangle_pair_distances<T>)(pairs, count, found);
  visit_contacts<T, FoundTriangles<T>>(GRAZE_KERNEL(level, triangle_pair_points<T>), pairs, found, count, apart, met,
                                       unknown);
}

}  // namespace graze
