// Shapes as polygons, for pictures and for files that are looked at.
//
// Guarantee: any shape; points lie on its surface. What is flat is exact; what is curved is sampled finely enough for
// the eye and no finer.
#pragma once

#include <cstdint>
#include <vector>

#include "graze/shape.hpp"

namespace graze::io {

struct Polygons {
  std::vector<Vec3d> points;                      ///< in world space
  std::vector<std::vector<std::uint32_t>> loops;  ///< counter-clockwise seen from outside
  bool smooth = false;                            ///< its edges are of the sampling, not of the shape
  bool closed = true;                             ///< has an inside, so that faces seen from behind are hidden
};

/// A half-space is drawn as a square of `half_space_size` about the foot of `center`.
GRAZE_API Polygons tessellate(const Shaped& shape, const Posed& pose, const Vec3d& center, double half_space_size);

}  // namespace graze::io
