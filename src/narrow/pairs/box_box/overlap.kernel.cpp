// Overlap tests of boxes: in rows, and of one pair.
#include "narrow/pairs/box_box/overlap.hpp"

#include "narrow/pairs/row_overlaps.hpp"

namespace graze::GRAZE_ISA {

template <class T>
inline Touching<Lanes<T>> touching(const RowBundle<Box<T>, Box<T>, T>& p) {
  using S = Lanes<T>;
  const ScaledBoxes<S> boxes(Packed<S, 3>(p.a.shapes.core.half), PoseRows<S>(p.pose_a),
                             Packed<S, 3>(p.b.shapes.core.half), PoseRows<S>(p.pose_b));
  return {!boxes_apart(boxes, box_noise(boxes)), p.regular()};
}

template <class T>
[[gnu::flatten]] std::optional<bool> boxes_touch(const Box<T>& a, const Pose<T>& pose_a, const Box<T>& b,
                                                 const Pose<T>& pose_b, bool faces_only) {
  const Packed<T, 3> half_a(a.half_extents()), half_b(b.half_extents());
  if (!regular_boxes<T>(half_a, half_b)) return std::nullopt;
  const ScaledBoxes<T> boxes(half_a, PoseRows<T>(pose_a), half_b, PoseRows<T>(pose_b));
  return !boxes_apart(boxes, box_noise(boxes), faces_only);
}

template std::uint32_t row_overlaps<Box<float>, Box<float>>(const PairRows<float>&, std::size_t, std::uint8_t*,
                                                            std::uint8_t*);
template std::uint32_t row_overlaps<Box<double>, Box<double>>(const PairRows<double>&, std::size_t, std::uint8_t*,
                                                              std::uint8_t*);
template std::optional<bool> boxes_touch(const Box<float>&, const Pose<float>&, const Box<float>&, const Pose<float>&,
                                         bool);
template std::optional<bool> boxes_touch(const Box<double>&, const Pose<double>&, const Box<double>&,
                                         const Pose<double>&, bool);

}  // namespace graze::GRAZE_ISA
