// Contacts of many pairs of balls by the kernel for them.
//
// Guarantee: for each pair what `convex_contacts` answers, bit for bit.
#pragma once

#include "narrow/box_batch.hpp"
#include "narrow/pairs/round_contacts.hpp"

namespace graze {

/// The shape as a sphere without rounding beside its own radius; null if it is not.
template <class T>
const Sphere<T>* plain_ball(const Shape<T>& shape) {
  return shape.margin() == T(0) ? shape.template as<Sphere<T>>() : nullptr;
}

/// Asks about up to `box_chunk` pairs of plain balls, in their order: `apart(i)` for those further apart than their
/// margins, for the others `touching(i, normal, point)`.
template <class T, class Apart, class Touching>
void visit_ball_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Touching& touching) {
  Distance<T> contacts[box_chunk];
  GRAZE_KERNEL(chosen_isa(), closed_distances<Sphere<T>, Sphere<T>, T>)(pairs, count, contacts);
  const auto radius = [](const void* ball) { return static_cast<const Sphere<T>*>(ball)->radius(); };
  for (std::size_t i = 0; i < count; ++i) {
    const Distance<T>& d = contacts[i];
    if (d.distance <= pairs[i].margin)
      touching(
          i, d.normal,
          ContactPoint<T>{d.a, d.b, d.distance, ball_feature, ball_weight(radius(pairs[i].a), radius(pairs[i].b))});
    else
      apart(i);
  }
}

}  // namespace graze
