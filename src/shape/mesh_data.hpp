// What a mesh is made of.
//
// Guarantee: indices are in range; the tree covers every triangle.
#pragma once

#include "graze/shape/mesh.hpp"
#include "shape/bounds_tree.hpp"

namespace graze {

template <class T>
struct MeshData {
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  BoundsTree<T> tree;
  T extent = T(0);  ///< the greatest distance of a point from the frame's origin
};

}  // namespace graze
