// Batches: the queries of query.hpp on many pairs of shapes at once.
//
// Guarantee: each pair gets the bits that the query gives for it alone, whatever the order of the pairs, the other
// pairs of the batch, the level of the instruction set and the number of threads; a batch is a matter of speed only.
// Pairs of kinds that have a kernel are answered 2 to 16 at a time (by the machine and the type of numbers), all others
// one by one. Only functions documented to throw do so; nothing is allocated while the arrays of the answer have the
// capacity, but for contacts with an executor, of which each thread writes its part by itself. User's shapes are asked
// from the executor's threads.
#pragma once

#include <cstdint>
#include <vector>

#include "graze/batch_contacts.hpp"
#include "graze/batch_pairs.hpp"
#include "graze/compact_contacts.hpp"
#include "graze/executor.hpp"
#include "graze/query.hpp"

namespace graze {

/// Sets `touch[i]` to 1 where the i-th pair overlaps, else to 0. Kernels: spheres, capsules and boxes with each other;
/// these and triangles with half-spaces; spheres and capsules with triangles; cylinders, cones and ellipsoids with each
/// other and with spheres, capsules, boxes, rectangles, segments and triangles; triangles with each other and with
/// boxes and rectangles. With an executor, on its threads.
template <class T>
GRAZE_API void overlap(const Batch<T>& batch, std::vector<std::uint8_t>& touch, Executor* executor = nullptr);

/// Sets `distances[i]` to the `distance` of the i-th pair. Kernels: spheres, capsules and boxes with each other; these
/// and triangles with half-spaces; spheres and capsules with triangles, and triangles with each other. With an
/// executor, on its threads.
template <class T>
GRAZE_API void distance(const Batch<T>& batch, std::vector<Distance<T>>& distances, Executor* executor = nullptr);

/// Contacts of the pairs that are at most `margin` >= 0 apart, as `contacts` gives them. Kernels: spheres, capsules and
/// boxes with each other and with triangles; all of these with half-spaces; triangles with each other, where lanes rule
/// out the pairs that are further apart. With an executor, on its threads: the batch is then cut into parts, whose
/// manifolds and points are found by themselves and then copied one behind the other, so that their order is another
/// one than without, whatever the number of threads. That pays where pairs take long, as hulls and composites do: for
/// boxes the copying takes as long as two threads save.
template <class T>
GRAZE_API void contacts(const Batch<T>& batch, T margin, BatchContacts<T>& found, Executor* executor = nullptr);

/// Contacts in compact form, for callers who need points, normals and distances only. With an executor, as above.
template <class T>
GRAZE_API void contacts(const Batch<T>& batch, T margin, CompactContacts<T>& found, Executor* executor = nullptr);

}  // namespace graze
