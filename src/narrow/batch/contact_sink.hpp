// Sinks: receivers of the kernels' contacts. A batch has one that writes arrays, a world one that writes its stages'
// arrays, and a mesh one that gathers manifolds; a pair's `visit_contacts` passes the results for the given pairs to
// any of them.
//
// Functions of a sink, for the i-th of those pairs:
//
//     apart(i)                                   further apart than its margin
//     unknown(i)                                 the kernels have no answer: to be answered alone
//     one(i, contact)                            within its margin, with one point of contact (`PointContact`)
//     several(i, distance, normal, points, most) with up to `most` points, which `points.append(to)` appends to any
//                                                type with `push_back` and `emplace_back`
//     met(pairs, turned)                         some of them at a time (`MetPairs`); `turned`: given from B to A
//
// Its constants are `most`, the number of pairs that it takes at a time, and `Scalar`. Optional are `one_each(contacts,
// meetings, count)` in place of `apart` and `one`, which takes a whole block and returns how many of it are passed one
// by one (those on their sides or unknown), and `room()`, storage for the kernels' blocks (as `BlockRoom`).
#pragma once

#include "narrow/batch/box_batch.hpp"

namespace graze {

/// The sink's storage for the kernels' blocks, or a `BlockRoom`.
template <class Sink>
decltype(auto) room_of(Sink& sink) {
  if constexpr (requires { sink.room(); })
    return sink.room();
  else
    return BlockRoom<typename Sink::Scalar>();
}

}  // namespace graze
