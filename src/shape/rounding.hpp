// The radius of the ball that is added to a core: a shape's own and its margin.
#pragma once

#include "graze/shape.hpp"

namespace graze {

template <class C, class T>
T rounding_radius(const C& concrete, T margin) {
  if constexpr (requires { concrete.core_radius(); })
    return concrete.core_radius() + margin;
  else
    return margin;
}

template <class T>
T rounding_radius(const Shape<T>& shape) {
  return shape.visit([&](const auto& concrete) { return rounding_radius(concrete, shape.margin()); });
}

}  // namespace graze
