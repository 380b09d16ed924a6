// The bodies of an island, and what moves those that can be pushed, as many at a time as there are lanes.
//
// Guarantee: the same bits whatever the number of lanes.
#pragma once

#include "dynamics/solver_body.hpp"
#include "dynamics/space_kernels.hpp"
#include "simd/dispatch.hpp"

namespace graze {

/// What acts on a body besides contacts and joints; over S, a scalar or lanes.
template <class S, class Space>
struct Influences {
  typename Space::Vec acceleration{};
  typename Space::Turning torque{};
  S linear_damping{}, angular_damping{};
  S share = S(1);  ///< of a sub-step's duration that the body has
};

/// What an island has to know of a body.
template <class T, class Space>
struct IslandBody {
  FreeBodyIn<Space> free{};  ///< as it is now
  Influences<T, Space> influences{};
  InertiaIn<Space> world_inertia{};  ///< in world space, at the beginning of the step; zero where it is infinite
  FreeBodyIn<Space> first{};         ///< as contacts found it
  typename Rigid<Space>::PrincipalInertia inertia{};
  T inverse_mass{};
  typename Space::Turning spin{};  ///< of a body that nothing pushes
  int sub_steps = 0;               ///< of its island in the last step; 0 of a body that is new
  bool movable = false;
};

/// Bodies that stand one behind the other and can be pushed.
template <class T, class Space>
struct BodyBlock {
  IslandBody<T, Space>* states;
  SolverBody<T, Space>* bodies;
  std::size_t count;
};

/// The parts of a sub-step.
template <class T, class Space>
struct BodyKernels {
  /// Velocities with what acts on the bodies by themselves.
  void (*begin)(const BodyBlock<T, Space>&, const SubStep<T>&);
  /// Moves bodies as the pass with bias wants them to. The angular momentum of what nothing turned stays bit for bit.
  void (*move)(const BodyBlock<T, Space>&, const SubStep<T>&);
  /// Takes over what the pass without bias changed.
  void (*end)(const BodyBlock<T, Space>&);
};

GRAZE_DECLARE_KERNEL(const SpaceKernels<BodyKernels>& body_kernels();)

}  // namespace graze
