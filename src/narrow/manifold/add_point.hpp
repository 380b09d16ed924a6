// A point of contact added to those of a manifold.
//
// Guarantee: features are unique within a manifold, and no two of its points are at one place.
#pragma once

#include <cmath>

#include "graze/contact.hpp"

namespace graze {

/// Appends a point, unless there is one with the same features, or at the same place: rounding splits a point in two
/// where edges end about on a corner. Keeps the deeper of the two.
template <class T>
void add_point(const ContactPoint<T>& point, T most_merged, Manifold<T>& manifold) {
  for (ContactPoint<T>& known : manifold.points) {
    const auto near = [&](const Vec3<T>& p, const Vec3<T>& q) {
      return std::abs(p.x - q.x) <= most_merged && std::abs(p.y - q.y) <= most_merged &&
             std::abs(p.z - q.z) <= most_merged;
    };
    const bool same = known.feature == point.feature || (near(known.a, point.a) && near(known.b, point.b));
    if (!same) continue;
    if (point.distance < known.distance) known = point;
    return;
  }
  manifold.points.push_back(point);
}

}  // namespace graze
