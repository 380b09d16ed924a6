// Triangles as a file has them, before anything is made of them.
#pragma once

#include <vector>

#include "graze/shape.hpp"

namespace graze::io {

struct TriangleSoup {
  std::vector<Vec3d> points;
  std::vector<Mesh<double>::Index> triangles;
};

}  // namespace graze::io
