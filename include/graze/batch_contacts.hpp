// Contacts of a batch: the manifolds and points of all its pairs in three arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "graze/contact.hpp"

namespace graze {

/// Contacts of a batch, filled by `contacts`. `Point`: a point of contact of the batch's space.
template <class T, class Point = ContactPoint<T>>
struct BatchContacts {
  /// One pair of the batch.
  struct Pair {
    bool overlap;  ///< distance <= 0, whatever the margin
    std::uint32_t first_manifold, manifold_count;
  };
  /// One manifold of a pair.
  struct Group {
    decltype(Point::a) normal{};             ///< unit, from A to B
    std::uint32_t piece_a = 0, piece_b = 0;  ///< the triangle or child of a composite that touches, else 0
    std::uint32_t first_point = 0, point_count = 0;
  };
  std::vector<Pair> pairs;       ///< one for each pair of the batch, in its order
  std::vector<Group> manifolds;  ///< manifolds of a pair are contiguous
  std::vector<Point> points;     ///< points of a manifold are contiguous

  /// Puts the contacts of other pairs behind these.
  void append(const BatchContacts& others) {
    const auto first_manifold = static_cast<std::uint32_t>(manifolds.size()),
               first_point = static_cast<std::uint32_t>(points.size());
    for (Pair pair : others.pairs) {
      pair.first_manifold += first_manifold;
      pairs.push_back(pair);
    }
    for (Group manifold : others.manifolds) {
      manifold.first_point += first_point;
      manifolds.push_back(manifold);
    }
    points.insert(points.end(), others.points.begin(), others.points.end());
  }
  std::span<const Group> manifolds_of(std::size_t pair) const {
    return std::span(manifolds).subspan(pairs[pair].first_manifold, pairs[pair].manifold_count);
  }
  std::span<const Point> points_of(const Group& m) const {
    return std::span(points).subspan(m.first_point, m.point_count);
  }
};

}  // namespace graze
