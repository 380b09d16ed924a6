// Pairs of round shapes, and of balls with boxes, a bundle at a time.
#include "narrow/pair_bundle.hpp"
#include "narrow/pairs/round_contacts.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// Whole numbers of lanes, as such.
template <class T>
using Whole = typename Lanes<T>::BitVector;
template <class T>
struct ByteVector {
  typedef std::uint8_t type __attribute__((vector_size(lanes_of<T>)));
};
template <class T>
using Bytes = typename ByteVector<T>::type;
template <class S>
[[gnu::always_inline]] inline auto whole(const S& numbers) {
  return __builtin_convertvector(numbers.v, typename S::BitVector);
}

/// Writes all lanes.
template <class T>
[[gnu::always_inline]] inline void put(const CoreDistance<Lanes<T>>& d, const std::uint32_t* features,
                                       const Lanes<T>& weight, PointContact<T>* to) {
  if constexpr (sizeof(T) == 4) {
    using Point = ContactPoint<T>;
    static_assert(sizeof(PointContact<T>) == 48 && offsetof(Point, b) == 12 && offsetof(Point, distance) == 24 &&
                  offsetof(Point, feature) == 28 && offsetof(Point, weight) == 32 && sizeof(Point) == 36);
    char* const rows = reinterpret_cast<char*>(to);
    Lanes<T> names;
    std::memcpy(&names.v, features, sizeof names.v);
    scatter(d.a.x, d.a.y, d.a.z, d.b.x, rows, sizeof *to);
    scatter(d.b.y, d.b.z, d.distance, names, rows + 16, sizeof *to);
    scatter(weight, d.normal.x, d.normal.y, d.normal.z, rows + 32, sizeof *to);
  } else {
    for (std::size_t k = 0; k < lanes_of<T>; ++k) {
      const int i = static_cast<int>(k);
      to[k] = {{lane<T>(d.a, i), lane<T>(d.b, i), d.distance[i], features[k], weight[i]}, lane<T>(d.normal, i)};
    }
  }
}

}  // namespace

template <class A, class B, class T>
[[gnu::flatten]] void round_contacts(const PairRef<T>* pairs, std::size_t count, PointContact<T>* contacts,
                                     Meeting* meetings) {
  using S = Lanes<T>;
  using Pairs = PairBundle<A, B, T>;
  constexpr bool balls = std::is_same_v<A, Sphere<T>> && std::is_same_v<B, Sphere<T>>;
  for (std::size_t first = 0; first < count; first += Pairs::lanes) {
    const Pairs p(pairs + first, count - first);
    const RoundContact<S> c = round_contact(p.a, p.pose_a, p.b, p.pose_b, p.margin);
    const S meeting = select(c.at.distance <= p.margin, select(c.known == S(0), S(2), S(1)), S(0));
    const Whole<T> met = whole(meeting), place = whole(feature_place(c));
    std::uint32_t features[Pairs::lanes];
    for (std::size_t k = 0; k < Pairs::lanes; ++k)
      features[k] = balls ? ball_feature : round_feature_ids<B, T>().of[static_cast<std::size_t>(place[k])];
    const auto bytes = __builtin_convertvector(met, Bytes<T>);
    std::memcpy(meetings + first, &bytes, sizeof bytes);
    S weight(T(0.5));
    if constexpr (balls) weight = ball_weight(p.a.radius, p.b.radius);
    put<T>(c.at, features, weight, contacts + first);
  }
}

#define GRAZE_INSTANTIATE(A, B)                                                                                        \
  template void round_contacts<A<float>, B<float>>(const PairRef<float>*, std::size_t, PointContact<float>*,           \
                                                   Meeting*);                                                          \
  template void round_contacts<A<double>, B<double>>(const PairRef<double>*, std::size_t, PointContact<double>*,       \
                                                     Meeting*);
GRAZE_FOR_ROUND_PAIRS(GRAZE_INSTANTIATE)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
