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
// thread. What begins wholly inside a solid mesh (`Mesh::solid`) touches it at once, as deep as `distance` says; a mesh
// that is no solid is met at its surface alone.
//
// Method: translations of convex shapes by GJK's ray cast (van den Bergen 2004, "Ray casting against general convex
// objects with application to continuous collision detection"), all else by conservative advancement (Mirtich 1996,
// "Impulse-based dynamic simulation of rigid body systems", section 2.3; Zhang, Lee, Kim 2006, "Interactive continuous
// collision detection for non-convex polyhedra"). Cost: of two boxes about four times that of their distance, turning
// about twenty to forty times.
#pragma once

#include <optional>
#include <vector>

#include "graze/motion.hpp"
#include "graze/query.hpp"

namespace graze {

/// Where a body stands at time t: translation + t linear, exp(t angular) rotation. Needs a sine and a cosine, and so is
/// no more reproducible between standard libraries than those; with no angular velocity it is exact arithmetic.
template <class T>
GRAZE_API Pose<T> pose_at(const Pose<T>& pose, const Velocity<T>& velocity, T t);

/// The first contact at a time in [0, duration] of two bodies that start at the poses given. Shapes that touch or
/// overlap at the start hit at t = 0 (but see `Separating`). `duration` is finite and >= 0. Of composites the first
/// contact of any pair of pieces; of several at the same time the deepest. A `trace` gets, after the answer, the steps
/// of conservative advancement up to it and the separating axes there.
template <class T>
GRAZE_API std::optional<CastHit<T>> cast(const Shape<T>& a, const Pose<T>& pose_a, const Velocity<T>& velocity_a,
                                         const Shape<T>& b, const Pose<T>& pose_b, const Velocity<T>& velocity_b,
                                         T duration, const CastOptions& options = {}, Trace* trace = nullptr);

/// Appends the first contact of every pair of pieces of two shapes, as if each were alone, in the order of time; of
/// convex shapes that is at most one. The only allocation is that of the hits.
template <class T>
GRAZE_API void cast_all(const Shape<T>& a, const Pose<T>& pose_a, const Velocity<T>& velocity_a, const Shape<T>& b,
                        const Pose<T>& pose_b, const Velocity<T>& velocity_b, T duration, std::vector<CastHit<T>>& hits,
                        const CastOptions& options = {});

}  // namespace graze
