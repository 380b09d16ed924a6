// The rows of contacts: a row along the normal for each point, and for each manifold friction at its pressure centre
// (`friction_rows.hpp`).
//
// Guarantee: normal impulses push, friction stays in Coulomb's cone of the normal impulses of the same pass, in the
// passes with and without bias alike. Only + - * / and sqrt; rows are solved in their own order.
#pragma once

#include <span>
#include <vector>

#include "dynamics/friction_rows.hpp"
#include "dynamics/solver_body.hpp"
#include "graze/material.hpp"
#include "graze/world/manifolds.hpp"

namespace graze {

/// Points that share a normal.
template <class T, class Space>
struct ManifoldRows {
  using Vec = typename Space::Vec;

  std::uint32_t a{}, b{};  ///< places in the island
  std::uint32_t first_row{}, row_count{};
  std::uint32_t first_point{};  ///< in the world
  Vec normal{};                 ///< from A to B
  FrictionRows<T, Space> friction{};
  T size{};          ///< the smaller of the two bodies
  T inverse_mass{};  ///< of both together
  ContactMaterial<T> material{};
};

/// How rows of contacts recover depth in a sub-step.
template <class T>
struct ContactStep {
  SubStep<T> time{};
  Softness<T> soft{};
  T gravity{};
};

/// The springs of a sub-step of h: their period is some sub-steps, damped beyond the critical, so that nothing
/// swings (Catto 2024). Stiffer ones against what does not give, as Catto has them, shake heavy bodies that lie on
/// light ones.
template <class T>
ContactStep<T> contact_step(const SubStep<T>& time, T gravity);

/// How deep a contact of two free masses stands under a steady `force`, both `inverse_mass`es together.
template <class T>
T predicted_sink(T force, T inverse_mass, T h);

/// The bodies of a manifold and what acts between them.
template <class T, class Space>
struct TouchingBodies {
  std::uint32_t a{}, b{};
  ContactMaterial<T> material{};
  typename Space::Vec surface_a{}, surface_b{};  ///< velocities of conveyors, in world space
  T size{};
};

/// The rows of a manifold: its own, of which `own` are those of its points, at `first_row` of the island's. `share` is
/// what part of a point's impulse a sub-step has.
template <class T, class Space>
ManifoldRows<T, Space> prepare(const TouchingBodies<T, Space>& touching, std::span<const SolverBody<T, Space>> bodies,
                               const ContactManifold<T, Space>& manifold, std::span<const SolverPoint<T, Space>> points,
                               T share, std::uint32_t first_row, std::span<PointRow<T, Space>> own);

template <class T, class Space>
void warm_start(const ManifoldRows<T, Space>& m, std::span<const PointRow<T, Space>> rows, SolverBody<T, Space>& a,
                SolverBody<T, Space>& b);

/// One pass. With `bias` depth is recovered, without velocities alone count. Tells whether friction is at its limit.
template <class T, class Space>
bool solve(ManifoldRows<T, Space>& m, std::span<PointRow<T, Space>> rows, SolverBody<T, Space>& a,
           SolverBody<T, Space>& b, const ContactStep<T>& step, bool bias);

/// Notes along what the bodies are pressed, if they are: along the normal, and where friction holds in all directions.
template <class T, class Space>
void note_pressed(const ManifoldRows<T, Space>& m, std::span<const PointRow<T, Space>> rows, bool slides,
                  SolverBody<T, Space>& a, SolverBody<T, Space>& b);

/// Writes the impulses to the points, `times` as large: friction is spread so that it is the same force and the same
/// torque about the pressure centre.
template <class T, class Space>
void store(const ManifoldRows<T, Space>& m, std::span<const PointRow<T, Space>> rows,
           std::span<SolverPoint<T, Space>> points, T times);

}  // namespace graze
