// Overlap tests of boxes with triangles in rows.
#include "narrow/pairs/box_triangle/overlap.hpp"

#include "narrow/pairs/row_overlaps.hpp"

namespace graze::GRAZE_ISA {

template <class T>
inline Touching<Lanes<T>> touching(const RowBundle<Box<T>, Triangle<T>, T>& p) {
  const BoxTouchesTriangle<Lanes<T>> found(p.a.shapes.core, p.pose_a, p.b.shapes.core, p.pose_b);
  return {found.touch, found.known};
}

template std::uint32_t row_overlaps<Box<float>, Triangle<float>>(const PairRows<float>&, std::size_t, std::uint8_t*,
                                                                 std::uint8_t*);
template std::uint32_t row_overlaps<Box<double>, Triangle<double>>(const PairRows<double>&, std::size_t, std::uint8_t*,
                                                                   std::uint8_t*);

}  // namespace graze::GRAZE_ISA
