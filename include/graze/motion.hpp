// Moving bodies: their velocities, the tolerance of contact during motion, and the hits of casts (`cast.hpp`).
//
// Guarantee: plain aggregates without invariants.
#pragma once

#include <cstdint>

#include "graze/result.hpp"

namespace graze {

/// The gap, relative to the smaller shape, that counts as contact of moving shapes. Ten times the tolerance of a
/// distance: the normal is the direction of the remaining gap, and loses as many digits as that has zeros. `float`'s is
/// some ten roundings of the support points of a user's shape, and no more than rounding the time to float costs.
template <class T>
inline constexpr T cast_tolerance = T(1e-9);
/// The gap of contact in single precision.
template <>
inline constexpr float cast_tolerance<float> = 2e-6f;

/// The motion of a body: constant linear velocity, and rotation about its origin (its pose's translation) at a constant
/// rate.
template <class T>
struct Velocity {
  Vec3<T> linear{};   ///< the velocity of the pose's origin
  Vec3<T> angular{};  ///< in world axes, right-handed; its length is the rate in radians per unit of time
};

/// The first contact of two moving shapes.
template <class T>
struct CastHit {
  T t{};             ///< time of the contact, from 0 to the duration
  Vec3<T> point{};   ///< in the world at time t, in the middle of the remaining gap
  Vec3<T> normal{};  ///< unit, from A to B, in the world at time t
  T depth{};         ///< depth at the start, as `distance` gives it, of shapes that overlap there; else 0 (or up to D)
  /// `bounded` when the bound on iterations was reached first: t is then the earliest time that is not excluded, and
  /// whether the shapes touch at all is not known. Bodies that turn a thousand times a hair's breadth apart reach it,
  /// as do two half-spaces of which one turns, and in `float` one cast in some 50,000 of a user's shape.
  /// `unbounded` for two half-spaces that are not opposite: they overlap from the start, by an infinite depth.
  Status status = Status::converged;
  std::uint32_t piece_a = 0, piece_b = 0;  ///< the child or triangle of a composite that is hit, else 0
};

/// Treatment of shapes that touch or overlap at the start and do not approach.
enum class Separating : std::uint8_t {
  hit,  ///< a hit, whatever the shapes do next
  /// Not a hit, so that a body can leave what it touches and slide along it, over the seams of a mesh too. Shapes slide
  /// as long as some plane separates them except for their overlap at the start and `sinking` more, and leads over no
  /// seam into the next triangle of a surface or segment of a chain; any other contact is a hit, from the time on at
  /// which the shapes press: they approach, and get deeper. Nothing passes through anything by sliding: a pair may sink
  /// by at most an eighth of what both measure across the plane, however thin they are. Only into the seam between two
  /// bodies or children of a compound may what is thinner than that slide, since each is asked alone.
  ignored
};

/// The additional depth that shapes in contact may reach while they count as sliding, in `cast_tolerance<T>` times the
/// size of the smaller of the two that meet: the effect of rounding of poses and velocities along a way of many sizes.
/// Rounding of their coordinates adds up to a sixteenth of the size. For shapes that start deep in each other and turn
/// it is an eighth of their depth, if that is more. The last contact of a cast, with no time left to get as deep,
/// counts from D on.
inline constexpr int sinking = 1000;

/// Options of a cast.
struct CastOptions {
  Separating separating = Separating::hit;  ///< treatment of shapes that touch at first and come apart
};

}  // namespace graze
