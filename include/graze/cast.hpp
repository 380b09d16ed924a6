// Continuous collision detection: the time at which two moving bodies first touch.
//
// Guarantee: no hit is missed and none is passed, at any ratio of sizes. Let D be `cast_tolerance<T>` times the size of
// the smaller of the two shapes that meet (the radius about its body's origin; a shape of the user's own always
// counts), plus `tolerance<double>` times that of the larger, plus the rounding of the path (some units in the last
// place of its length). At the time of a hit the shapes are no more than D apart and overlap by no more than D (unless
// they did at the start), and at no time before were they closer than D/4. So t is never later than the true time, and
// earlier by no more than D over the speed at which the gap closes there. A pass at more than D is a miss, one at less
// may be a hit. Where rounding leaves the distance between a curved shape and one thousands of times as large no better
// known, D is `cast_tolerance<double>` times the larger. In `float`, rounding the time itself moves the bodies by as
// much again; the time is rounded down, and shapes that touch at the start by `overlap` hit there. Answers are computed
// in double, in a frame that moves with A: moving the scene does not change them. Nothing throws or prints; safe from
// any thread. A shape that begins wholly inside a solid mesh (`Mesh::solid`) touches it at once, as deep as `distance`
// says; a mesh that is not solid is met at its surface alone.
//
// Method: translations of convex shapes by GJK's ray cast (van den Bergen 2004, "Ray casting against general convex
// objects with application to continuous collision detection"), all other motions by conservative advancement (Mirtich
// 1996, "Impulse-based dynamic simulation of rigid body systems", section 2.3; Zhang, Lee, Kim 2006, "Interactive
// continuous collision detection for non-convex polyhedra"). Cost for two boxes: about four times that of their
// distance, with turning about twenty to forty times.
#pragma once

#include <optional>
#include <vector>

#include "graze/motion.hpp"
#include "graze/query.hpp"

namespace graze {

/// The pose of a body at time `t`: translation + t linear, exp(t angular) rotation. Uses a sine and a cosine, and so is
/// no more reproducible between standard libraries than those; without angular velocity it is exact arithmetic.
template <class T>
GRAZE_API Pose<T> pose_at(const Pose<T>& pose, const Velocity<T>& velocity, T t);

/// The first contact at a time in [0, duration] of two bodies that start at the given poses. Shapes that touch or
/// overlap at the start hit at t = 0 (but see `Separating`). `duration` is finite and >= 0. For composites the first
/// contact over all pairs of pieces, and of several at the same time the deepest. A `trace` is filled, after the
/// answer, with the steps of conservative advancement up to the hit and the separating axes there.
template <class T>
GRAZE_API std::optional<CastHit<T>> cast(const Shape<T>& a, const Pose<T>& pose_a, const Velocity<T>& velocity_a,
                                         const Shape<T>& b, const Pose<T>& pose_b, const Velocity<T>& velocity_b,
                                         T duration, const CastOptions& options = {}, Trace* trace = nullptr);

/// Appends the first contact of every pair of pieces of two shapes, as if each were alone, ordered by time: at most one
/// for convex shapes. Allocates for the hits only.
template <class T>
GRAZE_API void cast_all(const Shape<T>& a, const Pose<T>& pose_a, const Velocity<T>& velocity_a, const Shape<T>& b,
                        const Pose<T>& pose_b, const Velocity<T>& velocity_b, T duration, std::vector<CastHit<T>>& hits,
                        const CastOptions& options = {});

}  // namespace graze
