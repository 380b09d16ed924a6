// The trait `graze::Rigid` of two dimensions: rotations and inertias are numbers.
#pragma once

#include "graze/plane/dynamics.hpp"
#include "graze/plane/free_motion.hpp"
#include "graze/plane/space.hpp"
#include "graze/rigid.hpp"

namespace graze {

namespace plane {

/// The inverse of a body's mass and of its inertia about the centre of mass. By default immovable.
template <class T>
struct InverseMass {
  T mass{}, inertia{};  ///< inverse mass and inertia; 0 for an immovable body

  /// Whether an impulse changes the body's motion.
  bool movable() const { return mass > T(0); }
};

}  // namespace plane

/// The types of rigid body motion in the plane.
template <class T>
struct Rigid<plane::Space<T>> {
  using Rotation = plane::Rot2<T>;
  using Motion = plane::Motion<T>;
  using FreeBody = plane::FreeBody<T>;
  using PrincipalInertia = T;
  using Inertia = T;
  using InverseMass = plane::InverseMass<T>;
  using Dynamics = plane::Dynamics<T>;
};

}  // namespace graze
