// Pairs of spheres and capsules, and of balls with boxes, in rows.
#include "narrow/batch/sphere_capsule_rows.hpp"
#include "narrow/batch/kernel_instances.hpp"

namespace graze::GRAZE_ISA {

template <class A, class B, class T>
[[gnu::flatten]] void sphere_capsule_row_contacts(const PairRows<T>& rows, std::size_t count, T margin, bool turned,
                                                  const ContactRows<T>& to, RowCounts& all_found) {
  using S = Lanes<T>;
  constexpr std::size_t lanes = lanes_of<T>;
  RowCounts counts{0, 0, 0};
  for (std::size_t first = 0; first < count; first += lanes) {
    const RowBundle<A, B, T> p(rows, first);
    const OneContact<S> c = closest_contact(p.a.shapes, p.pose_a, p.b.shapes, p.pose_b, S(margin));
    const S weight = contact_weight(p.a.shapes, p.b.shapes);
    put_rows(
        p, c, weight, margin, turned, first, count, to,
        counts, [&](std::uint32_t lying, SegmentContact<T> * sides) __attribute__((always_inline)) {
          if constexpr (lies_on_sides<A>)
            put_sides(side_contact(p.a.shapes, p.pose_a, p.b.shapes, p.pose_b, c.at, S(margin)), lying, sides);
        });
  }
  all_found = counts;
}

/// The kernel for the pairs of the list that have it.
template <class T>
struct OneContactRows {
  static constexpr KernelInstances<void(const PairRows<T>&, std::size_t, T, bool, const ContactRows<T>&, RowCounts&)>
      contacts{[]<class P>() {
        if constexpr (HasOneContactKernels<P>)
          return &sphere_capsule_row_contacts<typename P::template A<T>, typename P::template B<T>, T>;
        else
          return nullptr;
      }};
};
template struct OneContactRows<float>;
template struct OneContactRows<double>;

}  // namespace graze::GRAZE_ISA
