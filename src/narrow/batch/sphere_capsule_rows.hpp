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

/// The features of parts of the shapes of a kind, by lane; a ball has one part.
template <class C, class T>
[[gnu::always_inline]] inline typename Lanes<T>::BitVector features_of(const C* kind, const Lanes<T>& parts) {
  return named<T>(part_names_of(kind), parts);
}
template <class T>
[[gnu::always_inline]] inline typename Lanes<T>::BitVector features_of(const Sphere<T>*, const Lanes<T>&) {
  return typename Lanes<T>::BitVector{} + static_cast<typename Lanes<T>::Bits>(vertex_feature(0));
}

/// Writes the lanes that hold a pair, the first of which is the `first`-th of `count`, and adds to the counts.
/// `put_lying(bits, sides)` writes the contacts of capsules on their sides, one behind the other.
template <class A, class B, class T, class PutLying>
[[gnu::always_inline]] inline void
put_rows(const RowBundle<A, B, T>& p, const OneContact<Lanes<T>>& c, const Lanes<T>& weight, T margin, bool turned,
         std::size_t first, std::size_t count, const ContactRows<T>& to, RowCounts& counts, const PutLying& put_lying) {
  using S = Lanes<T>;
  constexpr std::size_t lanes = lanes_of<T>;
  const std::uint32_t filled = filled_lanes<T>(count - first),
                      near = Chosen<T>::at_most(c.at.distance, S(margin)).bits() & filled;
  std::uint32_t touching = near, unknown = 0;
  if constexpr (!always_one_point<A, B>) {
    const std::uint32_t regular = bits_of(p.regular());
    touching &= Chosen<T>::not_less(c.known, S(1)).bits() & regular;
    unknown = ~regular & filled;
    std::uint32_t others = near & regular & ~touching;
    if constexpr (lies_on_sides<A>) {
      const std::uint32_t lying = others & Chosen<T>::not_less(c.known, S(0)).bits();
      if (lying != 0) {
        put_lying(lying, to.sides + counts.sides);
        append_places(lying, first, to.side_places, counts.sides);
        others &= ~lying;
      }
    }
    unknown |= others;
  }
  LaneContacts<T> found{c.at,
                        features_of(static_cast<const A*>(nullptr), c.part_a) << 16 |
                            features_of(static_cast<const B*>(nullptr), c.part_b),
                        weight};
  if (turned) found = found.mirrored();
  put(found, touching, unknown, first, least(lanes, count - first), to, counts);
}

}  // namespace graze::GRAZE_ISA
