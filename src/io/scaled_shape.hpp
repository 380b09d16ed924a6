// A shape under the map of its node, which may scale it.
#pragma once

#include <string>

#include "graze/shape.hpp"
#include "io/affine.hpp"

namespace graze::io {

struct MappedShape {
  Shaped shape;
  Posed pose;
  std::string notice;  ///< the approximation and its error; empty when there is none
};

/// The mapped shape. A ball becomes an ellipsoid, a box a box, points are mapped one by one; a curved shape whose image
/// is none of the library's kinds turns into the hull of points on its surface, and the notice gives the error.
MappedShape mapped(const Shaped& shape, const Affine& map);

}  // namespace graze::io
