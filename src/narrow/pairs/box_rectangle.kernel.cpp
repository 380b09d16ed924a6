// Distances of boxes and rectangles with rectangles in rows.
#include "narrow/pairs/box_box/distance_lanes.hpp"

namespace graze::GRAZE_ISA {

#define GRAZE_INSTANTIATE(A, T)                                                                                        \
  template std::uint32_t box_row_distances<A<T>, Rectangle<T>>(const PairRows<T>&, std::size_t, bool, Distance<T>*,    \
                                                               std::uint8_t*);
GRAZE_INSTANTIATE(Box, float)
GRAZE_INSTANTIATE(Box, double)
GRAZE_INSTANTIATE(Rectangle, float)
GRAZE_INSTANTIATE(Rectangle, double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
