// Fewer points of contact of a pair in the plane: of all its manifolds together, so that a solver has a bounded
// number of them.
//
// Guarantee: that of `graze/world/reduce.hpp`.
#pragma once

#include "graze/plane/query.hpp"

namespace graze::plane {

/// Leaves at most `count` points of a pair's manifolds, which `contacts` has appended to an empty vector. Costs `count`
/// times the number of points.
template <class T>
GRAZE_API void reduce(Manifolds<T>& manifolds, std::size_t count);

}  // namespace graze::plane
