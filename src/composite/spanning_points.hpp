// The points of a manifold that span it.
//
// Guarantee: every point that is left out lies between others that are as deep there: inside their hull or on its edge,
// across the normal, or at the same place. What is pushed out at those is pushed out at it. A point has the number of
// the lowest pieces of those at its place.
#pragma once

#include <algorithm>

#include "composite/internal_edges/leaf_in_context.hpp"
#include "composite/point_names.hpp"
#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/small_vector.hpp"

namespace graze {

namespace detail {

/// A point across the normal, which of the manifold's it is, and its distance along the normal.
template <class T>
struct FlatPoint {
  T x, y;
  std::size_t index;
  T distance;
};

template <class T>
T turn(const FlatPoint<T>& a, const FlatPoint<T>& b, const FlatPoint<T>& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Room for those of nearly all manifolds.
template <class T>
using FlatPoints = SmallVector<FlatPoint<T>, 16>;

/// Measures how far points are to the right of the line from `a` to `b`, which are apart.
template <class T>
class RightOf {
 public:
  RightOf(const FlatPoint<T>& a, const FlatPoint<T>& b, T noise) : a_(a), b_(b) {
    using std::sqrt;
    const T x = b.x - a.x, y = b.y - a.y;
    noise_ = noise * sqrt(x * x + y * y);
  }

  /// In proportion to the distance.
  T operator()(const FlatPoint<T>& p) const { return -turn(a_, b_, p); }
  /// Whether the distance is more than the noise.
  bool has(const FlatPoint<T>& p) const { return (*this)(p) > noise_; }

 private:
  const FlatPoint<T>&a_, &b_;
  T noise_;  ///< as an area, as `turn` is one
};

/// The point of the list that is furthest by a measure, the first of equal ones.
template <class T, class Measure>
const FlatPoint<T>& furthest(const FlatPoints<T>& points, const Measure& measure) {
  return *std::max_element(points.begin(), points.end(),
                           [&](const auto& p, const auto& q) { return measure(p) < measure(q); });
}

/// Appends the corners between `a` and `b`, of the points that are further than `noise` to the right of the line.
template <class T>
void add_corners(const FlatPoints<T>& points, const FlatPoint<T>& a, const FlatPoint<T>& b, T noise,
                 FlatPoints<T>& hull) {
  const RightOf<T> right(a, b, noise);
  FlatPoints<T> outside;
  for (const FlatPoint<T>& p : points)
    if (right.has(p)) outside.push_back(p);
  if (outside.empty()) return;
  const FlatPoint<T> corner = furthest(outside, right);
  add_corners(outside, a, corner, noise, hull);
  hull.push_back(corner);
  add_corners(outside, corner, b, noise, hull);
}

/// The corners of the convex hull, counter-clockwise; what is within `noise` of an edge is no corner, and none is left
/// where all are at one place. Eddy 1977, "A new convex hull algorithm for planar sets": points that differ by
/// rounding alone change it by no more than that, whereas one that goes through sorted points may lose the end of a row
/// of them that stands across the direction of sorting.
template <class T>
FlatPoints<T> hull_of(const FlatPoints<T>& points, T noise) {
  const auto from = [](const FlatPoint<T>& a) {
    return [a](const FlatPoint<T>& p) { return (p.x - a.x) * (p.x - a.x) + (p.y - a.y) * (p.y - a.y); };
  };
  const FlatPoint<T> first = furthest(points, from(points[0])), last = furthest(points, from(first));
  FlatPoints<T> found, hull;
  if (!(from(first)(last) > noise * noise)) return hull;
  found.push_back(first);
  add_corners(points, first, last, noise, found);
  const std::size_t place_of_last = found.size();
  found.push_back(last);
  add_corners(points, last, first, noise, found);
  // First and last are corners; of an edge that is parallel to a line, any point may have been found furthest from it.
  for (std::size_t i = 0; i < found.size(); ++i)
    if (i == 0 || i == place_of_last || RightOf<T>(hull.back(), found[(i + 1) % found.size()], noise).has(found[i]))
      hull.push_back(found[i]);
  return hull;
}

/// Calls `f(i, j)` for the indices of points that are at one place and as deep, but for `noise`. Sorts the points.
template <class T, class F>
void each_repeat(FlatPoints<T>& points, T noise, const F& f) {
  // Sorted along a direction that no model is built along, so that points near each other there are few.
  const auto along = [](const FlatPoint<T>& p) { return p.x * T(0.6079) + p.y * T(0.7940); };
  std::sort(points.begin(), points.end(), [&](const auto& p, const auto& q) { return along(p) < along(q); });
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size() && along(points[j]) - along(points[i]) <= T(2) * noise; ++j) {
      const FlatPoint<T>&p = points[i], &q = points[j];
      using std::abs;
      if (abs(p.x - q.x) <= noise && abs(p.y - q.y) <= noise && abs(p.distance - q.distance) <= noise)
        f(p.index, q.index);
    }
}

/// Unmarks, in `keep`, points of `inner` that repeat an earlier one: those of an edge that both of its triangles find.
template <class T>
void leave_out_repeats(FlatPoints<T>& inner, T noise, SmallVector<char, 16>& keep) {
  each_repeat(inner, noise, [&](std::size_t i, std::size_t j) { keep[greatest(i, j)] = 0; });
}

/// Gives the marked points the lowest name of the points that they stand for: which of these rounding has marked is
/// not to change it. Sorts the points.
template <class T>
void share_names(FlatPoints<T>& points, T noise, const SmallVector<char, 16>& keep, const PointNames& names,
                 Manifold<T>& manifold) {
  each_repeat(points, noise, [&](std::size_t i, std::size_t j) {
    if (keep[i] != 0 && keep[j] == 0) names.share(manifold.points[i], manifold.points[j]);
    if (keep[j] != 0 && keep[i] == 0) names.share(manifold.points[j], manifold.points[i]);
  });
}

}  // namespace detail

/// Keeps the deepest of points that are all at one place, as those of a ball on the seam of two triangles. Returns
/// whether they were.
template <class T>
bool join_at_one_place(Manifold<T>& manifold, T most_merged) {
  ContactPoint<T> deepest = manifold.points[0];
  for (const ContactPoint<T>& p : manifold.points) {
    if (max_abs(p.a - manifold.points[0].a) > most_merged || max_abs(p.b - manifold.points[0].b) > most_merged)
      return false;
    if (p.distance < deepest.distance) deepest = p;
  }
  manifold.points.truncate(1);
  manifold.points[0] = deepest;
  return true;
}

/// Leaves out the points that others span. `size`: of the smaller shape; `names`: in which the points have theirs.
/// Costs n log n, but for contrived points.
template <class T>
void keep_spanning(Manifold<T>& manifold, T size, const PointNames& names) {
  if (manifold.points.size() < 2) return;
  if (join_at_one_place(manifold, tolerance<T> * size + place_noise(manifold.points[0].a))) return;
  if (manifold.points.size() < 3) return;
  const Vec3<T> n = manifold.normal, u = normalized(any_perpendicular(n)), v = cross(n, u);
  const Vec3<T> origin = manifold.points[0].a;
  detail::FlatPoints<T> flat;
  T reach(0);
  for (std::size_t i = 0; i < manifold.points.size(); ++i) {
    const Vec3<T> d = manifold.points[i].a - origin;
    flat.push_back({dot(d, u), dot(d, v), i, manifold.points[i].distance});
    reach = greatest(reach, length(d));
  }
  // The distance of a point from its true place, at most.
  const T noise = tolerance<T> * reach + T(64) * std::numeric_limits<T>::epsilon() * max_abs(origin);
  const auto hull = detail::hull_of(flat, noise);
  if (hull.size() < 2) return;
  SmallVector<char, 16> keep;
  for (std::size_t i = 0; i < flat.size(); ++i) keep.push_back(0);
  for (const auto& corner : hull) keep[corner.index] = 1;
  // The distance between the corners: in the triangle, of the fan about the first, that the direction to a point meets.
  const auto distance = [&](std::size_t i) { return hull[i].distance; };
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
  detail::FlatPoints<T> inner;
  for (const auto& p : flat)
    if (keep[p.index] == 0 && p.distance < spanned(p) - noise) {
      inner.push_back(p);
      keep[p.index] = 1;
    }
  detail::leave_out_repeats(inner, noise, keep);
  if (std::count(keep.begin(), keep.end(), 1) == static_cast<std::ptrdiff_t>(flat.size())) return;
  detail::share_names(flat, noise, keep, names, manifold);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < manifold.points.size(); ++i)
    if (keep[i] != 0) manifold.points[kept++] = manifold.points[i];
  manifold.points.truncate(kept);
}

}  // namespace graze
