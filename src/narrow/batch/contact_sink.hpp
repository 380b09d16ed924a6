// Where the kernels' contacts go: a sink. A batch has one that writes arrays, a world one that writes its stages'
// arrays, and a mesh one that gathers manifolds; a pair's `visit_contacts` hands to any of them what it finds of the
// pairs that it was given.
//
// A sink has, for the i-th of those pairs:
//
//     apart(i)                                   further apart than its margin
//     unknown(i)                                 the kernels do not tell: asked about alone
//     one(i, contact)                            within its margin, with one point of contact (`PointContact`)
//     several(i, distance, normal, points, most) with up to `most`, which `points.append(to)` appends to what has
//                                                `push_back` and `emplace_back`
//     met(pairs, turned)                         some of them at a time (`MetPairs`); `turned`: told from B to A
//
// and `most`, how many pairs it is told of at a time, and `Scalar`. It may have `one_each(contacts, meetings, count)`
// in place of `apart` and `one`, which takes a whole block and returns how many of it are told of one by one (those
// that lie or are unknown), and `room()`, where kernels write blocks to (as `BlockRoom`).
#pragma once

#include "narrow/batch/box_batch.hpp"

namespace graze {

/// Where kernels write blocks to: to where the sink says, else aside.
template <class Sink>
decltype(auto) room_of(Sink& sink) {
  if constexpr (requires { sink.room(); })
    return sink.room();
  else
    return BlockRoom<typename Sink::Scalar>();
}

}  // namespace graze
