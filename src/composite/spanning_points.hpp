// The points of a manifold that span it.
//
// Guarantee: every point that is left out lies between others that are as deep there: inside their hull or on its edge,
// across the normal, or at the same place. What is pushed out at those is pushed out at it.
#pragma once

#include <algorithm>

#include "composite/internal_edges/leaf_in_context.hpp"
#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/small_vector.hpp"

namespace graze {

namespace detail {

/// A point across the normal, and which of the manifold's it is.
template <class T>
struct FlatPoint {
  T x, y;
  std::size_t index;
};

template <class T>
T turn(const FlatPoint<T>& a, const FlatPoint<T>& b, const FlatPoint<T>& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Room for those of nearly all manifolds.
template <class T>
using FlatPoints = SmallVector<FlatPoint<T>, 16>;

/// The corners of the convex hull, counter-clockwise; what is within `noise` (an area) of an edge is no corner.
/// Andrew 1979, "Another efficient algorithm for convex hulls in two dimensions".
template <class T>
FlatPoints<T> hull_of(FlatPoints<T> points, T noise) {
  std::sort(points.begin(), points.end(),
            [](const auto& p, const auto& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  FlatPoints<T> hull;
  const auto chain = [&](const FlatPoint<T>& p, std::size_t least_size) {
    while (hull.size() > least_size && turn(hull[hull.size() - 2], hull.back(), p) <= noise)
      hull.truncate(hull.size() - 1);
    hull.push_back(p);
  };
  for (const auto& p : points) chain(p, 1);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) chain(points[i], lower);
  hull.truncate(hull.size() - 1);  // the first point again
  return hull;
}

}  // namespace detail

/// Keeps the deepest of points that are all at one place, as those of a ball on the seam of two triangles. Returns
/// whether they were.
template <class T>
bool join_at_one_place(Manifold<T>& manifold, T together) {
  ContactPoint<T> deepest = manifold.points[0];
  for (const ContactPoint<T>& p : manifold.points) {
    if (max_abs(p.a - manifold.points[0].a) > together || max_abs(p.b - manifold.points[0].b) > together) return false;
    if (p.distance < deepest.distance) deepest = p;
  }
  manifold.points.truncate(1);
  manifold.points[0] = deepest;
  return true;
}

/// Leaves out the points that others span. `size`: of the smaller shape. Costs n log n.
template <class T>
void keep_spanning(Manifold<T>& manifold, T size) {
  if (manifold.points.size() < 2) return;
  if (join_at_one_place(manifold, tolerance<T> * size + place_noise(manifold.points[0].a))) return;
  if (manifold.points.size() < 3) return;
  const Vec3<T> n = manifold.normal, u = normalized(any_perpendicular(n)), v = cross(n, u);
  const Vec3<T> origin = manifold.points[0].a;
  detail::FlatPoints<T> flat;
  T reach(0);
  for (std::size_t i = 0; i < manifold.points.size(); ++i) {
    const Vec3<T> d = manifold.points[i].a - origin;
    flat.push_back({dot(d, u), dot(d, v), i});
    reach = greatest(reach, length(d));
  }
  // The distance of a point from its true place, at most; an area's error is that times the reach.
  const T noise = tolerance<T> * reach + T(64) * std::numeric_limits<T>::epsilon() * max_abs(origin);
  const auto hull = detail::hull_of(flat, noise * reach);
  if (hull.size() < 2) return;
  SmallVector<char, 16> keep;
  for (std::size_t i = 0; i < flat.size(); ++i) keep.push_back(0);
  for (const auto& corner : hull) keep[corner.index] = 1;
  // The distance between the corners: in the triangle, of the fan about the first, that the direction to a point meets.
  const auto distance = [&](std::size_t i) { return manifold.points[hull[i].index].distance; };
  const auto spanned = [&](const detail::FlatPoint<T>& p) {
    if (hull.size() == 2) {
      const T x = hull[1].x - hull[0].x, y = hull[1].y - hull[0].y;
      const T along = clamp(((p.x - hull[0].x) * x + (p.y - hull[0].y) * y) / (x * x + y * y), T(0), T(1));
      return distance(0) * (T(1) - along) + distance(1) * along;
    }
    std::size_t low = 1, high = hull.size() - 1;
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      (detail::turn(hull[0], hull[middle], p) >= T(0) ? low : high) = middle;
    }
    const T whole = detail::turn(hull[0], hull[low], hull[high]);
    const T of_high = clamp(detail::turn(hull[0], hull[low], p) / whole, T(0), T(1));
    const T of_low = clamp(detail::turn(hull[0], p, hull[high]) / whole, T(0), T(1) - of_high);
    return distance(0) * (T(1) - of_low - of_high) + distance(low) * of_low + distance(high) * of_high;
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < manifold.points.size(); ++i) {
    if (keep[i] == 0 && manifold.points[i].distance >= spanned(flat[i]) - noise) continue;
    manifold.points[kept++] = manifold.points[i];
  }
  manifold.points.truncate(kept);
}

}  // namespace graze
