// Capsules with rectangles in rows.
#include "narrow/pairs/box_box/distance_lanes.hpp"

namespace graze::GRAZE_ISA {

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template std::uint32_t box_row_distances<Capsule<T>, Rectangle<T>>(const PairRows<T>&, std::size_t, bool,            \
                                                                     Distance<T>*, std::uint8_t*);                     \
  template std::uint32_t box_like_row_overlaps<Capsule<T>, Rectangle<T>>(const PairRows<T>&, std::size_t,              \
                                                                         std::uint8_t*, std::uint8_t*);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
