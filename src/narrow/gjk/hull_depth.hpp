// EPA for two small hulls, across lanes: the facets of the polytope in blocks of eight, whose planes are computed,
// tested and searched together.
//
// Guarantee: that of `epa.hpp`, with the same bits at every level of the instruction set. Answers only where the depth
// is proven within the tolerance and its points are found; else, for instance where rounding folds the polytope or it
// outgrows its storage, the caller uses the general EPA.
#pragma once

#include "narrow/core/hull_support.hpp"
#include "narrow/gjk/epa_result.hpp"

namespace graze {

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Expands a tetrahedron of points of the difference that contains the origin. `noise`: distance of a point from a
    /// plane by rounding alone.
    template <class T> bool hull_depth(const HullPair<T>& hulls, const PlacedVertices& placed,
                                       const SupportPoint* tetrahedron, double noise, double tolerance,
                                       EpaResult& result);)
// clang-format on

}  // namespace graze
