// What a simulation has to know of a space beyond what a world does: how bodies turn, and what resists that.
//
// Guarantee: `Simulation` and all that it is made of are written once, over `Space` and this trait of it; `Rigid` of
// `graze::Space` is that of three dimensions, of `plane::Space` (`graze/plane/rigid.hpp`) that of two, where a turning
// and an inertia are numbers.
#pragma once

#include "graze/dynamics.hpp"
#include "graze/free_motion.hpp"
#include "graze/mass.hpp"
#include "graze/world/space.hpp"

namespace graze {

template <class Space>
struct Rigid;

/// The words of motion in space.
template <class T>
struct Rigid<Space<T>> {
  using Rotation = Quat<T>;
  using Motion = graze::Motion<T>;
  using FreeBody = graze::FreeBody<T>;
  using PrincipalInertia = Vec3<T>;  ///< about the principal axes
  using Inertia = Mat3<T>;           ///< in world space
  using InverseMass = graze::InverseMass<T>;
  using Dynamics = graze::Dynamics<T>;
};

}  // namespace graze
