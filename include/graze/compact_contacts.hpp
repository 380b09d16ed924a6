// Compact contacts of a batch: the normal of each manifold, the position and the distance of each point.
//
// Guarantee: normals and distances equal those of `BatchContacts` to the last bit, and positions those that
// `ContactPoint::position()` gives. Features, points on either shape and pieces of composites are left out, and pairs
// without contacts take no memory: four points of two boxes take 88 bytes in float, in `BatchContacts` 184.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "graze/vec3.hpp"

namespace graze {

/// Compact contacts of a batch, for callers who need points, normals and distances only.
template <class T>
struct CompactContacts {
  /// Points of contact of one pair that share a normal.
  struct Group {
    Vec3<T> normal{};        ///< unit, from A to B
    std::uint32_t pair = 0;  ///< index of the pair in the batch
    std::uint32_t first_point = 0, point_count = 0;
  };
  /// One point of contact, in world space.
  struct Point {
    Vec3<T> position{};  ///< `ContactPoint::position()`
    T distance{};        ///< signed: negative is penetration
  };
  /// Manifolds of a pair are contiguous. Pairs may come in another order than in the batch; the order is a function of
  /// the batch and of whether there is an executor.
  std::vector<Group> manifolds;
  std::vector<Point> points;  ///< points of a manifold are contiguous

  /// Puts the contacts of other pairs, which are those of the batch from the `first_pair`-th on, behind these.
  void append(const CompactContacts& others, std::size_t first_pair) {
    const auto before = static_cast<std::uint32_t>(first_pair), first_point = static_cast<std::uint32_t>(points.size());
    for (Group manifold : others.manifolds) {
      manifold.pair += before;
      manifold.first_point += first_point;
      manifolds.push_back(manifold);
    }
    points.insert(points.end(), others.points.begin(), others.points.end());
  }
  std::span<const Point> points_of(const Group& m) const {
    return std::span(points).subspan(m.first_point, m.point_count);
  }
};

}  // namespace graze
