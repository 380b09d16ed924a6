// The data of a compound.
//
// Guarantee: every child is in the tree or, when its bounds are not finite (a half-space), among `unbounded`.
#pragma once

#include "graze/shape.hpp"
#include "shape/nesting.hpp"
#include "shape/wide_tree.hpp"

namespace graze {

template <class T>
struct CompoundData {
  std::vector<Placed<T>> children;
  std::vector<Aabb<T>> boxes;  ///< the children's, in the compound's frame
  WideTree<T> tree;
  std::vector<std::uint32_t> unbounded;
  T extent = T(0);  ///< no point of a child is further from the frame's origin
  Nesting nesting;
  bool solid = false;  ///< has a solid mesh among its children, or theirs
};

}  // namespace graze
