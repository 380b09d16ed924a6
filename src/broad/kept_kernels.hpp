// Kernels for all boxes and all kept pairs of every frame: plain arrays in and out, so that they can be compiled for
// each instruction set.
//
// Guarantee: exact comparisons, nothing is rounded. A box is six numbers, the lower corner first, and a pair two
// places.
#pragma once

#include <cstddef>
#include <cstdint>

#include "simd/dispatch.hpp"

namespace graze {

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Writes to `left` the places, ascending, of the boxes that are not wholly inside the room of the same place;
    /// stops after `most` of them. Returns how many.
    template <class T> std::uint32_t find_left(const T* boxes, const T* rooms, std::uint32_t count, std::uint32_t* left,
                                               std::uint32_t most);
    /// Writes to `out`, in their order, those of `pairs` that overlap, but for pairs with a place whose bit is set in
    /// `dropped`, unless that is null. `out` has room for all of them. Returns how many.
    template <class T> std::size_t keep_overlapping(const T* boxes, const std::uint32_t* pairs, std::size_t count,
                                                    const std::uint64_t* dropped, std::uint32_t* out);)
// clang-format on

}  // namespace graze
