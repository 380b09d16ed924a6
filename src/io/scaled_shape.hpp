// A shape under the map of its node: what it becomes when it is scaled.
#pragma once

#include <string>

#include "graze/shape.hpp"
#include "io/affine.hpp"

namespace graze::io {

struct MappedShape {
  Shaped shape;
  Posed pose;
  std::string notice;  ///< what was approximated and by how much; empty when nothing was
};

/// A ball becomes an ellipsoid, a box a box, points are mapped one by one; a curved shape that has no name for what it
/// becomes turns into the hull of points on its surface, and the notice says how far off that is.
MappedShape mapped(const Shaped& shape, const Affine& map);

}  // namespace graze::io
