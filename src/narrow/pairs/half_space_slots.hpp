// Contact points of a shape that rests on a half-space, a slot each, across lanes.
#pragma once

#include "narrow/core/core.hpp"

namespace graze {

inline constexpr std::size_t most_half_space_points = 4;
/// Largest number of points of a kind of shape.
template <class C>
inline constexpr std::size_t rest_points_of = most_half_space_points;
template <class T>
inline constexpr std::size_t rest_points_of<Sphere<T>> = 1;
template <class T>
inline constexpr std::size_t rest_points_of<Capsule<T>> = 2;
template <class T>
inline constexpr std::size_t rest_points_of<Triangle<T>> = 3;

/// The points of contact; each lane fills different slots.
template <class S>
struct Rest {
  S distance;
  Vec3<S> up;  ///< unit, out of the half-space, in the world
  struct Slot {
    Vec3<S> of_body, of_plane;
    S distance, corner;  ///< `corner`: number of the corner, or of the end of a capsule
  } slots[most_half_space_points];
  S filled;  ///< slot i holds a point: bit i of this number
};

}  // namespace graze
