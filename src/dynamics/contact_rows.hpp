// The rows of contacts: a row along the normal for each point, and for each manifold friction at its pressure centre:
// two rows on a round cone, a twist about the normal, and rolling.
//
// Guarantee: normal impulses push, friction stays in Coulomb's cone of the normal impulses of the same pass, in the
// passes with and without bias alike. Only + - * / and sqrt; rows are solved in their own order.
#pragma once

#include <span>
#include <vector>

#include "dynamics/solver_body.hpp"
#include "graze/material.hpp"
#include "graze/world/manifolds.hpp"

namespace graze {

/// A point of contact.
template <class T>
struct PointRow {
  Vec3<T> arm_a{}, arm_b{};    ///< from the centres of mass, where contacts were found
  Vec3<T> turn_a{}, turn_b{};  ///< arm × normal
  Vec3<T> spin_a{}, spin_b{};  ///< what an impulse of 1 does to the angular velocities
  T separation{};              ///< where contacts were found
  T effective_mass{};
  T impulse{};   ///< λ of a sub-step, >= 0
  T distance{};  ///< from the pressure centre
};

/// Points that share a normal.
template <class T>
struct ManifoldRows {
  std::uint32_t a{}, b{};  ///< places in the island
  std::uint32_t first_row{}, row_count{};
  std::uint32_t first_point{};  ///< in the world
  Vec3<T> normal{}, u{}, v{};   ///< from A to B, and two directions across it
  Vec3<T> arm_a{}, arm_b{};     ///< of the pressure centre
  T friction_mass[3]{};         ///< the inverse of the 2×2 block of u and v: uu, uv, vv
  T friction_u{}, friction_v{};
  T twist_mass{}, twist{};
  Vec3<T> rolling{};
  T belt_u{}, belt_v{};  ///< how the surface of B runs over that of A by itself
  T size{};              ///< the smaller of the two bodies
  T inverse_mass{};      ///< of both together
  ContactMaterial<T> material{};
};

/// How rows of contacts recover depth in a sub-step.
template <class T>
struct ContactStep {
  SubStep<T> time{};
  Softness<T> soft{};
  T gravity{};
};

/// The springs of a sub-step of h: their period is six sub-steps, damped far beyond the critical, so that nothing
/// swings (Catto 2024). Stiffer ones against what does not give, as Catto has them, shake heavy bodies that lie on
/// light ones.
template <class T>
ContactStep<T> contact_step(const SubStep<T>& time, T gravity);

/// How deep a contact of two free masses stands under a steady `force`, both `inverse_mass`es together.
template <class T>
T predicted_sink(T force, T inverse_mass, T h);

/// The bodies of a manifold and what acts between them.
template <class T>
struct TouchingBodies {
  std::uint32_t a{}, b{};
  ContactMaterial<T> material{};
  Vec3<T> surface_a{}, surface_b{};  ///< velocities of conveyors, in world space
  T size{};
};

/// The rows of a manifold: its own, of which `own` are those of its points, at `first_row` of the island's. `share` is
/// what part of a point's impulse a sub-step has.
template <class T>
ManifoldRows<T> prepare(const TouchingBodies<T>& touching, std::span<const SolverBody<T>> bodies,
                        const ContactManifold<T>& manifold, std::span<const SolverPoint<T>> points, T share,
                        std::uint32_t first_row, std::span<PointRow<T>> own);

template <class T>
void warm_start(const ManifoldRows<T>& m, std::span<const PointRow<T>> rows, SolverBody<T>& a, SolverBody<T>& b);

/// One pass. With `bias` depth is recovered, without velocities alone count.
template <class T>
void solve(ManifoldRows<T>& m, std::span<PointRow<T>> rows, SolverBody<T>& a, SolverBody<T>& b,
           const ContactStep<T>& step, bool bias);

/// Notes along which normal the bodies are pressed, if they are.
template <class T>
void note_pressed(const ManifoldRows<T>& m, std::span<const PointRow<T>> rows, SolverBody<T>& a, SolverBody<T>& b);

/// Writes the impulses to the points, `times` as large: friction and twist are spread so that they are the same force
/// and the same torque about the pressure centre.
template <class T>
void store(const ManifoldRows<T>& m, std::span<const PointRow<T>> rows, std::span<SolverPoint<T>> points, T times);

}  // namespace graze
