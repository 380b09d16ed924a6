// A ray clipped by many planes, several of them at a time (Cyrus, Beck 1978, "Generalized two- and three-dimensional
// clipping").
//
// Guarantee: the same bits at every level of the instruction set, and as one plane after the other gives.
#pragma once

#include <cstddef>

#include "simd/dispatch.hpp"

namespace graze::rays {

struct PlaneClip {
  double enter, leave;  ///< the ray is behind all planes from the one to the other
  std::size_t plane;    ///< the first of those that it enters last by; any where it enters by none
  bool outside;         ///< it runs along a plane, in front of it
};

}  // namespace graze::rays

namespace graze {

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// `planes` are four numbers each: a normal and an offset along it. At least one.
    template <class T> void clip_by_planes(const T* planes, std::size_t count, const double (&origin)[3],
                                           const double (&direction)[3], rays::PlaneClip& clip);)
// clang-format on

}  // namespace graze
