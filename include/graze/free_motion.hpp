// Free motion of a rigid body: falling and turning without contact.
//
// Guarantee: the angular momentum is the state, in world space, and a step without torque does not touch it: its length
// and direction stay bit for bit. The centre of mass moves exactly, up to rounding, under a constant acceleration. The
// orientation is of fourth order in the angle of a step, which is divided until the angle is small: a book that tumbles
// about its middle axis at 30 rad/s for 20 s, in steps of 1/60 s, keeps its energy within 1e-5 in float and 1e-7 in
// double. Only + - * / and sqrt, so that every machine gives the same bits.
#pragma once

#include "graze/contact_motion.hpp"
#include "graze/quat.hpp"

namespace graze {

/// A body in free motion. Its frame has the principal axes of inertia as its axes and the centre of mass as its origin.
template <class T>
struct FreeBody {
  Vec3<T> center{};            ///< centre of mass, in world space
  Quat<T> rotation{};          ///< orientation of the principal axes in world space
  Vec3<T> linear{};            ///< velocity of the centre of mass
  Vec3<T> angular_momentum{};  ///< about the centre of mass, in world space
  Vec3<T> inverse_inertia{};   ///< about the principal axes; zero where the body does not turn
};

/// The angular velocity in world space.
template <class T>
GRAZE_API Vec3<T> angular_velocity(const FreeBody<T>& body);

/// Sets the angular momentum from an angular velocity in world space. Rotation about an axis of zero inverse inertia is
/// left out.
template <class T>
GRAZE_API void set_angular_velocity(FreeBody<T>& body, const Vec3<T>& angular);

/// The motion of the body, for the functions of contact_motion.hpp.
template <class T>
Motion<T> motion_of(const FreeBody<T>& body) {
  return {body.linear, angular_velocity(body), body.center};
}

/// The kinetic energy of the rotation.
template <class T>
T rotational_energy(const FreeBody<T>& body) {
  return dot(body.angular_momentum, angular_velocity(body)) / T(2);
}

/// Moves the body by `duration` (finite, of either sign) under a constant `acceleration` and without torque.
/// Costs a step of rotation for every tenth of a radian, and at most `most_rotation_steps`.
template <class T>
GRAZE_API void advance(FreeBody<T>& body, const Vec3<T>& acceleration, T duration);

/// Largest number of steps of rotation; a body that turns further in one call keeps its angular momentum, and loses
/// accuracy in its orientation.
inline constexpr int most_rotation_steps = 64;

}  // namespace graze
