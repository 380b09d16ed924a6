// Rays at a box: from the caller's frame and back in one go.
//
// Guarantee: a ray among many gets the bits that it gets alone, at every level. Whether it hits waits for no division
// but those by its direction's components: the box is seen through a matrix that stands times the squared length of its
// quaternion, and the ray's direction has the length that it was given.
#pragma once

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/core/relative_frame.hpp"
#include "rays/ray_block.hpp"
#include "simd/dispatch.hpp"

namespace graze::rays {

/// What the rays at one box share. Made in its place: numbers that are copied together right after they were written
/// one by one wait for the memory.
struct TurnedBox {
  ScaledRotation<double> turn;
  double per_scale;
  Vec3d half;  ///< times the scale
  Vec3d translation;

  template <class T>
  TurnedBox(const Vec3<T>& half_extents, const Pose<T>& pose)
      : turn(scaled_rotation_of(converted<double>(pose.rotation))),
        per_scale(1 / turn.scale),
        half(converted<double>(half_extents) * turn.scale),
        translation(converted<double>(pose.translation)) {}
};

/// The half extents of a box that the kernels know: not rounded, and with two sides at least that have a length, since
/// to rays it is a segment else. Null of any other shape.
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
    /// Whether a ray hits a box that is not rounded, and where.
    template <class T> bool ray_at_box(const Vec3<T>& half, const Pose<T>& pose, const Ray<T>& ray, T length,
                                       RayHit<T>& hit);
    /// Of up to `RayBlock::size` rays, six numbers each, which hit: `state`, and the hits. `ray_again` where rounding
    /// has turned a normal along the ray.
    template <class T> void rays_at_box(rays::RayBlock& block, const T* rays, std::size_t count, T length,
                                        const rays::TurnedBox& box, rays::BlockHits<T>& hits);)
// clang-format on

}  // namespace graze
