// The first stage of a world: from poses to bounds.
//
// Guarantee: a box holds its body and everything up to the body's margin from it, rounding included.
#pragma once

#include <limits>
#include <span>

#include "graze/executor.hpp"
#include "graze/world/space.hpp"

namespace graze {

/// The bounds of a body grown by its margin. An infinite margin, a half-space's, adds nothing: the other body's counts.
template <class T, class Space = graze::Space<T>>
Aabb<T> bounds_with_margin(const typename Space::Shape& shape, const typename Space::Pose& pose, T margin) {
  return inflated(Space::bounds(shape, pose), margin < std::numeric_limits<T>::infinity() ? margin : T(0));
}

/// Sets boxes[i] to the bounds of body i grown by its margin, for each i of `which`.
template <class T, class Space = graze::Space<T>>
GRAZE_API void find_bounds(std::span<const typename Space::Shape> shapes, std::span<const typename Space::Pose> poses,
                           std::span<const T> margins, std::span<const std::uint32_t> which, std::span<Aabb<T>> boxes,
                           Executor& executor);

}  // namespace graze
