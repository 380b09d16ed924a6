// Conversion of a scene's collider to the body of a world.
#pragma once

#include "graze/io/scene.hpp"
#include "graze/world/bodies.hpp"

namespace graze::io {

/// The body with a collider's shape, pose and filter; colliders of one body of the scene are in one negative group, and
/// so never collide. The body is no trigger, which would have no contacts. Throws `InvalidValue` for numbers that fit
/// in double but not in T.
template <class T>
GRAZE_API graze::Body<T> world_body(const Scene& scene, const Collider& collider, bool fixed);

}  // namespace graze::io
