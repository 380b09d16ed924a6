#include "narrow/pair_bundle.hpp"
#include "narrow/pairs/box_rest.hpp"
#include "narrow/pairs/round_rest.hpp"
#include "narrow/pairs/triangle_rest.hpp"

namespace graze::GRAZE_ISA {

template <class A, class T>
[[gnu::flatten]] void rests(const PairRef<T>* pairs, std::size_t count, RestBlock<T>& block) {
  using S = Lanes<T>;
  using Pairs = PairBundle<A, HalfSpace<T>, T>;
  static_assert(sizeof block.slots / sizeof block.slots[0] == most_rest_points);
  for (std::size_t first = 0; first < count; first += Pairs::lanes) {
    const Pairs p(pairs + first, count - first);
    const Rest<S> found = rest(p.a, p.pose_a, S(0), p.pose_b, p.margin);
    const auto vector = [&](auto& columns, const Vec3<S>& v) {
      for (std::size_t k = 0; k < 3; ++k) put(columns[k] + first, v[k], p.count);
    };
    put(block.distance + first, found.distance, p.count);
    put(block.filled + first, found.filled, p.count);
    vector(block.up, found.up);
    for (std::size_t i = 0; i < rest_points_of<A>; ++i) {
      vector(block.slots[i].of_body, found.slots[i].of_body);
      vector(block.slots[i].of_plane, found.slots[i].of_plane);
      put(block.slots[i].distance + first, found.slots[i].distance, p.count);
      put(block.slots[i].corner + first, found.slots[i].corner, p.count);
    }
  }
}

#define GRAZE_INSTANTIATE(A)                                                                                           \
  template void rests<A<float>>(const PairRef<float>*, std::size_t, RestBlock<float>&);                                \
  template void rests<A<double>>(const PairRef<double>*, std::size_t, RestBlock<double>&);
GRAZE_INSTANTIATE(Sphere)
GRAZE_INSTANTIATE(Capsule)
GRAZE_INSTANTIATE(Box)
GRAZE_INSTANTIATE(Triangle)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
