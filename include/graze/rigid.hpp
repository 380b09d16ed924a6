// A space's types of rigid body motion, which a simulation needs beyond those of a world: rotations and inertias.
//
// Guarantee: `Simulation` and its parts are written once, over `Space` and this trait of it. `Rigid` of `graze::Space`
// is the trait of three dimensions, that of `plane::Space` (`graze/plane/rigid.hpp`) the trait of two, where rotations
// and inertias are numbers.
#pragma once

#include "graze/dynamics.hpp"
#include "graze/free_motion.hpp"
#include "graze/mass.hpp"
#include "graze/world/space.hpp"

namespace graze {

template <class Space>
struct Rigid;

/// The types of rigid body motion in space.
template <class T>
struct Rigid<Space<T>> {
  using Rotation = Quat<T>;
  using Motion = graze::Motion<T>;
  using FreeBody = graze::FreeBody<T>;
  using PrincipalInertia = Vec3<T>;  ///< moments about the principal axes
  using Inertia = Mat3<T>;           ///< tensor in world space
  using InverseMass = graze::InverseMass<T>;
  using Dynamics = graze::Dynamics<T>;
};

}  // namespace graze
