// A point of contact added to those of a manifold.
//
// Guarantee: names are unique within a manifold, and no two of its points stand at one place.
#pragma once

#include <cmath>

#include "graze/contact.hpp"

namespace graze {

/// Appends a point, unless one of the same features is known, or one at the same place: rounding splits a point in two
/// where edges end about on a corner. Of the two the deeper is kept.
template <class T>
void add_point(const ContactPoint<T>& point, T together, Manifold<T>& manifold) {
  for (ContactPoint<T>& known : manifold.points) {
    const auto near = [&](const Vec3<T>& p, const Vec3<T>& q) {
      return std::abs(p.x - q.x) <= together && std::abs(p.y - q.y) <= together && std::abs(p.z - q.z) <= together;
    };
    const bool same = known.feature == point.feature || (near(known.a, point.a) && near(known.b, point.b));
    if (!same) continue;
    if (point.distance < known.distance) known = point;
    return;
  }
  manifold.points.push_back(point);
}

}  // namespace graze
