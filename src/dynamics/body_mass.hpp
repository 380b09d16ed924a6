// What a body of a simulation weighs and how it is to turn: from its shape and what was said of it.
//
// Guarantee: the principal axes of a tensor that is diagonal are the axes of its frame, bit for bit; of any other they
// are found by Jacobi's rotations, in + - * / and sqrt alone.
#pragma once

#include "graze/dynamics.hpp"
#include "graze/pose.hpp"
#include "graze/shape.hpp"

namespace graze {

template <class T>
struct BodyMass {
  T mass{}, inverse_mass{};              ///< infinite and zero of what nothing pushes
  Vec3<T> inertia{}, inverse_inertia{};  ///< about the principal axes
  Pose<T> principal{};                   ///< centre of mass and principal axes, in the body's frame
};

/// Throws `InvalidValue` for what is no mass or inertia, and for a shape without volume that needs one.
template <class T>
BodyMass<T> body_mass(const Shape<T>& shape, const Dynamics<T>& dynamics, bool movable);

/// A symmetric tensor as a diagonal one in turned axes.
template <class T>
struct PrincipalAxes {
  Vec3<T> diagonal{};
  Quat<T> rotation{};
};

template <class T>
PrincipalAxes<T> principal_axes(const Mat3<T>& tensor);

}  // namespace graze
