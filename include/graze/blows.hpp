// Propagation of impacts: the motions of bodies in mutual contact after one of them is struck.
//
// Guarantee: momentum is conserved up to rounding, and with restitutions of at most 1 kinetic energy does not grow. A
// row of touching balls acts as a Newton's cradle: the last one leaves with the speed of the first. The result is a
// function of the input alone, ties being decided by the order of the blows. Friction is left to a solver.
//
// Newton's law of impact holds for one contact at a time. Where several touch, it is repeated: the contact that
// approaches fastest is struck, which may let its neighbours approach, until none does. All points of one manifold are
// struck at once, by Moreau's law of impact (1988): where a point is pushed, its velocity along the normal is reversed
// and times e. The impulses solve a linear complementarity problem, by projected Gauss-Seidel iteration. A box that
// falls flat rebounds flat.
#pragma once

#include <cstdint>
#include <span>

#include "graze/impulse.hpp"

namespace graze {

/// The points of two bodies that share a normal, struck together.
template <class T, class Space = graze::Space<T>>
struct Blow {
  std::uint32_t a, b;            ///< indices of the bodies
  typename Space::Vec normal{};  ///< unit, from a to b
  T restitution{};               ///< fraction of the approach speed that comes back, 0 to 1
  std::uint32_t first_point, point_count;
};

/// The outcome of `pass_on`.
template <class T>
struct PassedOn {
  std::size_t struck = 0;  ///< number of blows that were struck
  T approach{};            ///< the fastest approach left: at most the resting speed, unless `most` blows were struck
};

/// Strikes blows until none approaches faster than `resting_speed` (>= 0), or `most` were struck. Changes the motions
/// of `bodies`, and adds the impulse of each point to its entry of `impulses`. `points` are in world space, as many as
/// `impulses`. Costs one pass over all blows for each that is struck.
template <class T>
GRAZE_API PassedOn<T> pass_on(std::span<StruckBody<T>> bodies, std::span<const Blow<T>> blows,
                              std::span<const Vec3<T>> points, std::span<T> impulses, T resting_speed,
                              std::size_t most);

}  // namespace graze
