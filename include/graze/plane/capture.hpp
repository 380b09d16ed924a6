// Captures of the plane: `graze/capture.hpp` with bodies of two dimensions.
//
// Guarantee: that of `graze/capture.hpp`, whose code it is; `graze::replay` plays these files too.
#pragma once

#include "graze/capture.hpp"

namespace graze::plane {

/// A `plane::World` whose calls are recorded.
template <class T>
using CapturedWorld = graze::CapturedWorld<T, Space<T>>;
/// A `plane::Simulation` whose calls are recorded.
template <class T>
using CapturedSimulation = graze::CapturedSimulation<T, Space<T>>;

}  // namespace graze::plane
