// Reduction of contact points in the plane: a bound on the points of a pair, over all its manifolds.
//
// Guarantee: that of `graze/world/reduce.hpp`.
#pragma once

#include "graze/plane/batch.hpp"

namespace graze::plane {

/// Reduces a pair's manifolds, as `contacts` appends them to an empty vector. Costs `count` times the number of points.
template <class T>
GRAZE_API void reduce(Manifolds<T>& manifolds, std::size_t count);

/// Reduces every pair of a batch. Whether pairs overlap stays.
template <class T>
GRAZE_API void reduce(BatchContacts<T>& contacts, std::size_t count);

}  // namespace graze::plane
