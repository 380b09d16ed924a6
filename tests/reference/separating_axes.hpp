// Depth of two overlapping convex polyhedra by the separating-axis theorem, in the textbook form: S. Gottschalk, M. C.
// Lin, D. Manocha, "OBBTree: A Hierarchical Structure for Rapid Interference Detection", SIGGRAPH 1996, section 5.
//
// The Minkowski difference of two polyhedra is a polyhedron whose faces are perpendicular to a face normal of either or
// to an edge of each, and its depth is the distance of the nearest of those faces. Every axis tried gives a depth that
// truly separates, so one axis too many is harmless; only a missing one could do damage.
//
// Of the library this takes the vector as a plain triple, for the convenience of who compares; no arithmetic, for the
// reason that shape.hpp gives. Hence the include by path: the reference has no way to the library's headers.
#pragma once

#include <vector>

#include "../../include/graze/vec3.hpp"
#include "shape.hpp"

namespace graze {
template <class T>
struct Pose;
}

namespace graze::test {

struct Polyhedron {
  std::vector<Vec3<long double>> vertices;
  std::vector<std::vector<int>> faces;  // polygons, counter-clockwise seen from outside
};

struct AxisResult {
  // The shortest way out along any axis; -gap when the two are apart.
  long double depth;
  Vec3<long double> normal;  // unit, from A to B; one of them where several are best
  bool overlap;              // touching included
  // The largest separation along an axis, zero when the two overlap. Less than the distance where two corners, or a
  // corner and an edge, are nearest.
  long double gap;
  // The smallest depth of the directions that differ from `normal` by more than `same_direction`. The way out to the
  // other side of the same axis is among them. The minimum is unique if this is clearly larger than `depth`.
  long double runner_up;
};

inline constexpr long double same_direction = 1e-6L;  // radians

AxisResult separating_axes(const Polyhedron& a, const Polyhedron& b);

// Centred on the origin. Any edge length may be zero.
Polyhedron polyhedron_of_box(const Vec3<long double>& edge_lengths);

// The hull by enumeration: each three points that no other lies beyond are a face. Coplanar points therefore give more
// triangles, and edges, than the hull has. O(n^4).
Polyhedron polyhedron_of_hull(const std::vector<Vec3<long double>>& points);

// A flat convex polygon: its corners in order, seen from either side.
Polyhedron polyhedron_of_polygon(const std::vector<Vec3<long double>>& corners);

// The quaternion is normalised in extended precision.
Polyhedron moved(const Polyhedron& polyhedron, const reference::Vector& translation,
                 const reference::Quaternion& rotation);

template <class T>
Polyhedron moved(const Polyhedron& polyhedron, const Pose<T>& pose) {
  const auto real = [](const T& x) { return static_cast<long double>(x); };
  const auto& t = pose.translation;
  const auto& q = pose.rotation;
  return moved(polyhedron, {real(t.x), real(t.y), real(t.z)}, {real(q.x), real(q.y), real(q.z), real(q.w)});
}

template <class T>
Polyhedron polyhedron_of_box(const Vec3<long double>& edge_lengths, const Pose<T>& pose) {
  return moved(polyhedron_of_box(edge_lengths), pose);
}

}  // namespace graze::test
