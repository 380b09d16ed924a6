// Relative motion of two bodies of the plane at a point of contact, the first step of a contact solver.
//
// Guarantee: that of `graze/contact_motion.hpp`: exact up to rounding for rigid motions; a few operations a call.
#pragma once

#include "graze/plane/query.hpp"

namespace graze::plane {

/// The velocity of a point that lies `arm` from the centre of a rotation at the rate `turning`.
template <class T>
constexpr Vec2<T> cross(const T& turning, const Vec2<T>& arm) {
  return {-turning * arm.y, turning * arm.x};
}

/// The motion of a rigid body: the velocity of its centre of mass, and its rotation about that.
template <class T>
struct Motion {
  Vec2<T> linear{};  ///< velocity of the centre of mass
  T angular{};       ///< radians per unit of time, counter-clockwise
  Vec2<T> center{};  ///< centre of mass
};

/// The velocity of the body's material point at `point`.
template <class T>
Vec2<T> velocity_at(const Motion<T>& motion, const Vec2<T>& point) {
  return motion.linear + cross(motion.angular, point - motion.center);
}

/// The velocity of B relative to A at a contact, in two parts.
template <class T>
struct RelativeVelocity {
  Vec2<T> whole{};       ///< the velocity of B against A
  T normal{};            ///< along the contact normal: negative while the bodies approach
  Vec2<T> tangential{};  ///< the rest: the sliding that friction resists
};

/// The relative velocity at the contact's `position()`. `normal` is the manifold's, from A to B.
template <class T>
RelativeVelocity<T> relative_velocity(const ContactPoint<T>& contact, const Vec2<T>& normal, const Motion<T>& a,
                                      const Motion<T>& b) {
  const Vec2<T> point = contact.position();
  RelativeVelocity<T> v;
  v.whole = velocity_at(b, point) - velocity_at(a, point);
  v.normal = dot(v.whole, normal);
  v.tangential = v.whole - normal * v.normal;
  return v;
}

}  // namespace graze::plane
