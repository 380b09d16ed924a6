// The result of EPA for two convex cores that overlap.
#pragma once

#include "graze/vec3.hpp"

namespace graze {

struct EpaResult {
  Vec3d normal;         ///< unit, from A to B
  Vec3d a, b;           ///< the deepest points: b - a = -upper * normal up to the tolerance
  double lower, upper;  ///< bounds of the depth; about zero where the cores merely touch
};

}  // namespace graze
