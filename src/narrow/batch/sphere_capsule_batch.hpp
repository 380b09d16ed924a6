// Contacts of many pairs that touch in one point, or in two where capsules lie: balls and capsules with each other,
// with boxes and with triangles, by the kernels for them.
//
// Guarantee: for each pair what `convex_contacts` answers, bit for bit.
#pragma once

#include "narrow/batch/box_batch.hpp"
#include "narrow/pairs/sphere_capsule_contacts.hpp"

namespace graze {

/// The kernel for A and B; `sides` gets those of capsules that lie, one behind the other.
template <class A, class B, class T>
void ask_sphere_capsule_kernel(const PairRef<T>* pairs, std::size_t count, PointContact<T>* contacts, Meeting* meetings,
                               SegmentContact<T>* sides) {
  const Isa level = chosen_isa();
  if constexpr (is_sphere_capsule_pair<A, B>)
    GRAZE_KERNEL(level, sphere_capsule_contacts<A, B, T>)(pairs, count, contacts, meetings, sides);
  else if constexpr (std::is_same_v<B, Triangle<T>>)
    GRAZE_KERNEL(level, sphere_capsule_triangle_contacts<A, T>)(pairs, count, contacts, meetings, sides);
  else
    GRAZE_KERNEL(level, capsule_box_contacts<T>)(pairs, count, contacts, meetings, sides);
}

template <class T>
PointContact<T> mirrored(const PointContact<T>& c) {
  return {mirrored(c.point), -c.normal};
}

/// Calls `lying(i, distance, normal, points)`, or `unknown(i)` where nothing is known.
template <class A, class B, class T, class Lying, class Unknown>
void visit_side(const SegmentContact<T>& found, bool turned, std::size_t i, const Lying& lying, Unknown&& unknown) {
  if (found.filled == T(0)) return unknown(i);
  const SegmentPoints<T> points{found, round_feature_ids<B, T>().of, turned};
  lying(i, found.distance, points.normal(), points);
}

/// Asks about up to `most` pairs of A and B as the kernels take them, in their order: `apart(i)` for those
/// further apart than their margins; for the others `touching(i, contact)`, or, where a capsule lies,
/// `lying(i, distance, normal, points)`, the last `SegmentPoints`, or `unknown(i)`. `turned`: A is the second of the
/// two for whoever asks, as the points of those that lie are told.
template <class A, class B, std::size_t most = most_chunk, class T, class Apart, class Touching, class Lying,
          class Unknown>
void visit_sphere_capsule_contacts(const PairRef<T>* pairs, std::size_t count, bool turned, const Apart& apart,
                                   const Touching& touching, const Lying& lying, const Unknown& unknown) {
  PointContact<T> contacts[bundled(most)];
  Meeting meetings[bundled(most)];
  RoomFor<SegmentContact<T>, most> sides;
  ask_sphere_capsule_kernel<A, B>(pairs, count, contacts, meetings, sides.records);
  const SegmentContact<T>* side = sides.records;
  for (std::size_t i = 0; i < count; ++i) {
    if (meetings[i] == Meeting::touching)
      touching(i, contacts[i]);
    else if (meetings[i] == Meeting::lying)
      visit_side<A, B>(*side++, turned, i, lying, unknown);
    else if (meetings[i] == Meeting::unknown)
      unknown(i);
    else
      apart(i);
  }
}

}  // namespace graze
