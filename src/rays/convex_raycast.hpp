// Ray casts at one convex shape, in its own frame.
#pragma once

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "rays/local_ray.hpp"

namespace graze {

/// The hit where the ray enters a convex shape or crosses a triangle; t along the given ray.
template <class T>
rays::MaybeHit convex_raycast(const Shape<T>& shape, const rays::LocalRay& ray, BackFaces back);

/// The radius of a ball about a bounded shape's origin that contains the shape, enlarged by the rounding of the sum in
/// T.
template <class C, class T>
double ball_around(const C& concrete, T rounding) {
  const auto wide = [](T value) { return static_cast<double>(value); };
  return (wide(concrete.core_extent()) + wide(concrete.core_radius()) + wide(rounding)) *
         (1 + 8 * wide(std::numeric_limits<T>::epsilon()));
}

}  // namespace graze
