// Ray casts at one convex shape, in its own frame.
#pragma once

#include "graze/raycast.hpp"
#include "narrow/rays/local_ray.hpp"

namespace graze {

/// Where the ray enters a convex shape or crosses a triangle; t along the ray as given.
template <class T>
rays::MaybeHit convex_raycast(const Shape<T>& shape, const rays::LocalRay& ray, BackFaces back);

}  // namespace graze
