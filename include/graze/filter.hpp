// Collision filters: categories, masks and groups that decide which pairs are tested.
//
// Guarantee: one AND each way and one comparison a pair; symmetric: swapping the two never changes the verdict.
#pragma once

#include <cstdint>

#include "graze/detail/standard.hpp"

namespace graze {

/// The category of a body and the categories that it collides with.
struct Filter {
  std::uint64_t category = 1;              ///< the bits that this body belongs to
  std::uint64_t mask = ~std::uint64_t{0};  ///< the bits that it collides with
  std::int32_t group = 0;                  ///< bodies of equal groups collide always if positive, never if negative; 0
                                           ///< is no group

  friend constexpr bool operator==(const Filter&, const Filter&) = default;
};

/// Whether two bodies may collide: the group decides if both share one that is not 0, else the masks must agree
/// both ways.
constexpr bool may_collide(const Filter& a, const Filter& b) {
  if (a.group != 0 && a.group == b.group) return a.group > 0;
  return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

}  // namespace graze
