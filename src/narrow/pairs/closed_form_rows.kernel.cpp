// Distances and overlap tests of pairs in rows that have a closed form: spheres, capsules, balls with boxes, and all of
// these and triangles with half-spaces.
#include "narrow/batch/kernel_instances.hpp"
#include "narrow/pairs/row_overlaps.hpp"

namespace graze::GRAZE_ISA {

template <class T>
inline Touching<Lanes<T>> touching(const RowBundle<Sphere<T>, Sphere<T>, T>& p) {
  const auto pair = sphere_capsule_pair(p.a.shapes, p.pose_a, p.b.shapes, p.pose_b);
  return {spheres_overlap(pair.a.point, pair.radius_a, pair.b.point, pair.radius_b), p.regular()};
}

template <class A, class B, class T>
[[gnu::flatten]] std::uint32_t row_distances(const PairRows<T>& rows, std::size_t count, bool turned,
                                             Distance<T>* distances, std::uint8_t* unknown) {
  const auto write = [=](const RowBundle<A, B, T>& pairs, std::size_t filled, std::size_t first) {
    const CoreDistance<Lanes<T>> found = distance_of(pairs);
    put(turned ? mirrored(found) : found, filled, distances + first);
    return pairs.regular();
  };
  return answer_rows<A, B>(rows, count, unknown, write);
}

/// The kernels for the pairs of the list that have them.
template <class T>
struct ClosedFormRows {
  static constexpr KernelInstances<std::uint32_t(const PairRows<T>&, std::size_t, bool, Distance<T>*, std::uint8_t*)>
      distances{[]<class P>() {
        if constexpr (HasClosedFormRows<P>)
          return &row_distances<typename P::template A<T>, typename P::template B<T>, T>;
        else
          return nullptr;
      }};
  static constexpr KernelInstances<std::uint32_t(const PairRows<T>&, std::size_t, std::uint8_t*, std::uint8_t*)>
      overlaps{[]<class P>() {
        if constexpr (HasClosedFormRows<P>)
          return &row_overlaps<typename P::template A<T>, typename P::template B<T>, T>;
        else
          return nullptr;
      }};
};
template struct ClosedFormRows<float>;
template struct ClosedFormRows<double>;

}  // namespace graze::GRAZE_ISA
