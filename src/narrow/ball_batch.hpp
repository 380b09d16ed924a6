// Contacts of many pairs of balls by the kernel for them.
//
// Guarantee: for each pair what `convex_contacts` answers, bit for bit.
#pragma once

#include "narrow/box_batch.hpp"

namespace graze {

/// The shape as a sphere without rounding beside its own radius; null if it is not.
template <class T>
const Sphere<T>* plain_ball(const Shape<T>& shape) {
  return shape.margin() == T(0) ? shape.template as<Sphere<T>>() : nullptr;
}

/// Asks about up to `most_chunk` pairs of plain balls, in their order: `apart(i)` for those further apart than their
/// margins, for the others `touching(i, normal, point)`.
template <class T, class Apart, class Touching>
void visit_ball_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Touching& touching) {
  PointContact<T> contacts[most_chunk];
  Meeting meetings[most_chunk];
  GRAZE_KERNEL(chosen_isa(), round_contacts<Sphere<T>, Sphere<T>, T>)(pairs, count, contacts, meetings);
  for (std::size_t i = 0; i < count; ++i) {
    if (meetings[i] == Meeting::touching)
      touching(i, contacts[i].normal, contacts[i].point);
    else
      apart(i);
  }
}

}  // namespace graze
