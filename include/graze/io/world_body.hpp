// A scene's collider as the body of a world.
#pragma once

#include "graze/io/scene.hpp"
#include "graze/world/bodies.hpp"

namespace graze::io {

/// The body with a collider's shape, pose and filter; colliders of one body of the scene are in one negative group, and
/// so never collide. It is no trigger, whose contacts would not be told. Throws `InvalidValue` for what double could
/// hold and T cannot.
template <class T>
GRAZE_API graze::Body<T> world_body(const Scene& scene, const Collider& collider, bool fixed);

}  // namespace graze::io
