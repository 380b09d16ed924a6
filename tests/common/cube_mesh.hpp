// A closed mesh that is easily seen through: a cube about the origin.
#pragma once

#include <vector>

#include "graze/shape/mesh.hpp"

namespace graze::testing {

template <class T>
Mesh<T> cube_mesh(T half, bool solid) {
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half});
  return {points,
          {{0, 2, 1},
           {1, 2, 3},
           {4, 5, 6},
           {5, 7, 6},
           {0, 1, 4},
           {1, 5, 4},
           {2, 6, 3},
           {3, 6, 7},
           {0, 4, 2},
           {2, 4, 6},
           {1, 3, 5},
           {3, 7, 5}},
          Sides::both,
          solid};
}

}  // namespace graze::testing
