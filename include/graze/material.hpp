// Materials of surfaces, and the combined material of a contact.
//
// Guarantee: plain values, which `check` refuses where they make no sense. The order of the two materials does not
// change a bit.
#pragma once

#include "graze/vec3.hpp"

namespace graze {

/// Rules for combining a number of two materials. If the two rules differ, the one that stands first here counts, as in
/// KHR_physics_rigid_bodies; `unset` leaves it to the other material, and where both do it is the average.
enum class Combine { unset, average, minimum, maximum, multiply };

/// The material of a surface; with `plane::Vec2` as `Vec` of one in the plane.
template <class T, class Vec = Vec3<T>>
struct Material {
  T static_friction = T(0.6);                 ///< Coulomb's coefficient while the contact sticks; >= 0
  T dynamic_friction = T(0.6);                ///< Coulomb's coefficient while the contact slides; >= 0
  T restitution = T(0);                       ///< fraction of the approach speed that comes back; 0 to 1
  T rolling_friction = T(0);                  ///< the lever arm of the torque that resists rolling, as a length; >= 0
  Combine friction_combine = Combine::unset;  ///< rule for the friction of a contact
  /// Rule for the restitution of a contact.
  Combine restitution_combine = Combine::unset;
  Vec surface_velocity{};  ///< velocity of a conveyor's surface, in the body's frame
};

/// Refuses a material of which a number makes no sense. Throws `InvalidValue` that names it: frictions that are
/// negative or not finite, a restitution outside of 0 to 1, and a surface velocity that is not finite or too large.
template <class T, class Vec>
void check(const Material<T, Vec>& material);

/// The rule for two materials: the one that stands first in `Combine`, disregarding `unset`.
constexpr Combine combined(Combine a, Combine b) {
  if (a == Combine::unset || b == Combine::unset) return a == b ? Combine::average : a < b ? b : a;
  return a < b ? a : b;
}

/// Combines two numbers by a rule.
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

/// The combined material of a contact.
template <class T>
struct ContactMaterial {
  /// Combined coefficients, each as in `Material`.
  T static_friction{}, dynamic_friction{}, restitution{}, rolling_friction{};
};

/// The combined material of two. The larger rolling friction counts, since the softer body is pressed in.
template <class T, class Vec>
constexpr ContactMaterial<T> combined(const Material<T, Vec>& a, const Material<T, Vec>& b) {
  const Combine friction = combined(a.friction_combine, b.friction_combine);
  const Combine restitution = combined(a.restitution_combine, b.restitution_combine);
  return {combined(a.static_friction, b.static_friction, friction),
          combined(a.dynamic_friction, b.dynamic_friction, friction),
          combined(a.restitution, b.restitution, restitution), greatest(a.rolling_friction, b.rolling_friction)};
}

}  // namespace graze
