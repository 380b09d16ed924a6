// Triangles in lanes of double, shared by the kernels for their distances and their points. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/batch/pair_bundle.hpp"
#include "narrow/core/in_double.hpp"
#include "narrow/pairs/triangle_triangle/contacts.hpp"

namespace graze::GRAZE_ISA {

template <std::size_t part, class L>
[[gnu::always_inline]] inline PlacedTriangle<Lanes<double>> placed_in_double(const TriangleCore<L>& core,
                                                                             const Pose<L>& pose) {
  return {in_double<part>(core), Lanes<double>(0), in_double<part>(pose)};
}

/// The register type for a single pair's numbers of three corners.
using SingleRow = std::conditional_t<register_bytes >= 32, FourWide<double>, Packed<double, 3>>;

/// The distance of a single pair: compiled once for distances and contacts.
void measure(const TrianglesInUnits<double>& in, const TwoTriangles<SingleRow>& p, double enough,
             TriangleDistance<double>& found);

}  // namespace graze::GRAZE_ISA
