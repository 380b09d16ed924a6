// Polygons as arguments of the kernels of their edges' axes, and bounds for the rounding of these kernels.
#pragma once

#include <limits>

#include "plane/core.hpp"
#include "plane/edge_axes.hpp"

namespace graze::plane {

/// The kernels of the level that the machine runs at.
inline const EdgeAxesKernels& axes_kernels() {
  static const EdgeAxesKernels& chosen = GRAZE_KERNEL(chosen_isa(), plane_edge_axes)();
  return chosen;
}
template <class T>
AxesPolygon<T> axes_polygon(const Core<T>& core) {
  return {core.outside ? core.outside : core.inside.data(), core.count};
}

/// The error of the kernel's heights of edges below the origin, relative to the numbers they are made of: floats, of
/// which the vertices are off by three units (a rotation and a sum), the directions of edges by four, the two products
/// across and their differences by three more, the inverse of the length by three, and the sum with a radius, which is
/// no larger than the sizes, by two. Two heights are compared.
inline constexpr double height_rounding = 32 * double(std::numeric_limits<float>::epsilon());

/// Sizes whose squares floats hold with all their digits, and those of parts a thousandth as large.
inline constexpr double least_size = 1e-14, most_size = 1e14;

/// The error that the kernel's heights may have, of polygons with vertices no further than `size` from their origins.
inline double axes_slack(const Pose2d& b_in_a, double size) {
  return height_rounding * (size + size + max_abs(b_in_a.translation));
}

/// Whether the kernels take two polygons: few vertices, one with an inside, and sizes in the range of floats.
template <class T>
bool axes_take(const Core<T>& a, const Core<T>& b, double slack, double size) {
  return a.count <= most_edges && b.count <= most_edges && (a.count > 2 || b.count > 2) && size >= least_size &&
         slack <= height_rounding * most_size;
}

}  // namespace graze::plane
