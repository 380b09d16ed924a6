// Rays at a box: from the caller's frame and back in one function.
//
// Guarantee: a ray among many gets the bits that it gets alone, at every level. The hit test waits for no division but
// those by its direction's components: the box is transformed by a matrix that is multiplied by the squared length of
// its quaternion, and the ray's direction keeps its given length.
#pragma once

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/core/relative_frame.hpp"
#include "rays/ray_block.hpp"
#include "simd/dispatch.hpp"

namespace graze::rays {

/// Data that the rays at one box share. Constructed in place: a copy right after numbers were stored one by one waits
/// for the stores.
struct TurnedBox {
  ScaledRotation<double> turn;
  double per_scale;
  Vec3d half;  ///< multiplied by the scale
  Vec3d translation;

  template <class T>
  TurnedBox(const Vec3<T>& half_extents, const Pose<T>& pose)
      : turn(scaled_rotation_of(converted<double>(pose.rotation))),
        per_scale(1 / turn.scale),
        half(converted<double>(half_extents) * turn.scale),
        translation(converted<double>(pose.translation)) {}
};

/// The half extents of a box that the kernels take: without rounding, and with at least two sides of a length, since
/// for rays it is a segment otherwise. Null for other shapes.
template <class T>
const Vec3<T>* plain_box(const Shape<T>& shape) {
  const auto* box = shape.template as<Box<T>>();
  if (const auto* rectangle = shape.template as<Rectangle<T>>()) box = &rectangle->as_box();
  if (!box || shape.rounding() > T(0)) return nullptr;
  const Vec3<T>& half = box->half_extents();
  return (half.x <= T(0)) + (half.y <= T(0)) + (half.z <= T(0)) < 2 ? &half : nullptr;
}

}  // namespace graze::rays

namespace graze {

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Intersects one ray with a box without rounding: returns whether it hits, and sets the hit.
    template <class T> bool ray_at_box(const Vec3<T>& half, const Pose<T>& pose, const Ray<T>& ray, T length,
                                       RayHit<T>& hit);
    /// Intersects up to `RayBlock::size` rays, six numbers each: sets `state`, and the hits. `ray_again` where rounding
    /// has turned a normal along the ray.
    template <class T> void rays_at_box(rays::RayBlock& block, const T* rays, std::size_t count, T length,
                                        const rays::TurnedBox& box, rays::BlockHits<T>& hits);)
// clang-format on

}  // namespace graze
