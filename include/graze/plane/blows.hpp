// Propagation of impacts in the plane: the motions of bodies in mutual contact after one of them is struck.
//
// Guarantee: that of `graze/blows.hpp`, whose code it is.
#pragma once

#include "graze/blows.hpp"
#include "graze/plane/rigid.hpp"

namespace graze::plane {

/// A body in a collision.
template <class T>
using StruckBody = graze::StruckBody<T, Space<T>>;
/// The points of two bodies that share a normal, struck together.
template <class T>
using Blow = graze::Blow<T, Space<T>>;

/// The function `graze::pass_on`, for the plane.
template <class T>
GRAZE_API PassedOn<T> pass_on(std::span<StruckBody<T>> bodies, std::span<const Blow<T>> blows,
                              std::span<const Vec2<T>> points, std::span<T> impulses, T resting_speed,
                              std::size_t most);

}  // namespace graze::plane
