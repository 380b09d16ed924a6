// Where the pairs of a batch touch, in few bytes: of each manifold its normal, of each point where it is and how far
// apart the shapes are there.
//
// Guarantee: to the last bit the normals and distances of `BatchContacts`, and the places that its points'
// `position()` gives. Its features, its points on either shape and the pieces of composites are left out, and pairs
// that have no contacts take no memory: four points of two boxes take 88 bytes in float, and there 184.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graze/vec3.hpp"

namespace graze {

/// What `contacts` finds for a batch, for callers who want points, normals and distances only.
template <class T>
struct CompactContacts {
  /// Points of contact of one pair that share a normal.
  struct Group {
    Vec3<T> normal{};        ///< unit, from A to B
    std::uint32_t pair = 0;  ///< its place in the batch
    std::uint32_t first_point = 0, point_count = 0;
  };
  /// One point of contact, in world space.
  struct Point {
    Vec3<T> position{};  ///< `ContactPoint::position()`
    T distance{};        ///< signed: negative is penetration
  };
  /// Manifolds of a pair stand one behind the other. Pairs may come in another order than in the batch, which is a
  /// function of the batch alone.
  std::vector<Group> manifolds;
  std::vector<Point> points;  ///< those of a manifold one behind the other

  std::span<const Point> points_of(const Group& m) const {
    return std::span(points).subspan(m.first_point, m.point_count);
  }
};

}  // namespace graze
