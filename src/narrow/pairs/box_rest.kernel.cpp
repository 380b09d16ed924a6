#include "narrow/pairs/box_rest.hpp"
#include "narrow/pair_bundle.hpp"

namespace graze::GRAZE_ISA {

template <class T>
[[gnu::flatten]] void box_rests(const PairRef<T>* pairs, std::size_t count, BoxRestBlock<T>& block) {
  using S = Lanes<T>;
  using Pairs = PairBundle<Box<T>, HalfSpace<T>, T>;
  for (std::size_t first = 0; first < count; first += Pairs::lanes) {
    const Pairs p(pairs + first, count - first);
    const BoxRest<S> found = box_rest(p.a.core.half, p.pose_a, S(0), p.pose_b, p.margin);
    const auto vector = [&](auto& columns, const Vec3<S>& v) {
      for (std::size_t k = 0; k < 3; ++k) put(columns[k] + first, v[k], p.count);
    };
    put(block.distance + first, found.distance, p.count);
    put(block.filled + first, found.filled, p.count);
    vector(block.up, found.up);
    for (std::size_t i = 0; i < most_rest_points; ++i) {
      vector(block.slots[i].of_box, found.slots[i].of_box);
      vector(block.slots[i].of_plane, found.slots[i].of_plane);
      put(block.slots[i].distance + first, found.slots[i].distance, p.count);
      put(block.slots[i].corner + first, found.slots[i].corner, p.count);
    }
  }
}

template void box_rests(const PairRef<float>*, std::size_t, BoxRestBlock<float>&);
template void box_rests(const PairRef<double>*, std::size_t, BoxRestBlock<double>&);

}  // namespace graze::GRAZE_ISA
