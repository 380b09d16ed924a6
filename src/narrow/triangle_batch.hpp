// Contacts of many pairs of triangles: which of them are apart, by the kernel for that.
//
// Guarantee: of a pair that is told apart `convex_contacts` finds no contact.
#pragma once

#include "narrow/box_batch.hpp"

namespace graze {

/// Asks about up to `most_chunk` pairs of triangles without a margin, in their order: `apart(i)` for those that are known
/// to be further apart than their margins, `unknown(i)` for the others.
template <class T, class Apart, class Unknown>
void visit_triangle_pair_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart,
                                  const Unknown& unknown) {
  std::uint8_t far[most_chunk];
  GRAZE_KERNEL(chosen_isa(), triangle_pairs_apart<T>)(pairs, count, far);
  for (std::size_t i = 0; i < count; ++i) far[i] != 0 ? apart(i) : unknown(i);
}

}  // namespace graze
