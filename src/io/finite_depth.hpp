// The error of a distance that does not exist.
//
// Guarantee: nothing happens for any other distance.
#pragma once

#include "graze/error.hpp"
#include "graze/result.hpp"

namespace graze::io {

/// Throws `InvalidValue` for the distance of two half-spaces that overlap without end.
inline void require_finite_depth(Status status) {
  if (status == Status::unbounded)
    throw InvalidValue("a, b", "shapes of finite depth", "two half-spaces that are not opposite");
}

}  // namespace graze::io
