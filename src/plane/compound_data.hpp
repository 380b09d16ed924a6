// The data of a compound of the plane.
#pragma once

#include <vector>

#include "graze/plane/shape.hpp"
#include "shape/nesting.hpp"

namespace graze::plane {

template <class T>
struct CompoundData {
  std::vector<Placed<T>> children;
  Nesting nesting;
};

}  // namespace graze::plane
