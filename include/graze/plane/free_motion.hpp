// Free motion of a rigid body of the plane: falling and turning without contact.
//
// Guarantee: that of `graze/free_motion.hpp`. The angular momentum is the state, and a step without torque does not
// touch it; nor does it change the angular velocity in the plane, so that the orientation is exact up to rounding,
// however large the step. Only + - * / and sqrt, so that every machine gives the same bits.
#pragma once

#include "graze/plane/contact_motion.hpp"

namespace graze::plane {

/// A body in free motion, its frame at the centre of mass.
template <class T>
struct FreeBody {
  Vec2<T> center{};      ///< centre of mass
  Rot2<T> rotation{};    ///< orientation of the body
  Vec2<T> linear{};      ///< velocity of the centre of mass
  T angular_momentum{};  ///< about the centre of mass
  T inverse_inertia{};   ///< zero for a body that does not turn
};

/// The angular velocity in radians per unit of time, from the angular momentum.
template <class T>
T angular_velocity(const FreeBody<T>& body) {
  return body.angular_momentum * body.inverse_inertia;
}

/// Sets the angular momentum from an angular velocity; zero for a body that does not turn.
template <class T>
void set_angular_velocity(FreeBody<T>& body, const T& angular) {
  body.angular_momentum = body.inverse_inertia > T(0) ? angular / body.inverse_inertia : T(0);
}

/// The kinetic energy of the rotation.
template <class T>
T rotational_energy(const FreeBody<T>& body) {
  return body.angular_momentum * angular_velocity(body) / T(2);
}

/// The rotation by `angle` radians as steps of a simulation turn bodies, in `T`, where `Rot2::from_angle` computes in
/// double. An angle that is not finite gives the identity. Costs a product for each power of two in the angle.
template <class T>
GRAZE_API Rot2<T> rotation_by(T angle);

/// Moves the body by `duration` (finite, of either sign) under a constant `acceleration` and without torque.
template <class T>
GRAZE_API void advance(FreeBody<T>& body, const Vec2<T>& acceleration, T duration);

}  // namespace graze::plane
