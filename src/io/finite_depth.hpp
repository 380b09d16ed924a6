// The error of a distance that does not exist.
//
// Guarantee: nothing happens for any other distance.
#pragma once

#include <string>

#include "graze/error.hpp"
#include "graze/result.hpp"

namespace graze::io {

/// Throws `InvalidValue` for the distance of two half-spaces that overlap without end. `called`: what they are called.
inline void require_finite_depth(Status status, const std::string& called = "half-spaces") {
  if (status == Status::unbounded)
    throw InvalidValue("a, b", "shapes of finite depth", "two " + called + " that are not opposite");
}

}  // namespace graze::io
