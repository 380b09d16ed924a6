// Boxes, and capsules as boxes with a length along one axis, a register of pairs at a time in double.
#include "narrow/batch/pair_bundle.hpp"
#include "narrow/pairs/box_box/distance_lanes.hpp"
#include "narrow/pairs/capsule_box.hpp"
#include "narrow/pairs/segment_lanes.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;

/// The numbers rounded to T, still in double.
template <class T>
[[gnu::always_inline]] inline S rounded_to(const S& x) {
  if constexpr (sizeof(T) == 8) return x;
  typedef T Few __attribute__((vector_size(lanes_of<double> * sizeof(T))));
  return S::of(__builtin_convertvector(__builtin_convertvector(x.v, Few), S::Vector));
}
template <class T>
[[gnu::always_inline]] inline Vec3<S> rounded_to(const Vec3<S>& v) {
  return {rounded_to<T>(v.x), rounded_to<T>(v.y), rounded_to<T>(v.z)};
}
template <class T>
[[gnu::always_inline]] inline CoreDistance<S> rounded_to(const CoreDistance<S>& d) {
  return {rounded_to<T>(d.distance), rounded_to<T>(d.normal), rounded_to<T>(d.a), rounded_to<T>(d.b)};
}

}  // namespace

template <class T>
[[gnu::flatten]] void capsule_box_contacts(const PairRef<T>* pairs, std::size_t count, PointContact<T>* contacts,
                                           Meeting* meetings, SegmentContact<T>* sides) {
  using Pairs = PairBundle<Capsule<T>, Box<T>, T>;
  for (std::size_t first = 0; first < count; first += Pairs::lanes) {
    const Pairs p(pairs + first, count - first);
    visit_parts<T>(p.count, [&](auto part) {
      const PlacedBox<S> a = in_double<part>(placed_box(p.a, p.pose_a)), b = in_double<part>(placed_box(p.b, p.pose_b));
      const S margin = lanes_in_double<part>(p.margin);
      BoxDistance<S> found;
      answer(a, b, found);
      const OneContact<S> c = capsule_box_contact(a, b, found, before_rounding<T>(margin));
      const S place = feature_place(c.part_a, c.part_b);
      const std::size_t begin = first + part * lanes_of<double>, end = first + p.count;
      std::uint32_t lying = 0;
      for (std::size_t k = begin; k < end && k < begin + lanes_of<double>; ++k) {
        const int i = static_cast<int>(k - begin);
        const T distance = static_cast<T>(c.at.distance[i]);
        contacts[k] = {{lane<T>(c.at.a, i), lane<T>(c.at.b, i), distance,
                        ids_with_box.of[static_cast<std::size_t>(place[i])], T(0.5)},
                       lane<T>(c.at.normal, i)};
        meetings[k] = c.known[i] < 0                   ? Meeting::unknown
                      : !(distance <= pairs[k].margin) ? Meeting::apart
                      : c.known[i] > 0                 ? Meeting::touching
                                                       : Meeting::lying;
        lying |= std::uint32_t{meetings[k] == Meeting::lying} << i;
      }
      if (lying == 0) return;
      put_sides(side_contact<T>(a, b, rounded_to<T>(c.at), margin), lying, sides);
      sides += count_bits(lying);
    });
  }
}

#define GRAZE_INSTANTIATE(A, T)                                                                                        \
  template std::uint32_t box_row_distances<A<T>, Box<T>>(const PairRows<T>&, std::size_t, bool, Distance<T>*,          \
                                                         std::uint8_t*);
GRAZE_INSTANTIATE(Box, float)
GRAZE_INSTANTIATE(Box, double)
GRAZE_INSTANTIATE(Capsule, float)
GRAZE_INSTANTIATE(Capsule, double)
#undef GRAZE_INSTANTIATE
template std::uint32_t box_like_row_overlaps<Capsule<float>, Box<float>>(const PairRows<float>&, std::size_t,
                                                                         std::uint8_t*, std::uint8_t*);
template std::uint32_t box_like_row_overlaps<Capsule<double>, Box<double>>(const PairRows<double>&, std::size_t,
                                                                           std::uint8_t*, std::uint8_t*);
template void capsule_box_contacts(const PairRef<float>*, std::size_t, PointContact<float>*, Meeting*,
                                   SegmentContact<float>*);
template void capsule_box_contacts(const PairRef<double>*, std::size_t, PointContact<double>*, Meeting*,
                                   SegmentContact<double>*);

}  // namespace graze::GRAZE_ISA
