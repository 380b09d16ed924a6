// Contacts of many pairs that touch in one point: balls and capsules with each other, with boxes and with triangles, by
// the kernels for them.
//
// Guarantee: for each pair what `convex_contacts` answers, bit for bit.
#pragma once

#include "narrow/box_batch.hpp"
#include "narrow/closed_form.hpp"

namespace graze {

/// The kernel for A and B.
template <class A, class B, class T>
auto round_kernel() {
  if constexpr (is_round_pair<A, B>)
    return GRAZE_KERNEL(chosen_isa(), round_contacts<A, B, T>);
  else if constexpr (std::is_same_v<B, Triangle<T>>)
    return GRAZE_KERNEL(chosen_isa(), round_triangle_contacts<A, T>);
  else
    return GRAZE_KERNEL(chosen_isa(), capsule_box_contacts<T>);
}

template <class T>
PointContact<T> mirrored(const PointContact<T>& c) {
  return {mirrored(c.point), -c.normal};
}

/// Asks about up to `most` pairs of A and B as the kernels take them, in their order: `apart(i)` for those
/// further apart than their margins; for the others `touching(i, contact)`, or, where their faces may give two points or
/// the general path has to answer, `unknown(i)`.
template <class A, class B, std::size_t most = most_chunk, class T, class Apart, class Touching, class Unknown>
void visit_round_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Touching& touching,
                          const Unknown& unknown) {
  PointContact<T> contacts[bundled(most)];
  Meeting meetings[bundled(most)];
  round_kernel<A, B, T>()(pairs, count, contacts, meetings);
  for (std::size_t i = 0; i < count; ++i) {
    if (meetings[i] == Meeting::touching)
      touching(i, contacts[i]);
    else if (meetings[i] == Meeting::unknown)
      unknown(i);
    else
      apart(i);
  }
}

}  // namespace graze
