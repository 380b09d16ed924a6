// A block of rays, with an array for each number: plain arrays, so that frame transforms and closed forms can be
// compiled for each instruction set.
//
// Guarantee: every number has the bits that one ray alone gets, since both run the same templates (`round.hpp`,
// `quadrics.hpp`, `half_space.hpp`, `ray_triangle.hpp`). Rays that these leave undecided have the state `ray_again`,
// and the caller casts them alone.
#pragma once

#include <cstddef>

#include "simd/dispatch.hpp"

namespace graze::rays {

struct alignas(64) RayBlock {
  static constexpr std::size_t size = 64;  ///< a multiple of every number of lanes
  using Numbers = double[size];

  // The direction in the caller's frame. Where `end` is less than zero the ray hits nothing.
  Numbers along[3], end;
  // In the shape's frame, as in `LocalRay`. `blur` is set where it is used.
  Numbers origin[3], direction[3], blur;
  // Hits, in the shape's frame; `state` marks the rays that have one.
  Numbers t, point[3], normal[3], state;
};

/// Hits in the caller's frame and scalar.
template <class T>
struct alignas(64) BlockHits {
  T t[RayBlock::size], point[3][RayBlock::size], normal[3][RayBlock::size];
};

/// The states of a ray, as numbers, so that lanes choose among them.
inline constexpr double ray_missed = 0, ray_hit = 1, ray_again = 2;

/// A `Frame`; the rotation by rows.
struct BlockFrame {
  double translation[3], rotation[3][3];
};

/// A shape that the closed forms cover, its rounding included; `ball_cone` is the hull of two balls, neither inside the
/// other, and `frustum` one that has some thickness.
struct BlockShape {
  enum Kind { none, ball, half_space, triangle, ball_cone, frustum, ellipsoid } kind = none;
  double radius = 0;        ///< radius of the ball, the first or lower one; the half-space's height
  double other_radius = 0;  ///< radius of the second ball, or at the frustum's top
  /// The balls' centres, the frustum's half height, the triangle's corners, the ellipsoid's radii.
  double points[3][3] = {};
  double around = 0;  ///< radius of a ball about the frame's origin that a ray has to meet
  bool both_sides = true;
};

}  // namespace graze::rays

namespace graze {

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Transforms rays from the caller's frame into the shape's: `rays` are six numbers each, origin and direction; the
    /// block is filled up with the last one to a multiple of eight. Rays that no shape can hit get an end less than
    /// zero, others `end`.
    template <class T> void block_to_local(rays::RayBlock& block, const T* rays, std::size_t count, double end,
                                           const rays::BlockFrame& frame);
    /// Sets `state` and the hits.
    void block_hits(rays::RayBlock& block, std::size_t count, const rays::BlockShape& shape);
    /// Transforms hits from the shape's frame into the caller's, none further than `length`; `ray_again` where rounding
    /// has turned a normal along the ray.
    template <class T> void block_to_world(rays::RayBlock& block, std::size_t count, const rays::BlockFrame& frame,
                                           T length, rays::BlockHits<T>& hits);)
// clang-format on

}  // namespace graze
