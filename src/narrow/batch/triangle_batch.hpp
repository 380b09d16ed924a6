// Contacts of many pairs of triangles, by the kernels for them.
//
// Guarantee: for each pair what `convex_contacts` answers, bit for bit.
#pragma once

#include "narrow/batch/box_batch.hpp"
#include "narrow/core/pair_order.hpp"
#include "narrow/pairs/triangle_triangle/contacts.hpp"

namespace graze {

/// Whether contacts are those of the two in the other order (`pair_order`): by where they stand or, of two in one
/// place, as of a mesh, by the sum of their corners.
template <class T>
bool triangles_swapped(const Triangle<T>& a, const Pose<T>& pose_a, const Triangle<T>& b, const Pose<T>& pose_b) {
  const T rise = pair_rise<T>(pose_a.translation, pose_b.translation);
  if (rise != T(0)) return rise < T(0);
  const auto sum = [](const Triangle<T>& t) { return t.point(0) + t.point(1) + t.point(2); };
  return pair_rise<T>(sum(a), sum(b)) < T(0);
}

/// Asks about up to `most_chunk` pairs of triangles without a margin, as `visit_contacts` does.
template <class T, class Apart, class Met, class Unknown>
void visit_triangle_pair_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Met& met,
                                  const Unknown& unknown) {
  const Isa level = chosen_isa();
  PairRef<T> ordered[most_chunk];
  bool swapped[most_chunk];
  for (std::size_t i = 0; i < count; ++i) {
    const PairRef<T>& p = pairs[i];
    swapped[i] = triangles_swapped(*static_cast<const Triangle<T>*>(p.a), *p.pose_a,
                                   *static_cast<const Triangle<T>*>(p.b), *p.pose_b);
    // Nobody foresees the order, so nothing is jumped for.
    const void* const shapes[2] = {p.a, p.b};
    const Pose<T>* const poses[2] = {p.pose_a, p.pose_b};
    ordered[i] = {shapes[swapped[i]], shapes[!swapped[i]], poses[swapped[i]], poses[!swapped[i]], p.margin};
  }
  FoundTriangles<T> found[most_chunk];
  GRAZE_KERNEL(level, triangle_pair_distances<T>)(ordered, count, found);
  for (std::size_t i = 0; i < count; ++i) found[i].swapped = swapped[i];
  visit_contacts<T, FoundTriangles<T>>(GRAZE_KERNEL(level, triangle_pair_points<T>), ordered, found, count, apart, met,
                                       unknown);
}

}  // namespace graze
