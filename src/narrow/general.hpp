// The general path: any two bounded convex shapes by GJK on their cores, and EPA where the cores overlap; sums of boxes
// and ellipsoids by Newton's descent on their closed forms where that is proven.
#pragma once

#include <optional>

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/core/core.hpp"
#include "narrow/core/minkowski.hpp"
#include "shape/rounding.hpp"

namespace graze {

/// The size of a pair: the larger radius about a shape's own origin, among the bounded shapes.
template <class T>
double pair_size(const Shape<T>& a, const Shape<T>& b) {
  const auto extent = [](const Shape<T>& shape) {
    return shape.visit([&](const auto& c) {
      if constexpr (BoundedConvex<std::decay_t<decltype(c)>>)
        return static_cast<double>(c.core_extent()) + static_cast<double>(rounding_radius(c, shape.rounding()));
      else
        return 0.0;
    });
  };
  return greatest(extent(a), extent(b));
}

/// Rounding of the distance of a pair of that size: relative to its largest coordinate, in the frame of A.
inline double noise_of(double pair_size, const Vec3d& translation) {
  return rounding_error * (pair_size + max_abs(translation));
}
template <class T>
double noise_of(const Shape<T>& a, const Shape<T>& b, const Vec3d& translation) {
  return noise_of(pair_size(a, b), translation);
}

/// A signed distance of cores with its error bound.
struct GeneralDistance {
  CoreDistance<double> core;  ///< in the frame of A
  Status status;
  double error;
  double noise;  ///< rounding of the distance, see `noise_of`
};

/// The distance of the cores. Those further apart than `limit` are only proven to be: the distance is then a lower
/// bound beyond it, along its normal, and the points are not the closest ones.
template <class T>
GeneralDistance general_distance(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a,
                                 double limit = std::numeric_limits<double>::infinity());

/// Whether the cores come within `reach` (the sum of the rounding radii) of each other; nothing where the search ends
/// before it tells, as of smooth shapes that touch by their roundings: the distance does.
template <class T>
std::optional<bool> general_overlap(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, double reach);

/// A pose in double, whatever the scalar, its rotation of unit length to double's precision.
template <class T>
Posed in_double(const Pose<T>& pose) {
  const Quatd q = converted<double>(pose.rotation);
  const double scale = 1 / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return {converted<double>(pose.translation), {q.x * scale, q.y * scale, q.z * scale, q.w * scale}};
}

template <class T>
Posed relative_in_double(const Pose<T>& a, const Pose<T>& b) {
  return relative(in_double(a), in_double(b));
}

}  // namespace graze
