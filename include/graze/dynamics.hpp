// Dynamics of a body of a simulation: its mass, centre of mass and inertia, damping and control.
//
// Guarantee: a plain value. Omitted values follow from the shape. `Simulation::add` throws `InvalidValue` for values
// that are neither a mass nor an inertia, naming them.
#pragma once

#include <optional>

#include "graze/quat.hpp"

namespace graze {

/// The motion of a body, as KHR_physics_rigid_bodies describes it. Lengths, masses and times are in the caller's units.
template <class T>
struct Dynamics {
  /// Mass, > 0; infinite for a body that impulses do not change: it keeps its velocity, gravity included. By default
  /// the volume of the shape times `density`; required for a shape without volume that is neither fixed nor kinematic.
  /// A trigger without it keeps its velocity, whatever its density.
  std::optional<T> mass;
  std::optional<Vec3<T>> center_of_mass;  ///< in the body's frame; by default that of the shape
  /// Moments of inertia about the axes of `inertia_orientation` through the centre of mass: each > 0, infinite for an
  /// axis about which the body does not turn; of three finite ones none larger than the sum of the others. By default
  /// those of the shape, filled evenly with the mass, even about another centre of mass.
  std::optional<Vec3<T>> inertia_diagonal;
  Quat<T> inertia_orientation{};  ///< in the body's frame; of no effect without `inertia_diagonal`
  T density = T(1000);            ///< > 0
  T gravity_factor = T(1);        ///< times the simulation's gravity
  T linear_damping = T(0);        ///< >= 0, per unit of time: a velocity v falls as v' = -damping v
  T angular_damping = T(0);       ///< >= 0, per unit of time: damping of the angular velocity
  bool kinematic = false;         ///< keeps its given velocity: pushes other bodies and is not pushed
  bool may_sleep = true;          ///< sleeps with its island where nothing in it moves
};

}  // namespace graze
