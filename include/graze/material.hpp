// What surfaces are made of, and what two of them do together.
//
// Guarantee: plain values. Which of the two is first makes no difference to a bit.
#pragma once

#include "graze/vec3.hpp"

namespace graze {

/// How the numbers of two materials become one. Of two that differ, the one that stands first here counts, as in
/// KHR_physics_rigid_bodies; `unset` leaves it to the other material, and where both do it is the average.
enum class Combine { unset, average, minimum, maximum, multiply };

/// Of bodies of space, and with vectors of the plane of those of the plane.
template <class T, class Vec = Vec3<T>>
struct Material {
  T static_friction = T(0.6);                 ///< Coulomb's coefficient while nothing slides; >= 0
  T dynamic_friction = T(0.6);                ///< and while it does; >= 0
  T restitution = T(0);                       ///< of the speed of approach, what comes back; 0 to 1
  T rolling_friction = T(0);                  ///< the lever arm of the torque that resists rolling, as a length; >= 0
  Combine friction_combine = Combine::unset;  ///< how the friction of two materials becomes that of the contact
  /// How the restitution of two materials becomes that of the contact.
  Combine restitution_combine = Combine::unset;
  Vec surface_velocity{};  ///< of a conveyor, in the body's frame
};

/// The way in which two materials are combined.
constexpr Combine combined(Combine a, Combine b) {
  if (a == Combine::unset || b == Combine::unset) return a == b ? Combine::average : a < b ? b : a;
  return a < b ? a : b;
}

/// One number of two.
template <class T>
constexpr T combined(T a, T b, Combine how) {
  switch (how) {
  case Combine::minimum: return least(a, b);
  case Combine::maximum: return greatest(a, b);
  case Combine::multiply: return a * b;
  case Combine::unset:
  case Combine::average: break;
  }
  return a / T(2) + b / T(2);
}

/// What acts where two materials touch.
template <class T>
struct ContactMaterial {
  T static_friction{}, dynamic_friction{}, restitution{}, rolling_friction{};  ///< of the two together
};

/// The larger of the two rolling frictions counts: it is the softer body that is pressed in.
template <class T, class Vec>
constexpr ContactMaterial<T> combined(const Material<T, Vec>& a, const Material<T, Vec>& b) {
  const Combine friction = combined(a.friction_combine, b.friction_combine);
  const Combine restitution = combined(a.restitution_combine, b.restitution_combine);
  return {combined(a.static_friction, b.static_friction, friction),
          combined(a.dynamic_friction, b.dynamic_friction, friction),
          combined(a.restitution, b.restitution, restitution), greatest(a.rolling_friction, b.rolling_friction)};
}

}  // namespace graze
