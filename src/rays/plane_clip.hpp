// A ray clipped by many planes, several of them at a time (Cyrus, Beck 1978, "Generalized two- and three-dimensional
// clipping").
//
// Guarantee: the same bits at every level of the instruction set, and as if clipped by one plane after the other.
#pragma once

#include <cstddef>

#include "simd/dispatch.hpp"

namespace graze::rays {

struct PlaneClip {
  double enter, leave;  ///< the ray is behind all planes between these
  std::size_t plane;    ///< plane of the last entry, the first of several; any where there is none
  bool outside;         ///< the ray is parallel to a plane, in front of it
};

}  // namespace graze::rays

namespace graze {

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Clips by `planes`, four numbers each: a normal and an offset along it. At least one.
    template <class T> void clip_by_planes(const T* planes, std::size_t count, const double (&origin)[3],
                                           const double (&direction)[3], rays::PlaneClip& clip);)
// clang-format on

}  // namespace graze
