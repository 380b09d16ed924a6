// Results of lanes for a sphere or capsule and another shape, as rows of a batch's answer. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/batch/contact_rows.hpp"
#include "narrow/pairs/sphere_capsule_contacts.hpp"

namespace graze::GRAZE_ISA {

/// The features of parts, by lane.
template <class T, std::size_t size>
[[gnu::always_inline]] inline typename Lanes<T>::BitVector named(const std::uint32_t (&names)[size],
                                                                 const Lanes<T>& parts) {
  const auto places = __builtin_convertvector(parts.v, typename Lanes<T>::BitVector);
  if constexpr (sizeof(T) == 4) {
    return looked_up(names, places);
  } else {
    typename Lanes<T>::BitVector found{};
    for (int i = 0; i < lanes_of<T>; ++i) found[i] = names[places[i]];
    return found;
  }
}

/// The feature numbers of A and B together.
template <class A, class B, class T>
[[gnu::always_inline]] inline typename Lanes<T>::BitVector features_of(const RoundContact<Lanes<T>>& c) {
  using Whole = typename Lanes<T>::BitVector;
  const auto of_a = [&]() __attribute__((always_inline)) {
    if constexpr (std::is_same_v<A, Sphere<T>>)
      return Whole{} + static_cast<typename Lanes<T>::Bits>(vertex_feature(0));
    else
      return named<T>(round_part_names.of, c.part_a);
  };
  const auto of_b = [&]() __attribute__((always_inline)) {
    if constexpr (std::is_same_v<B, Sphere<T>>)
      return Whole{} + static_cast<typename Lanes<T>::Bits>(vertex_feature(0));
    else if constexpr (std::is_same_v<B, Box<T>>)
      return named<T>(box_features.of, c.part_b);
    else if constexpr (std::is_same_v<B, Triangle<T>>)
      return named<T>(triangle_part_names.of, c.part_b);
    else
      return named<T>(round_part_names.of, c.part_b);
  };
  return of_a() << 16 | of_b();
}

/// Writes the lanes that hold a pair, the first of which is the `first`-th of `count`, and adds to the counts.
/// `put_lying(bits, sides)` writes the contacts of capsules on their sides, one behind the other.
template <class A, class B, class T, class PutLying>
[[gnu::always_inline]] inline void
put_rows(const RowBundle<A, B, T>& p, const RoundContact<Lanes<T>>& c, const Lanes<T>& weight, T margin, bool turned,
         std::size_t first, std::size_t count, const ContactRows<T>& to, RowCounts& counts, const PutLying& put_lying) {
  using S = Lanes<T>;
  constexpr std::size_t lanes = lanes_of<T>;
  const std::uint32_t filled = filled_lanes<T>(count - first),
                      near = Chosen<T>::at_most(c.at.distance, S(margin)).bits() & filled;
  std::uint32_t touching = near, unknown = 0;
  if constexpr (!std::is_same_v<A, Sphere<T>> || !std::is_same_v<B, Sphere<T>>) {
    const std::uint32_t regular = bits_of(p.regular());
    touching &= Chosen<T>::not_less(c.known, S(1)).bits() & regular;
    unknown = ~regular & filled;
    std::uint32_t others = near & regular & ~touching;
    if constexpr (std::is_same_v<A, Capsule<T>>) {
      const std::uint32_t lying = others & Chosen<T>::not_less(c.known, S(0)).bits();
      if (lying != 0) {
        put_lying(lying, to.sides + counts.sides);
        append_places(lying, first, to.side_places, counts.sides);
        others &= ~lying;
      }
    }
    unknown |= others;
  }
  LaneContacts<T> found{c.at, features_of<A, B, T>(c), weight};
  if (turned) found = found.mirrored();
  put(found, touching, unknown, first, least(lanes, count - first), to, counts);
}

}  // namespace graze::GRAZE_ISA
