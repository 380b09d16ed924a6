// The bodies of an island, and the kernels that move those that can be pushed, as many at a time as there are lanes.
//
// Guarantee: the same bits whatever the number of lanes.
#pragma once

#include "dynamics/solver_body.hpp"
#include "dynamics/space_kernels.hpp"
#include "simd/dispatch.hpp"

namespace graze {

/// The influences on a body besides contacts and joints; over S, a scalar or lanes.
template <class S, class Space>
struct Influences {
  typename Space::Vec acceleration{};
  typename Space::Turning torque{};
  S linear_damping{}, angular_damping{};
  S share = S(1);  ///< of a sub-step's duration that the body has
};

/// A body as its island holds it.
template <class T, class Space>
struct IslandBody {
  FreeBodyIn<Space> free{};  ///< as it is now
  Influences<T, Space> influences{};
  InertiaIn<Space> world_inertia{};  ///< in world space; zero where it is infinite
  FreeBodyIn<Space> first{};         ///< as contacts found it
  typename Rigid<Space>::PrincipalInertia inertia{};
  T inverse_mass{};
  typename Space::Turning spin{};  ///< of a body that nothing pushes
  int sub_steps = 0;               ///< of its island in the last step; 0 of a body that is new
  bool movable = false;
  bool placed = false;  ///< by hand; overlaps what it has been put into
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
  /// Changes velocities by the influences on each body.
  void (*begin)(const BodyBlock<T, Space>&, const SubStep<T>&);
  /// Moves bodies by the velocities of the pass with bias. A body that nothing turned keeps its
  /// angular momentum bit for bit.
  void (*move)(const BodyBlock<T, Space>&, const SubStep<T>&);
  /// Takes over the changes of the pass without bias.
  void (*end)(const BodyBlock<T, Space>&);
};

GRAZE_DECLARE_KERNEL(const SpaceKernels<BodyKernels>& body_kernels();)

}  // namespace graze
