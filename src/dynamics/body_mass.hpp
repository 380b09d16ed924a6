// The mass and inertia of a body of a simulation, from its shape and its `Dynamics`.
//
// Guarantee: the principal axes of a tensor that is diagonal are the axes of its frame, bit for bit; those of any other
// are found by Jacobi's rotations, in + - * / and sqrt alone.
#pragma once

#include "graze/plane/rigid.hpp"
#include "graze/rigid.hpp"

namespace graze {

template <class T, class Space>
struct BodyMass {
  using Inertia = typename Rigid<Space>::PrincipalInertia;

  T mass{}, inverse_mass{};              ///< infinite and zero of a body that nothing pushes
  Inertia inertia{}, inverse_inertia{};  ///< about the principal axes
  typename Space::Pose principal{};      ///< centre of mass and principal axes, in the body's frame
};

/// The mass of a body. Throws `InvalidValue` for a mass or inertia that is none, and for a shape without volume (in the
/// plane, area) that needs one.
template <class T>
BodyMass<T, Space<T>> body_mass(const Shape<T>& shape, const Dynamics<T>& dynamics, bool movable);
template <class T>
BodyMass<T, plane::Space<T>> body_mass(const plane::Shape<T>& shape, const plane::Dynamics<T>& dynamics, bool movable);

/// A symmetric tensor as a diagonal one in turned axes.
template <class T>
struct PrincipalAxes {
  Vec3<T> diagonal{};
  Quat<T> rotation{};
};

template <class T>
PrincipalAxes<T> principal_axes(const Mat3<T>& tensor);

}  // namespace graze
