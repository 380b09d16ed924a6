// The order of two shapes of one kind for computations that depend on which comes first.
#pragma once

#include "graze/shape.hpp"
#include "narrow/core/relative_frame.hpp"

namespace graze {

/// Whether two shapes of one kind are swapped. Where two choices are equally good (the reference face, the edge that
/// counts, the vertex at which a search begins) an answer depends on the order of the shapes. The larger shape
/// comes first or, of two equally large ones, one by its position relative to the other: a swap of the arguments then
/// swaps the answer to the last bit, and a motion of both keeps it.
template <class T>
bool stands_second(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  const auto extent = [](const Shape<T>& shape) {
    return shape.visit([](const auto& c) {
      if constexpr (requires { c.core_extent(); }) return c.core_extent();
      return T(0);
    });
  };
  const T size_a = extent(a) + a.rounding(), size_b = extent(b) + b.rounding();
  if (size_a != size_b) return size_a < size_b;
  const Posed frame_a = in_double(pose_a), frame_b = in_double(pose_b);
  const Vec3d at_b = inverse_transform(frame_a, frame_b.translation),
              at_a = inverse_transform(frame_b, frame_a.translation);
  for (std::size_t i = 0; i < 3; ++i)
    if (at_b[i] != at_a[i]) return at_b[i] < at_a[i];
  const Quatd b_of_a = relative(frame_a, frame_b).rotation, a_of_b = relative(frame_b, frame_a).rotation;
  const Vec3d turn_b = b_of_a.vector() * b_of_a.w, turn_a = a_of_b.vector() * a_of_b.w;
  for (std::size_t i = 0; i < 3; ++i)
    if (turn_b[i] != turn_a[i]) return turn_b[i] < turn_a[i];
  return false;
}

}  // namespace graze
