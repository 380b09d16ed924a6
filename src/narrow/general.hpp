// The general path: any two bounded convex shapes by GJK on their cores, and EPA where the cores overlap.
#pragma once

#include "graze/query.hpp"
#include "narrow/core.hpp"

namespace graze {

/// A signed distance of cores with its honesty.
struct GeneralDistance {
  CoreDistance<double> core;  ///< in the frame of A
  Status status;
  double error;
};

template <class T>
GeneralDistance general_distance(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, Trace* trace);

/// Whether the cores come within `reach` (the sum of the rounding radii) of each other.
template <class T>
bool general_overlap(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, double reach, Trace* trace);

/// The relative pose in double, whatever the scalar, its rotation of unit length to double's precision.
template <class T>
Posed relative_in_double(const Pose<T>& a, const Pose<T>& b) {
  const Quatd qa = normalized(cast<double>(a.rotation)), qb = normalized(cast<double>(b.rotation));
  return relative(Posed{cast<double>(a.translation), qa}, Posed{cast<double>(b.translation), qb});
}

}  // namespace graze
