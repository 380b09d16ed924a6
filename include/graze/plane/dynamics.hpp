// How a body of the plane is moved: its mass, where that lies, and who moves it.
//
// Guarantee: a plain value. What is left out follows from the shape. `Simulation::add` throws `InvalidValue` for what
// is neither a mass nor an inertia, naming it.
#pragma once

#include <optional>

#include "graze/plane/vec2.hpp"

namespace graze::plane {

/// As `graze::Dynamics`, with a number for the inertia. Lengths, masses and times are in the caller's units.
template <class T>
struct Dynamics {
  /// > 0. Infinite for a body that nothing pushes: it keeps its velocity, gravity included. By default the area of
  /// the shape times `density`; a shape without area that is neither fixed nor kinematic has to be given one.
  std::optional<T> mass;
  std::optional<Vec2<T>> center_of_mass;  ///< in the body's frame; by default that of the shape
  /// About the centre of mass: > 0, infinite for a body that does not turn. By default that of the shape, filled evenly
  /// with the mass; about another centre of mass, too.
  std::optional<T> inertia;
  T density = T(1000);       ///< > 0, mass per area
  T gravity_factor = T(1);   ///< times the simulation's gravity
  T linear_damping = T(0);   ///< >= 0, per unit of time: a velocity v falls as v' = -damping v
  T angular_damping = T(0);  ///< the same of the turning
  bool kinematic = false;    ///< keeps the velocity that it is given: pushes and is not pushed
  bool may_sleep = true;     ///< sleeps with its island where nothing in it moves
};

}  // namespace graze::plane
