// Fewer points of contact of a pair: of all its manifolds together, so that a solver has a bounded number to push at.
//
// Guarantee: of a pair with more than `count` points exactly `count` remain, the deepest among them, as they were and
// in their order; a pair with no more stays as it is. A pair of one manifold keeps the points that `reduce` of it
// keeps. Of several, each next point is the one furthest from all that are kept, so that no point that is left out is
// further from a kept one than twice what the best choice of as many would have (Gonzalez 1985, "Clustering to
// minimize the maximum intercluster distance"). Furthest in place and in normal: the difference of two unit normals
// counts that many times the distance from the deepest point to the one furthest from it. Manifolds without a point
// left are left out.
#pragma once

#include "graze/batch_contacts.hpp"
#include "graze/contact.hpp"
#include "graze/world/manifolds.hpp"

namespace graze {

/// Of a pair's manifolds, as `contacts` appends them to an empty vector. Costs `count` times the number of points.
template <class T>
GRAZE_API void reduce(Manifolds<T>& manifolds, std::size_t count);

/// Of every pair of a batch. Whether pairs overlap stays.
template <class T>
GRAZE_API void reduce(BatchContacts<T>& contacts, std::size_t count);

/// Of every pair that an update of a world found, after which it may be asked of `World::contacts`: the world carries
/// impulses on to what is found next, pairs of which nothing changed keep what is left, and all others are found whole
/// again. A point that was left out and comes back starts without an impulse. Where every update is to be reduced,
/// `WorldSettings::points_per_pair` does it pair by pair, on the world's threads.
template <class T, class Space>
GRAZE_API void reduce(ContactArrays<T, Space>& contacts, std::size_t count);

}  // namespace graze
