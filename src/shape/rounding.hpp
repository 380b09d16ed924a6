// The radius of the ball that is added to a core: a shape's own and its rounding.
#pragma once

#include "graze/shape.hpp"

namespace graze {

template <class C, class T>
T rounding_radius(const C& concrete, T rounding) {
  if constexpr (requires { concrete.core_radius(); })
    return concrete.core_radius() + rounding;
  else
    return rounding;
}

template <class T>
T rounding_radius(const Shape<T>& shape) {
  return shape.visit([&](const auto& concrete) { return rounding_radius(concrete, shape.rounding()); });
}

}  // namespace graze
