// Pairs of round shapes, and of balls with boxes, in rows.
#include "narrow/contact_rows.hpp"
#include "narrow/pairs/round_contacts.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// The names of parts.
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

/// The names of what touches of A and B.
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
      return named<T>(box_part_names.of, c.part_b);
    else
      return named<T>(round_part_names.of, c.part_b);
  };
  return of_a() << 16 | of_b();
}

}  // namespace

template <class A, class B, class T>
[[gnu::flatten]] void round_row_contacts(const PairRows<T>& rows, std::size_t count, T margin, bool turned,
                                         const ContactRows<T>& to, RowCounts& all_found) {
  using S = Lanes<T>;
  constexpr std::size_t lanes = lanes_of<T>;
  RowCounts counts{0, 0};
  for (std::size_t first = 0; first < count; first += lanes) {
    const RowBundle<A, B, T> p(rows, first);
    const RoundContact<S> c = round_contact(p.a.shapes, p.pose_a, p.b.shapes, p.pose_b, S(margin));
    const std::uint32_t near = Chosen<T>::at_most(c.at.distance, S(margin)).bits() & filled_lanes<T>(count - first);
    std::uint32_t touching = near, unknown = 0;
    if constexpr (!std::is_same_v<A, Sphere<T>> || !std::is_same_v<B, Sphere<T>>) {
      const std::uint32_t regular = bits_of(p.regular());
      touching &= Chosen<T>::not_less(c.known, S(1)).bits() & regular;
      unknown = (near & ~touching) | (~regular & filled_lanes<T>(count - first));
    }
    LaneContacts<T> found{c.at, features_of<A, B, T>(c), S(T(0.5))};
    if constexpr (std::is_same_v<A, Sphere<T>> && std::is_same_v<B, Sphere<T>>)
      found.weight = ball_weight(p.a.shapes.radius, p.b.shapes.radius);
    if (turned) found = found.mirrored();
    put(found, touching, unknown, first, least(lanes, count - first), to, counts);
  }
  all_found = counts;
}

#define GRAZE_INSTANTIATE_FOR(A, B, T)                                                                                 \
  template void round_row_contacts<A<T>, B<T>>(const PairRows<T>&, std::size_t, T, bool, const ContactRows<T>&,        \
                                               RowCounts&);
#define GRAZE_INSTANTIATE(A, B)                                                                                        \
  GRAZE_INSTANTIATE_FOR(A, B, float)                                                                                   \
  GRAZE_INSTANTIATE_FOR(A, B, double)
GRAZE_FOR_ROUND_PAIRS(GRAZE_INSTANTIATE)
#undef GRAZE_INSTANTIATE
#undef GRAZE_INSTANTIATE_FOR

}  // namespace graze::GRAZE_ISA
