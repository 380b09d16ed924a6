// Outlines of the area in which two faces lie over each other, in the plane across their normal, and what is left of
// one when corners that mean nothing are dropped.
//
// Guarantee: what is dropped changes the area by no more than `spared_area` and the outline by no more than `near`; the
// deepest corner always stays.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "graze/vec3.hpp"

namespace graze {

/// How near a point must come to the edge of a face to be named after it, relative to the shortest edge at hand. Boxes
/// stacked on each other have edges and corners in about the same place: which lies inside which changes from frame to
/// frame by the rounding of a solver, and the names must not.
inline constexpr double same_place = 1.0 / 100;
/// How far beside a face an edge may lie that runs along its rim, relative to `same_place`: which side of the rim it
/// lies on is rounding then, and may be another at each of its ends.
inline constexpr double along_rim = 1e-8;
/// How far a point may lie beside a sharp edge and count as on it, relative to the smaller shape: well below float's
/// tolerance, and far above the rounding of its poses.
inline constexpr double on_surface = 1e-6;
/// How far off a normal may be that was rounded to T: by so much times what lies between two faces a point of one is
/// seen beside its place on the other.
template <class T>
inline constexpr double normal_rounding = 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
/// How near two points must come to be one that rounding has split: squared, relative to `same_place`. In float the
/// square of some roundings of an edge.
template <class T>
inline constexpr T same_point = T(1e-12);
template <>
inline constexpr float same_point<float> = 1e-8f;
/// Two corners cost the same within this: several roundings of float, and far below what a difference in cost means.
inline constexpr double same_cost = 1e-6;
/// How much of the area that the faces share may be lost with corners that stand out by less than `same_place`.
inline constexpr double spared_area = 1.0 / 40;

/// A face that leans further than this from a direction (its cosine) is seen from the side: an edge or a vertex
/// describes better what lies there. No corner of a box leans as far from all of its three faces.
inline constexpr double furthest_lean = 0.5;

/// Faces laid over each other meet the separation along their axis within this many roundings of a coordinate.
inline constexpr double laid_slack = 64;

/// Coordinates across the normal.
template <class T>
struct FlatPoint {
  T x, y;
};

template <class T>
T cross(const FlatPoint<T>& o, const FlatPoint<T>& p, const FlatPoint<T>& q) {
  return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}
template <class T>
T distance_squared(const FlatPoint<T>& p, const FlatPoint<T>& q) {
  const T x = q.x - p.x, y = q.y - p.y;
  return x * x + y * y;
}

template <class Outline>
auto twice_area(const Outline& outline) {
  decltype(outline[0].x) area = 0;
  for (std::size_t i = 2; i < outline.size(); ++i) area += cross(outline[0], outline[i - 1], outline[i]);
  return area;
}

/// Drops corners that stand out by less than `near` from the line between their neighbours, least area first, while no
/// more than `spared_area` is lost: those of edges that about coincide. The deepest point always stays. `apart` tells
/// of a place how far apart the faces are there.
template <class Outline, class T, class Apart>
void simplify(Outline& outline, T near, const Apart& apart) {
  if (outline.empty()) return;
  std::size_t deepest = 0;
  T least_apart = apart(outline[0]);
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const T here = apart(outline[i]);
    if (!(here < least_apart)) continue;
    least_apart = here;
    deepest = i;
  }
  T budget = T(spared_area) * std::abs(twice_area(outline));
  while (outline.size() > 1) {
    const std::size_t n = outline.size();
    const FlatPoint<T>* points = outline.data();
    std::size_t least_corner = n;
    T least_lost = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == deepest) continue;
      const FlatPoint<T>&before = points[i == 0 ? n - 1 : i - 1], &p = points[i],
            &after = points[i + 1 == n ? 0 : i + 1];
      const bool again = least(distance_squared(before, p), distance_squared(p, after)) <= same_point<T> * near * near;
      const T lost = again ? T(0) : std::abs(cross(before, p, after));
      if (lost > budget || lost * lost > near * near * distance_squared(before, after) || (n == 2 && !again)) continue;
      if (least_corner < n) {
        // Both ends of a trapezoid's side cost the same: the shallower goes, or rounding would choose.
        const bool same = std::abs(lost - least_lost) <= T(same_cost) * least_lost;
        if (same ? apart(p) <= apart(points[least_corner]) : lost > least_lost) continue;
      }
      least_lost = lost;
      least_corner = i;
    }
    if (least_corner == n) return;
    budget -= least_lost;
    for (std::size_t i = least_corner; i + 1 < n; ++i) outline[i] = outline[i + 1];
    outline.truncate(n - 1);
    if (deepest > least_corner) --deepest;
  }
}

}  // namespace graze
