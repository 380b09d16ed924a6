// Bodies on their way: how they move, what counts as contact on the way, and what a cast finds (`cast.hpp` asks).
//
// Guarantee: plain aggregates without invariants.
#pragma once

#include <cstdint>

#include "graze/result.hpp"

namespace graze {

/// How near, relative to the smaller shape, counts as contact of moving shapes. Ten times the tolerance of a distance:
/// the normal is the direction of what is left of the gap, and loses as many digits as that has zeros. `float`'s is
/// some ten roundings of the support points of a user's shape, and no more than rounding the time to float costs.
template <class T>
inline constexpr T cast_tolerance = T(1e-9);
/// That of single precision.
template <>
inline constexpr float cast_tolerance<float> = 2e-6f;

/// How a body moves: at constant speed along a line, turning about its origin (its pose's translation) at constant
/// rate.
template <class T>
struct Velocity {
  Vec3<T> linear{};   ///< the velocity of the pose's origin
  Vec3<T> angular{};  ///< in world axes, right-handed; its length is the rate in radians per unit of time
};

/// When two shapes that move first touch, and where.
template <class T>
struct CastHit {
  T t{};             ///< when, from 0 to the duration
  Vec3<T> point{};   ///< in the world at time t, in the middle of what is left of the gap
  Vec3<T> normal{};  ///< unit, from A to B, in the world at time t
  T depth{};         ///< of shapes that overlap at the start: how deep, as `distance` says; else 0 (or up to D)
  /// `bounded` when the bound on iterations was reached first: t is then the earliest time that is not excluded, and
  /// whether the shapes touch at all is not known. Bodies that turn a thousand times a hair's breadth apart do that, as
  /// does a half-space that turns, and in `float` one cast in some 50,000 of a user's shape.
  /// `unbounded` of two half-spaces that are not opposite: they overlap from the start, by an infinite depth.
  Status status = Status::converged;
  std::uint32_t piece_a = 0, piece_b = 0;  ///< which child or triangle of a composite it is, else 0
};

/// What becomes of shapes that touch or overlap and do not approach.
enum class Separating : std::uint8_t {
  hit,  ///< they touch: a hit, whatever they do next
  /// Not a hit, so that a body can leave what it touches and slide along it, over the seams of a mesh too. Shapes
  /// slide as long as some plane keeps them apart but for what they were in each other at the start and `sinking`
  /// more; any other contact is a hit, from the time on at which the shapes press: they approach, and get deeper.
  /// Nothing passes through anything by sliding: what a pair may sink is at most an eighth of what both measure across
  /// the plane, however thin they are.
  ignored
};

/// How much deeper shapes in contact may get that are said to slide, in `cast_tolerance<T>` times the size of the
/// smaller of the two that meet: what rounding of poses and velocities does along a way of many sizes. To that comes
/// what rounding of their coordinates does, up to a sixteenth of the size. For shapes that start deep in each other
/// and turn it is an eighth of their depth, if that is more. The last contact of a cast, with no time left to get as
/// deep, counts from D on.
inline constexpr int sinking = 1000;

/// What a cast may be told.
struct CastOptions {
  Separating separating = Separating::hit;  ///< what it says of shapes that touch at first and come apart
};

}  // namespace graze
