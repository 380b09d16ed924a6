// Some rays at a time, a number of each side by side: plain arrays, so that their way through the frames and the closed
// forms can be compiled for each instruction set.
//
// Guarantee: every number has the bits that the code for one ray (`local_ray.hpp`, `round.hpp`, `planes.hpp`,
// `sheared.hpp`) gives for that ray alone: the same operations in the same order, with choices in place of branches. Where
// that would take what rays hardly ever need, `again` is set, and the one who asks has that ray answered alone.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lanes/dispatch.hpp"

namespace graze::rays {

struct alignas(64) RayBlock {
  static constexpr std::size_t size = 64;  ///< a multiple of every number of lanes
  using Numbers = double[size];

  // In the caller's frame. Where `end` is less than zero the ray hits nothing.
  Numbers from[3], along[3], end;
  // In the shape's; as `LocalRay`. `blur` is set where it is asked for.
  Numbers origin[3], direction[3], blur;
  // Hits, there; `state` tells of which rays.
  Numbers t, point[3], normal[3];
  std::uint8_t state[size];
  // Hits in the caller's frame, in his scalar.
  double world_t[size], world_point[3][size], world_normal[3][size];
};

enum RayState : std::uint8_t { ray_missed, ray_hit, ray_again };

/// A frame: translation, and unit quaternion x, y, z, w.
struct BlockFrame {
  double translation[3], rotation[4];
};

/// A sphere, box, half-space or triangle without rounding that the closed forms do not cover.
struct BlockShape {
  enum Kind { none, ball, box, half_space, triangle } kind = none;
  double radius = 0;  ///< of the ball; of the half-space its height
  /// The ball's centre, the box's half extents, the triangle's corners.
  double points[3][3] = {};
  double around = 0;  ///< of the ball about the frame's origin that a ray has to come near to
  bool both_sides = true;
};

}  // namespace graze::rays

namespace graze {

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// From the caller's frame, whose scalar is T, into the shape's.
    template <class T> void block_to_local(rays::RayBlock& block, std::size_t count, const rays::BlockFrame& frame);
    /// Sets `state` and the hits.
    void block_hits(rays::RayBlock& block, std::size_t count, const rays::BlockShape& shape);
    /// Hits from the shape's frame into the caller's, with numbers of T; `ray_again` where rounding has turned a normal
    /// along the ray.
    template <class T> void block_to_world(rays::RayBlock& block, std::size_t count, const rays::BlockFrame& frame);)
// clang-format on

}  // namespace graze
