// Casts of pairs that do not turn, of which every contact counts, a block at a time: of the list's pairs of bounded
// shapes, and of polygons of few vertices.
//
// Guarantee: a known answer has the bits of the cast of that pair alone at every level of the instruction set. Shapes
// that may touch at the start, hits that are next to the end of an edge, and velocities without a direction are not
// known, and are answered alone.
#pragma once

#include "plane/pairs/polygon_kernels.hpp"

namespace graze {

namespace plane {

/// Linear velocities of the shapes of a block.
struct MotionColumns {
  alignas(64) double a[2][block_pairs], b[2][block_pairs];
};
/// First contacts in the world; the time is infinite where there is none.
struct CastColumns {
  alignas(64) double known[block_pairs];
  double t[block_pairs], normal[2][block_pairs], point[2][block_pairs];
};

/// The kernels of the list's entries, in its order, with A and B as the entry has them and the other way round; null
/// where there is none, as of half-planes. Those of polygons, for at most four, six and eight vertices.
struct CastKernels {
  using OfEntry = void (*)(const PairColumns<block_pairs>&, const MotionColumns&, std::size_t count, CastColumns&);
  using OfPolygons = void (*)(const PolygonBlock&, const MotionColumns&, std::size_t count, CastColumns&);
  const OfEntry (*entries)[2];
  OfPolygons polygons;
  /// Whether polygons take less time in these kernels than alone: not two at a time.
  bool polygons_pay;
};

}  // namespace plane

GRAZE_DECLARE_KERNEL(const plane::CastKernels& plane_cast_kernels();)

}  // namespace graze
