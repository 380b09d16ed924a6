// Results of lanes for capsules whose sides lie on another shape, written pair by pair. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/pairs/segment_contact.hpp"
#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

/// Writes one lane of a pair, rounded to T.
template <class T, class S>
[[gnu::always_inline]] inline void put_side(const SegmentContact<S>& found, int i, SegmentContact<T>& to) {
  const auto vector = [i](const Vec3<S>& v) __attribute__((always_inline)) {
    return Vec3<T>{static_cast<T>(v.x[i]), static_cast<T>(v.y[i]), static_cast<T>(v.z[i])};
  };
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& from = found.slots[k];
    auto& slot = to.slots[k];
    slot.a = vector(from.a);
    slot.b = vector(from.b);
    slot.distance = static_cast<T>(from.distance[i]);
    slot.place = static_cast<T>(from.place[i]);
  }
  to.distance = static_cast<T>(found.distance[i]);
  to.normal = vector(found.normal);
  to.filled = static_cast<T>(found.filled[i]);
}

/// Writes the lanes whose bits are set, one behind the other.
template <class T, class S>
[[gnu::always_inline]] inline void put_sides(const SegmentContact<S>& found, std::uint32_t bits,
                                             SegmentContact<T>* to) {
  for (int i = 0; bits != 0; ++i, bits >>= 1)
    if ((bits & 1) != 0) put_side(found, i, *to++);
}

}  // namespace graze::GRAZE_ISA
