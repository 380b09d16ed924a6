// Collision response: the motions of two bodies after they have met at a point.
//
// Guarantee: the closed form for rigid bodies, up to rounding. Momentum and angular momentum of the two together are
// conserved; a pair that parts is left alone bit for bit; with a restitution of at most 1 and without friction kinetic
// energy does not grow. No state, no allocation, a few hundred operations.
//
// The method is Newton's law of impact with Coulomb's law of friction (Mirtich 1996, chapter 3; Baraff 1997, part II).
// With r the point seen from a centre of mass, B's material point moves relative to A's with
//
//     v = (v_B + w_B × r_B) - (v_A + w_A × r_A),
//
// and an impulse p on B at the point, with -p on A, changes that by K p, where K is symmetric and positive definite:
//
//     K p = p/m_A + p/m_B + (I_A⁻¹ (r_A × p)) × r_A + (I_B⁻¹ (r_B × p)) × r_B.
//
// The normal impulse is j = max(0, -(1 + restitution) v·n / n·K n). Friction acts on the sliding that is left once j
// has been applied: the impulse in the tangent plane that would end it, shortened to friction · j where it is longer.
#pragma once

#include "graze/rigid.hpp"

namespace graze {

/// A body in a collision.
template <class T, class Space = graze::Space<T>>
struct StruckBody {
  typename Rigid<Space>::Motion motion{};     ///< velocities and centre of mass
  typename Rigid<Space>::InverseMass mass{};  ///< inverse mass and inertia
};

/// A contact of two bodies, in world space.
template <class T>
struct StruckContact {
  Vec3<T> point{};       ///< the point of contact
  Vec3<T> normal{};      ///< unit, from A to B
  T restitution = T(0);  ///< fraction of the approach speed that comes back, 0 to 1
  T friction = T(0.6);   ///< Coulomb's coefficient
};

/// The response of two bodies, and the quantities that lead to it in the order in which they are computed.
template <class T>
struct Response {
  RelativeVelocity<T> approach{};       ///< velocity of B relative to A before the impact
  AtFault at_fault = AtFault::neither;  ///< body whose own velocity leads into the other
  T effective_mass{};                   ///< 1 / n·K n: the inertia along the normal; infinite for two immovable bodies
  T normal_impulse{};                   ///< j >= 0
  Vec3<T> sliding{};                    ///< the tangential velocity that j leaves
  Vec3<T> stopping_impulse{};           ///< in the tangent plane: would end the sliding
  T friction_limit{};                   ///< friction · j: the radius of Coulomb's cone at j
  Vec3<T> friction_impulse{};           ///< the stopping impulse, no longer than the limit
  Vec3<T> impulse{};                    ///< on B at the point, normal and friction together; A's is its opposite
  Motion<T> a{}, b{};                   ///< motions after the impact

  /// Whether friction ended the sliding.
  bool holds() const { return friction_impulse == stopping_impulse; }
};

/// The motion of a body after `impulse` at `point`.
template <class T, class Space>
GRAZE_API typename Rigid<Space>::Motion
apply_impulse(const StruckBody<T, Space>& body, const typename Space::Vec& impulse, const typename Space::Vec& point);

/// The response of two bodies that meet at `contact`. Two immovable bodies go on as they are.
template <class T>
GRAZE_API Response<T> response(const StruckContact<T>& contact, const StruckBody<T>& a, const StruckBody<T>& b);

/// The kinetic energy of a body of `mass` and of inertia `inertia` (about its centre of mass, in world space).
template <class T>
T kinetic_energy(const Motion<T>& motion, T mass, const Mat3<T>& inertia) {
  return (length_squared(motion.linear) * mass + dot(motion.angular, inertia * motion.angular)) / T(2);
}

}  // namespace graze
