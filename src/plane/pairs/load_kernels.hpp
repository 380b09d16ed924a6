// Shapes and poses of the plane brought from where they stand into columns of doubles.
//
// Guarantee: the numbers are those that a pair alone is loaded as; nothing behind a shape or a pose is read.
#pragma once

#include "graze/plane/cast.hpp"
#include "plane/pairs/lane_shape.hpp"
#include "plane/pairs/pair_kernels.hpp"

namespace graze {

namespace plane {

/// Columns of a block of shapes in place.
using BlockColumns = double[shape_columns][block_pairs];

/// Kernels that read `count` rows, up to the next full register: rows behind `count` repeat the last.
template <class T>
struct LoadKernels {
  void (*poses)(const Pose2<T>* const* rows, std::size_t count, BlockColumns& to);
  /// Sizes and radii, without `Shape::rounding`, of shapes of a kind by its place in `ShapeList`; null without a core.
  std::array<void (*)(const void* const* rows, std::size_t count, BlockColumns& to), Shape<T>::count> shapes;
  /// Linear velocities.
  void (*velocities)(const Velocity<T>* const* rows, std::size_t count, double (&to)[2][block_pairs]);
};

/// The kernels for both scalars.
struct AllLoadKernels {
  LoadKernels<float> of_float;
  LoadKernels<double> of_double;

  template <class T>
  const LoadKernels<T>& of() const {
    if constexpr (std::is_same_v<T, float>)
      return of_float;
    else
      return of_double;
  }
};

}  // namespace plane

GRAZE_DECLARE_KERNEL(const plane::AllLoadKernels& plane_load_kernels();)

}  // namespace graze
