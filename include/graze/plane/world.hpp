// A world of the plane: `graze::World` (`graze/world.hpp`) with bodies of two dimensions.
//
// Guarantee: that of `graze::World`: the result of an update is a function of the calls made so far alone, the same
// bits for any executor and any number of threads; the contacts of each pair are those that `plane::contacts` answers,
// bit for bit, and each question has the answer of asking every body by itself. Nothing is dropped. It is the same
// code, over the trait of this space, so all that is said there of handles, filters, triggers, events, impulses,
// impacts, questions and threads holds here, in the words of the plane: `plane::Shape`, `plane::Pose2`, `plane::Vec2`,
// and a number for an angular velocity.
//
//     graze::plane::World<float> world;
//     const graze::BodyId crate = world.add({graze::plane::Box<float>({1, 1}), {{0, 3}, {}}});
//     world.update();
//     for (const graze::ContactEvent& e : world.events()) ...
#pragma once

#include "graze/plane/space.hpp"
#include "graze/world.hpp"
#include "graze/world/reduce.hpp"

namespace graze::plane {

/// What is said of a body when it is added: its shape, pose, velocity of the pose's origin, rate of turning
/// (radians per unit of time, counter-clockwise), filter, and whether it is fixed, a trigger, or fast.
template <class T>
using Body = graze::Body<T, Space<T>>;
/// The bodies of a world, an array for each of their parts.
template <class T>
using BodyArrays = graze::BodyArrays<T, Space<T>>;
/// What an update found: pairs, their manifolds, and points, of which a pair of convex shapes has at most two.
template <class T>
using ContactArrays = graze::ContactArrays<T, Space<T>>;
template <class T>
using ContactManifold = graze::ContactManifold<T, Space<T>>;
/// A point of contact and what a solver has pushed there so far.
template <class T>
using SolverPoint = graze::SolverPoint<T, Space<T>>;
/// What a fast body would meet.
template <class T>
using Impact = graze::Impact<T, Space<T>>;
template <class T>
using BodyDistance = graze::BodyDistance<T, Space<T>>;
template <class T>
using BodyRayHit = graze::BodyRayHit<T, Space<T>>;
template <class T>
using BodyCastHit = graze::BodyCastHit<T, Space<T>>;

template <class T>
using World = graze::World<T, Space<T>>;

using Worldf = World<float>;
using Worldd = World<double>;

}  // namespace graze::plane
