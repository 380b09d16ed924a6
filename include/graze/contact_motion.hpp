// Relative motion of two bodies at a point of contact, the first step of a contact solver.
//
// Guarantee: exact up to rounding for rigid motions; a few operations a call, no state. Velocities are in units of
// length per unit of time, angles in radians, everything in world space.
#pragma once

#include "graze/contact.hpp"

namespace graze {

/// The motion of a rigid body: the velocity of its centre of mass, and its rotation about that.
template <class T>
struct Motion {
  Vec3<T> linear{};   ///< velocity of the centre of mass
  Vec3<T> angular{};  ///< angular velocity: along the axis, right-handed, its length the rate
  Vec3<T> center{};   ///< centre of mass
};

/// The velocity of the body's material point at `point`.
template <class T>
Vec3<T> velocity_at(const Motion<T>& motion, const Vec3<T>& point) {
  return motion.linear + cross(motion.angular, point - motion.center);
}

/// The velocity of B relative to A at a contact, in two parts.
template <class T>
struct RelativeVelocity {
  Vec3<T> whole{};       ///< the velocity of B against A
  T normal{};            ///< along the contact normal: negative while the bodies approach
  Vec3<T> tangential{};  ///< the rest: the sliding that friction resists
};

/// The relative velocity at the contact's `position()`. `normal` is the manifold's, from A to B.
template <class T>
RelativeVelocity<T> relative_velocity(const ContactPoint<T>& contact, const Vec3<T>& normal, const Motion<T>& a,
                                      const Motion<T>& b) {
  const Vec3<T> point = contact.position();
  RelativeVelocity<T> v;
  v.whole = velocity_at(b, point) - velocity_at(a, point);
  v.normal = dot(v.whole, normal);
  v.tangential = v.whole - normal * v.normal;
  return v;
}

/// The bodies that move into the other one.
enum class AtFault { neither, a, b, both };

/// The bodies that drive an approach: those whose own velocity at the contact leads into the other. `neither` for
/// bodies that rest on each other or part.
template <class T>
AtFault at_fault(const ContactPoint<T>& contact, const Vec3<T>& normal, const Motion<T>& a, const Motion<T>& b) {
  const T of_a = dot(velocity_at(a, contact.position()), normal);
  const T of_b = dot(velocity_at(b, contact.position()), normal);
  if (!(of_b < of_a)) return AtFault::neither;
  const bool into_b = of_a > T(0), into_a = of_b < T(0);
  return into_a && into_b ? AtFault::both : into_b ? AtFault::a : AtFault::b;
}

}  // namespace graze
