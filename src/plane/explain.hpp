// What a pair of shapes in the plane was answered by, told after the answer.
//
// Guarantee: no query takes another way for it; the axes are those of the edges, with the intervals that both shapes
// cover on them, and the steps of curved cores are those that led to the answer.
#pragma once

#include "graze/plane/query.hpp"
#include "plane/leaves.hpp"

namespace graze::plane {

/// The trace of a pair that was answered by `answer`.
template <class T>
Trace explained(const LeafPair<T>& pair, const Distance<double>& answer);

}  // namespace graze::plane
