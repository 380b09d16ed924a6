// Pairs of polygons of few vertices beside each other, a block at a time: the pair list has no closed form for them.
//
// Guarantee: the nearest points and the manifold of `nearest_by_axes` and `manifold`, operation by operation, so that
// the bits are those of a pair alone at every level of the instruction set. A lane that would have to choose among
// edges that lie within rounding of each other, and one with lengths near the ends of the numbers' range, is not known,
// and is answered alone.
#pragma once

#include "plane/pairs/pair_kernels.hpp"

namespace graze {

namespace plane {

/// Vertices of a polygon that the kernels take.
inline constexpr std::size_t lane_vertices = 8;

/// One polygon of each pair in place: its pose, and its vertices counter-clockwise in its own frame, with the first one
/// again behind the last.
struct PolygonColumns {
  alignas(64) double pose[shape_columns][block_pairs];  ///< of which the first four are used
  double x[lane_vertices][block_pairs], y[lane_vertices][block_pairs];
  double count[block_pairs], radius[block_pairs];
  std::size_t most = 0;  ///< vertices of any of them
};
struct PolygonBlock {
  PolygonColumns a, b;
};

/// A kernel that loads polygons. Each row is the place of a polygon's vertices, of which eight can be read whether
/// there are as many or not. Rows behind `count`, up to the next full register, repeat the last.
template <class T>
using LoadPolygons = void (*)(const Vec2<T>* const* rows, std::size_t count, PolygonColumns& to);

/// The kernels for both scalars.
struct PolygonKernels {
  /// Whether a pair takes less time in these kernels than alone. Few lanes do not make up for computing every
  /// alternative; and no number of them does for the overlap, for which a pair alone compares its edges beside each
  /// other in floats, so there is no kernel for it.
  bool distances_pay, contacts_pay;
  void (*distances)(const PolygonBlock&, std::size_t count, DistanceColumns<block_pairs>&);
  void (*contacts)(const PolygonBlock&, std::size_t count, const double (&margins)[block_pairs],
                   ContactColumns<block_pairs>&);
  LoadPolygons<float> load_of_float;
  LoadPolygons<double> load_of_double;
};

}  // namespace plane

GRAZE_DECLARE_KERNEL(const plane::PolygonKernels& plane_polygon_kernels();)

}  // namespace graze
