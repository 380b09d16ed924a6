// A world of the plane: `graze::World` (`graze/world.hpp`) with bodies of two dimensions.
//
// Guarantee: that of `graze::World`: the result of an update is a function of the calls made so far alone, the same
// bits for any executor and any number of threads; the contacts of each pair are those of `plane::contacts`, bit for
// bit, and each query has the answer that a test of every body would give. Nothing is dropped. It is the same code,
// over the trait of this space, so that the documentation there of handles, filters, triggers, events, impulses,
// impacts, queries and threads holds here, with the types of the plane: `plane::Shape`, `plane::Pose2`, `plane::Vec2`,
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

/// Description of a body to be added: its shape, pose, velocity of the pose's origin, angular velocity (radians per
/// unit of time, counter-clockwise), filter, and whether it is fixed, a trigger, or fast.
template <class T>
using Body = graze::Body<T, Space<T>>;
/// The bodies of a world, an array for each attribute.
template <class T>
using BodyArrays = graze::BodyArrays<T, Space<T>>;
/// Contacts of an update: pairs, their manifolds, and points, of which a pair of convex shapes has at most two.
template <class T>
using ContactArrays = graze::ContactArrays<T, Space<T>>;
template <class T>
using ContactManifold = graze::ContactManifold<T, Space<T>>;
/// A point of contact, with the solver's impulse there.
template <class T>
using SolverPoint = graze::SolverPoint<T, Space<T>>;
/// A fast body and one that it would pass through.
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
