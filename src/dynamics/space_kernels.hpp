// Kernels of a kind for both spaces and scalars.
#pragma once

#include <type_traits>

#include "dynamics/rigid_space.hpp"

namespace graze {

template <template <class T, class Space> class Kernels>
struct SpaceKernels {
  Kernels<float, Space<float>> space_float;
  Kernels<double, Space<double>> space_double;
  Kernels<float, plane::Space<float>> plane_float;
  Kernels<double, plane::Space<double>> plane_double;

  template <class T, class S>
  const Kernels<T, S>& of() const {
    if constexpr (std::is_same_v<S, Space<float>>)
      return space_float;
    else if constexpr (std::is_same_v<S, Space<double>>)
      return space_double;
    else if constexpr (std::is_same_v<S, plane::Space<float>>)
      return plane_float;
    else
      return plane_double;
  }
};

}  // namespace graze
