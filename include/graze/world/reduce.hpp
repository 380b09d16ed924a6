// Reduction of contact points: a bound on the points of a pair, over all its manifolds, and so on a solver's work.
//
// Guarantee: a pair with more than `count` points keeps exactly `count`, the deepest among them, unchanged and in their
// order; a pair with no more stays as it is. A pair of one manifold keeps the points that `reduce` of it keeps. From
// several manifolds, each next point is the one furthest from all that are kept, so that no point left out is further
// from a kept one than twice what the best choice of as many would have (Gonzalez 1985, "Clustering to minimize the
// maximum intercluster distance"). Distance combines place and normal: the difference of two unit normals counts that
// many times the distance from the deepest point to the one furthest from it. Manifolds without a point left are
// removed.
#pragma once

#include "graze/batch_contacts.hpp"
#include "graze/contact.hpp"
#include "graze/world/manifolds.hpp"

namespace graze {

/// Reduces a pair's manifolds, as `contacts` appends them to an empty vector. Costs `count` times the number of points.
template <class T>
GRAZE_API void reduce(Manifolds<T>& manifolds, std::size_t count);

/// Reduces every pair of a batch. Whether pairs overlap stays.
template <class T>
GRAZE_API void reduce(BatchContacts<T>& contacts, std::size_t count);

/// Reduces every pair of a world's update. May be called on `World::contacts`: the world carries impulses over to the
/// contacts of the next update, unchanged pairs keep their reduced points, and all others are found whole again. A
/// point that was left out and comes back starts without an impulse. Where every update is to be reduced,
/// `WorldSettings::points_per_pair` does it pair by pair, on the world's threads.
template <class T, class Space>
GRAZE_API void reduce(ContactArrays<T, Space>& contacts, std::size_t count);

}  // namespace graze
