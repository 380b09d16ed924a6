// The error of a distance that does not exist.
//
// Guarantee: nothing happens for any other distance.
#pragma once

#include "graze/error.hpp"
#include "graze/result.hpp"

namespace graze::io {

/// Throws `InvalidValue` for the distance of two half-spaces, or in the plane `half_planes`, that overlap without end.
inline void require_finite_depth(Status status, bool half_planes = false) {
  if (status == Status::unbounded)
    throw InvalidValue("a, b", "shapes of finite depth",
                       half_planes ? "two half-planes that are not opposite" : "two half-spaces that are not opposite");
}

}  // namespace graze::io
