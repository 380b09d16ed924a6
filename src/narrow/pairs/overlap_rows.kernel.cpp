// Whether pairs in rows touch: balls, and boxes.
#include "narrow/pairs/box_overlap.hpp"
#include "narrow/pairs/sphere_sphere.hpp"
#include "narrow/row_bundle.hpp"

#include "narrow/closed_form.hpp"

namespace graze::GRAZE_ISA {

/// 1 in the lanes that touch, 0 in the others; 2 where that is not known.
template <class A, class T>
[[gnu::flatten]] void row_overlaps(const PairRows<T>& rows, std::size_t count, std::uint8_t* touch) {
  using S = Lanes<T>;
  constexpr std::size_t lanes = lanes_of<T>;
  for (std::size_t first = 0; first < count; first += lanes) {
    const RowBundle<A, A, T> p(rows, first);
    typename S::BitVector touching;
    if constexpr (std::is_same_v<A, Sphere<T>>) {
      const auto pair = round_pair(p.a.shapes, p.pose_a, p.b.shapes, p.pose_b);
      touching = spheres_overlap(pair.a.point, pair.radius_a, pair.b.point, pair.radius_b).bits & 1;
    } else {
      const BoxRows<S> boxes(Several<S, 3>(p.a.shapes.core.half), PoseRows<S>(p.pose_a),
                             Several<S, 3>(p.b.shapes.core.half), PoseRows<S>(p.pose_b));
      const auto apart = boxes_apart(boxes, box_noise(boxes, length(boxes.half_a), length(boxes.half_b)));
      const auto irregular = p.regular() < S(1);
      touching = (~(apart.bits | irregular.bits) & 1) | (irregular.bits & 2);
    }
    put_bytes<T>(touching, least(lanes, count - first), touch + first);
  }
}

#define GRAZE_INSTANTIATE(A)                                                                                           \
  template void row_overlaps<A<float>>(const PairRows<float>&, std::size_t, std::uint8_t*);                            \
  template void row_overlaps<A<double>>(const PairRows<double>&, std::size_t, std::uint8_t*);
GRAZE_INSTANTIATE(Sphere)
GRAZE_INSTANTIATE(Box)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
