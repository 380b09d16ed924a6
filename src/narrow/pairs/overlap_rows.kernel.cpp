// Overlap tests of pairs in rows: by their distance, except for balls, boxes, and boxes with triangles. And the test of
// one pair of boxes.
#include "narrow/batch/row_answers.hpp"
#include "narrow/pairs/box_box/overlap.hpp"
#include "narrow/pairs/box_triangle/overlap.hpp"
#include "narrow/pairs/row_distance.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// The lanes that touch, and those in which that is known.
template <class S>
struct Touching {
  typename S::Mask touch, known;
};

template <class A, class B, class T>
Touching<Lanes<T>> touching(const RowBundle<A, B, T>& p) {
  return {distance_of(p).distance <= Lanes<T>(0), p.regular()};
}
template <class T>
Touching<Lanes<T>> touching(const RowBundle<Sphere<T>, Sphere<T>, T>& p) {
  const auto pair = sphere_capsule_pair(p.a.shapes, p.pose_a, p.b.shapes, p.pose_b);
  return {spheres_overlap(pair.a.point, pair.radius_a, pair.b.point, pair.radius_b), p.regular()};
}
template <class T>
Touching<Lanes<T>> touching(const RowBundle<Box<T>, Box<T>, T>& p) {
  using S = Lanes<T>;
  const ScaledBoxes<S> boxes(Packed<S, 3>(p.a.shapes.core.half), PoseRows<S>(p.pose_a),
                             Packed<S, 3>(p.b.shapes.core.half), PoseRows<S>(p.pose_b));
  return {!boxes_apart(boxes, box_noise(boxes)), p.regular()};
}

template <class T>
Touching<Lanes<T>> touching(const RowBundle<Box<T>, Triangle<T>, T>& p) {
  const BoxTouchesTriangle<Lanes<T>> found(p.a.shapes.core, p.pose_a, p.b.shapes.core, p.pose_b);
  return {found.touch, found.known};
}

}  // namespace

template <class A, class B, class T>
[[gnu::flatten]] std::uint32_t row_overlaps(const PairRows<T>& rows, std::size_t count, std::uint8_t* touch,
                                            std::uint8_t* unknown) {
  const auto write = [touch](const RowBundle<A, B, T>& pairs, std::size_t filled, std::size_t first) {
    const Touching<Lanes<T>> found = touching(pairs);
    put_bytes<T>(found.touch.bits & 1, filled, touch + first);
    return found.known;
  };
  return answer_rows<A, B>(rows, count, unknown, write);
}

template <class T>
[[gnu::flatten]] std::optional<bool> boxes_touch(const Box<T>& a, const Pose<T>& pose_a, const Box<T>& b,
                                                 const Pose<T>& pose_b, bool faces_only) {
  const Packed<T, 3> half_a(a.half_extents()), half_b(b.half_extents());
  if (!regular_boxes<T>(half_a, half_b)) return std::nullopt;
  const ScaledBoxes<T> boxes(half_a, PoseRows<T>(pose_a), half_b, PoseRows<T>(pose_b));
  return !boxes_apart(boxes, box_noise(boxes), faces_only);
}

#define GRAZE_INSTANTIATE_FOR(A, B, T)                                                                                 \
  template std::uint32_t row_overlaps<A<T>, B<T>>(const PairRows<T>&, std::size_t, std::uint8_t*, std::uint8_t*);
#define GRAZE_INSTANTIATE(A, B)                                                                                        \
  GRAZE_INSTANTIATE_FOR(A, B, float)                                                                                   \
  GRAZE_INSTANTIATE_FOR(A, B, double)
GRAZE_FOR_ROUND_PAIRS(GRAZE_INSTANTIATE)
GRAZE_INSTANTIATE(Box, Box)
GRAZE_INSTANTIATE(Box, Triangle)
GRAZE_INSTANTIATE(Sphere, HalfSpace)
GRAZE_INSTANTIATE(Capsule, HalfSpace)
GRAZE_INSTANTIATE(Box, HalfSpace)
GRAZE_INSTANTIATE(Triangle, HalfSpace)
#undef GRAZE_INSTANTIATE
#undef GRAZE_INSTANTIATE_FOR
template std::optional<bool> boxes_touch(const Box<float>&, const Pose<float>&, const Box<float>&, const Pose<float>&,
                                         bool);
template std::optional<bool> boxes_touch(const Box<double>&, const Pose<double>&, const Box<double>&,
                                         const Pose<double>&, bool);

}  // namespace graze::GRAZE_ISA
