// The points of shapes on half-spaces, a bundle at a time.
#include "narrow/batch/kernel_instances.hpp"
#include "narrow/batch/pair_bundle.hpp"
#include "narrow/pairs/box_half_space.hpp"
#include "narrow/pairs/sphere_capsule_half_space.hpp"
#include "narrow/pairs/triangle_half_space.hpp"

namespace graze::GRAZE_ISA {

template <class A, class T>
[[gnu::flatten]] void half_space_slots(const PairRef<T>* pairs, std::size_t count, HalfSpaceBlock<T>& block) {
  using S = Lanes<T>;
  using Pairs = PairBundle<A, HalfSpace<T>, T>;
  static_assert(std::extent_v<decltype(HalfSpaceBlock<T>::slots)> == most_half_space_points);
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

/// The kernel for the pairs of the list that have it.
template <class T>
struct HalfSpaceSlots {
  static constexpr KernelInstances<void(const PairRef<T>*, std::size_t, HalfSpaceBlock<T>&)> slots{[]<class P>() {
    if constexpr (HasHalfSpaceKernels<P>)
      return &half_space_slots<typename P::template A<T>, T>;
    else
      return nullptr;
  }};
};
template struct HalfSpaceSlots<float>;
template struct HalfSpaceSlots<double>;

}  // namespace graze::GRAZE_ISA
