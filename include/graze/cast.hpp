// When do two moving bodies first touch?
//
// Guarantee: no hit is missed and none is passed, at any ratio of sizes. With D = `cast_tolerance<T>` times the size
// of the smaller of the two shapes that meet (the radius about its body's origin; of a user's shape in any case) plus
// `tolerance<double>` times that of the larger plus the rounding of the path (some units in the last place of its
// length): at the time of a hit the shapes are no more than D apart and overlap by no more than D (unless they did at
// the start), and at no time before they were closer than D/4. So t is never later than the true time, and earlier by
// no more than D over the speed at which the gap closes there. A pass at more than D is a miss, one at less may be a
// hit. Where rounding leaves the distance of a curved shape and one that is thousands of times as large no better
// known, D is `cast_tolerance<double>` times the larger. In `float` rounding the time itself moves the bodies by as
// much again; it is rounded down; and what `overlap` calls touching at the start hits there. Answers are computed in
// double, in a frame that moves with A: moving the scene does not change them. Nothing throws or prints; safe from any
// thread.
//
// Method: translations of convex shapes by GJK's ray cast (van den Bergen 2004, "Ray casting against general convex objects
// with application to continuous collision detection"), all else by conservative advancement (Mirtich 1996,
// "Impulse-based dynamic simulation of rigid body systems", section 2.3; Zhang, Lee, Kim 2006, "Interactive continuous
// collision detection for non-convex polyhedra"). Cost: of two boxes about four times that of their distance, turning
// about twenty to forty times.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "graze/query.hpp"

namespace graze {

/// How near, relative to the smaller shape, counts as contact of moving shapes. Ten times the tolerance of a distance:
/// the normal is the direction of what is left of the gap, and loses as many digits as that has zeros. `float`'s is some
/// ten roundings of the support points of a user's shape, and no more than rounding the time to float costs.
template <class T>
inline constexpr T cast_tolerance = T(1e-9);
template <>
inline constexpr float cast_tolerance<float> = 2e-6f;

/// How a body moves: at constant speed along a line, turning about its origin (its pose's translation) at constant rate.
template <class T>
struct Velocity {
  Vec3<T> linear{};
  Vec3<T> angular{};  ///< in world axes, right-handed; its length is the rate in radians per unit of time
};

/// Where a body stands at time t: translation + t linear, exp(t angular) rotation. Needs a sine and a cosine, and so is
/// no more reproducible between standard libraries than those; with no angular velocity it is exact arithmetic.
template <class T>
Pose<T> pose_at(const Pose<T>& pose, const Velocity<T>& velocity, T t);

template <class T>
struct CastHit {
  T t{};
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

struct CastOptions {
  Separating separating = Separating::hit;
};

/// The first contact at a time in [0, duration] of two bodies that start at the poses given. Shapes that touch or overlap
/// at the start hit at t = 0 (but see `Separating`). `duration` is finite and >= 0. Of composites the first contact of
/// any pair of pieces; of several at the same time the deepest. A `trace` gets, after the answer, the steps of
/// conservative advancement up to it and the separating axes there.
template <class T>
std::optional<CastHit<T>> cast(const Shape<T>& a, const Pose<T>& pose_a, const Velocity<T>& velocity_a,
                               const Shape<T>& b, const Pose<T>& pose_b, const Velocity<T>& velocity_b, T duration,
                               const CastOptions& options = {}, Trace* trace = nullptr);

/// Appends the first contact of every pair of pieces of two shapes, as if each were alone, in the order of time; of
/// convex shapes that is at most one. The only allocation is that of the hits.
template <class T>
void cast_all(const Shape<T>& a, const Pose<T>& pose_a, const Velocity<T>& velocity_a, const Shape<T>& b,
              const Pose<T>& pose_b, const Velocity<T>& velocity_b, T duration, std::vector<CastHit<T>>& hits,
              const CastOptions& options = {});

}  // namespace graze
