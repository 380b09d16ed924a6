// Ray casts at one convex shape, in its own frame.
#pragma once

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "rays/local_ray.hpp"

namespace graze {

/// Where the ray enters a convex shape or crosses a triangle; t along the ray as given.
template <class T>
rays::MaybeHit convex_raycast(const Shape<T>& shape, const rays::LocalRay& ray, BackFaces back);

/// The radius of a ball about a bounded shape's origin that holds it, for all that its numbers' sum rounds in T.
template <class C, class T>
double ball_around(const C& concrete, T margin) {
  const auto wide = [](T value) { return static_cast<double>(value); };
  return (wide(concrete.core_extent()) + wide(concrete.core_radius()) + wide(margin)) *
         (1 + 8 * wide(std::numeric_limits<T>::epsilon()));
}

}  // namespace graze
