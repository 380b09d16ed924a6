// Tessellation: shapes as polygons, for pictures and for files that are looked at.
//
// Guarantee: any shape, of space or of the plane; points lie on its surface, those of the plane at z = 0. Flat parts
// are exact; curved ones are sampled finely enough for the eye and no finer; a shape that is a segment or a point is a
// loop of two points or of one. Costs memory and time for each point, and allocates: not for use pair by pair.
#pragma once

#include <cstdint>
#include <vector>

#include "graze/plane/shape.hpp"
#include "graze/shape.hpp"

namespace graze {

/// Faces as loops of points.
struct Polygons {
  std::vector<Vec3d> points;                      ///< in world space
  std::vector<std::vector<std::uint32_t>> loops;  ///< counter-clockwise seen from outside, or from z > 0; a segment has
                                                  ///< two points, a point one
  bool smooth = false;                            ///< whether edges come from the sampling, not from the shape
  bool closed = true;                             ///< whether there is an inside, so that faces seen from behind are
                                                  ///< hidden
};

/// The faces of a shape; a half-space is a square whose sides are twice `half_space_size`, about the foot of `center`.
template <class T>
GRAZE_API Polygons tessellate(const Shape<T>& shape, const Pose<T>& pose, const Vec3d& center, double half_space_size);

/// The outline of a shape of the plane; of a solid polygon without its cuts, so that a loop need not be convex. A
/// half-plane reaches `half_plane_size` to both sides of the foot of `center`, and is half as deep.
template <class T>
GRAZE_API Polygons tessellate(const plane::Shape<T>& shape, const plane::Pose2<T>& pose, const Vec3d& center,
                              double half_plane_size);

}  // namespace graze
