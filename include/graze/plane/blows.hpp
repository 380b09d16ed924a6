// Blows of the plane that are passed on: what bodies do that touch each other while one of them is struck.
//
// Guarantee: that of `graze/blows.hpp`, whose code it is.
#pragma once

#include "graze/blows.hpp"
#include "graze/plane/rigid.hpp"

namespace graze::plane {

/// A body as a blow meets it.
template <class T>
using StruckBody = graze::StruckBody<T, Space<T>>;
/// The points of two bodies that share a normal, struck together.
template <class T>
using Blow = graze::Blow<T, Space<T>>;

/// As `graze::pass_on`.
template <class T>
GRAZE_API PassedOn<T> pass_on(std::span<StruckBody<T>> bodies, std::span<const Blow<T>> blows,
                              std::span<const Vec2<T>> points, std::span<T> impulses, T resting_speed,
                              std::size_t most);

}  // namespace graze::plane
