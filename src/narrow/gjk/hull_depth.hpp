// EPA for two small hulls, on lanes: the facets of the polytope by eights, whose planes are made, seen and searched
// together.
//
// Guarantee: as `epa.hpp`, the same bits at every level of the instruction set. Answers only where the depth is proven
// within the tolerance and its points are found; else, as where rounding folds the polytope or it outgrows its room,
// the caller asks the general EPA.
#pragma once

#include "narrow/core/hull_support.hpp"
#include "narrow/gjk/epa_result.hpp"

namespace graze {

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// From a tetrahedron of points of the difference that holds the origin. `noise`: how far a point may lie from a
    /// plane by rounding alone.
    template <class T> bool hull_depth(const HullPair<T>& hulls, const PlacedVertices& placed,
                                       const SupportPoint* tetrahedron, double noise, double tolerance,
                                       EpaResult& result);)
// clang-format on

}  // namespace graze
