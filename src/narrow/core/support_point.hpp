// The result of a support query of a Minkowski difference.
#pragma once

#include "graze/vec3.hpp"

namespace graze {

/// A point w = b - a of the difference B - A with the two points that make it, in A's frame.
struct SupportPoint {
  Vec3d a, b, w;
};

/// Copies number by number. Compilers copy by sixteen bytes or more, and such a load of numbers just stored by eight
/// bytes waits until the stores have reached the cache: in an iteration this delays everything that follows.
inline Vec3d by_parts(const Vec3d& v) { return {v.x, v.y, v.z}; }
inline SupportPoint by_parts(const SupportPoint& p) { return {by_parts(p.a), by_parts(p.b), by_parts(p.w)}; }

}  // namespace graze
