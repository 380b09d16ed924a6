// Pairs of spheres and capsules, and of balls with boxes, a bundle at a time.
#include "narrow/batch/kernel_instances.hpp"
#include "narrow/batch/pair_bundle.hpp"
#include "narrow/batch/point_contacts.hpp"
#include "narrow/pairs/segment_lanes.hpp"

namespace graze::GRAZE_ISA {

template <class A, class B, class T>
[[gnu::flatten]] void sphere_capsule_contacts(const PairRef<T>* pairs, std::size_t count, PointContact<T>* contacts,
                                              Meeting* meetings, [[maybe_unused]] SegmentContact<T>* sides) {
  using S = Lanes<T>;
  using Pairs = PairBundle<A, B, T>;
  for (std::size_t first = 0; first < count; first += Pairs::lanes) {
    const Pairs p(pairs + first, count - first);
    const OneContact<S> c = closest_contact(p.a, p.pose_a, p.b, p.pose_b, p.margin);
    const S weight = contact_weight(p.a, p.b);
    const S meeting = put_all<A, B>(c, p.margin, weight, contacts + first, meetings + first);
    if constexpr (lies_on_sides<A>) {
      const std::uint32_t lying = lying_lanes<T>(meeting, p.count);
      if (lying == 0) continue;
      put_sides(side_contact(p.a, p.pose_a, p.b, p.pose_b, c.at, p.margin), lying, sides);
      sides += count_bits(lying);
    }
  }
}

/// The kernel for the pairs of the list that have it.
template <class T>
struct OneContacts {
  static constexpr KernelInstances<void(const PairRef<T>*, std::size_t, PointContact<T>*, Meeting*, SegmentContact<T>*)>
      contacts{[]<class P>() {
        if constexpr (HasOneContactKernels<P>)
          return &sphere_capsule_contacts<typename P::template A<T>, typename P::template B<T>, T>;
        else
          return nullptr;
      }};
};
template struct OneContacts<float>;
template struct OneContacts<double>;

}  // namespace graze::GRAZE_ISA
