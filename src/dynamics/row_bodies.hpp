// Two bodies as the rows between them see them, over S, a scalar or lanes.
#pragma once

#include "dynamics/rigid_space.hpp"
#include "graze/wide.hpp"
#include "simd/lane_of.hpp"

namespace graze {

/// The part of `SolverBody` that rows change. None of the numbers is a negative zero, so that adding zeros of any sign
/// changes no bit.
template <class S, class Space>
struct RowVelocity {
  typename Space::Vec linear{};
  typename Space::Turning angular{};
};

/// The motion of a body since its contacts were found.
template <class S, class Space>
struct RowPlace {
  typename Space::Vec moved{};
  RotationIn<Space> turned{};
};

template <class S, class Space>
struct RowBodies {
  RowVelocity<S, Space> a, b;
  RowPlace<S, Space> place_a, place_b;
  bool roll = false;  ///< whether anything resists rolling
};

/// The space of a scalar as that of lanes.
template <class Space, class S>
struct OverLanes;
template <template <class> class Space, class T, class S>
struct OverLanes<Space<T>, S> {
  using type = Space<S>;
};
template <class Space, class S>
using SpaceOver = typename OverLanes<Space, S>::type;

}  // namespace graze
