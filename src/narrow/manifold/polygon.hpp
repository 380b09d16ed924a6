// Outlines of the area in which two faces overlap, in the plane normal to their contact normal, and their
// simplification.
//
// Guarantee: simplification changes the area by no more than `spared_area` and the outline by no more than `near`; the
// deepest corner always stays.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "graze/vec3.hpp"

namespace graze {

/// Distance from a face's edge within which a point gets the edge's feature, relative to the shortest edge at hand.
/// Boxes stacked on each other have edges and corners in about the same place: which lies inside which changes from
/// frame to frame by the rounding of a solver, and features must not.
inline constexpr double same_place = 1.0 / 100;
/// Distance beside a face within which an edge counts as along its rim, relative to `same_place`: the side of the rim
/// on which it lies is then mere rounding, and may differ at its two ends.
inline constexpr double along_rim = 1e-8;
/// Distance beside a sharp edge within which a point counts as on it, relative to the smaller shape: well below float's
/// tolerance, and far above the rounding of its poses.
inline constexpr double on_surface = 1e-6;
/// Error of a normal that was rounded to T: times the distance between two faces it displaces the projection of a point
/// of one on the other.
template <class T>
inline constexpr double normal_rounding = 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
/// Distance of two points that rounding has split within which they are one: squared, relative to `same_place`. In
/// float the square of some roundings of an edge.
template <class T>
inline constexpr T same_point = T(1e-12);
template <>
inline constexpr float same_point<float> = 1e-8f;
/// Relative difference within which two corners cost the same: several roundings of float, and far below a difference
/// that matters.
inline constexpr double same_cost = 1e-6;
/// Part of the faces' common area that may be lost with corners that stand out by less than `same_place`.
inline constexpr double spared_area = 1.0 / 40;

/// Largest lean of a face from a direction (its cosine) for the face to count; beyond that an edge or a vertex is
/// taken, which describes better what lies there. No corner of a box leans as far from all of its three faces.
inline constexpr double furthest_lean = 0.5;

/// Roundings of a coordinate by which clipped faces may differ from the separation along their axis.
inline constexpr double laid_slack = 64;

/// Coordinates in the plane normal to the contact normal.
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

/// Removes corners that stand out by less than `near` from the line between their neighbours, least area first, while
/// no more than `spared_area` is lost: those of edges that about coincide. The deepest point always stays.
/// `apart(place)` returns the distance of the faces there.
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
        // Removing either end of a trapezoid's side costs the same: the shallower is removed, or rounding would choose.
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
