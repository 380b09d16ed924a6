// Depth of two overlapping convex polyhedra by the separating-axis theorem, in the textbook form: S. Gottschalk, M. C.
// Lin, D. Manocha, "OBBTree: A Hierarchical Structure for Rapid Interference Detection", SIGGRAPH 1996, section 5.
//
// The Minkowski difference of two polyhedra is a polyhedron whose faces are perpendicular to a face normal of either or
// to an edge of each, and its depth is the distance of the nearest of those faces. Every axis tried gives a depth that
// truly separates, so one axis too many is harmless; only a missing one could do damage.
#pragma once

#include <vector>

#include "shape.hpp"

namespace graze::reference {

struct Polyhedron {
  std::vector<Vector> vertices;
  std::vector<std::vector<int>> faces;  // polygons, counter-clockwise seen from outside
};

struct AxisResult {
  // The shortest way out along any axis; -gap when the two are apart.
  long double depth;
  Vector normal;  // unit, from A to B; one of them where several are best
  bool overlap;   // touching included
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
Polyhedron polyhedron_of_box(const Vector& edge_lengths);

// The hull by enumeration: each three points that no other lies beyond are a face. Coplanar points therefore give more
// triangles, and edges, than the hull has. O(n^4).
Polyhedron polyhedron_of_hull(const std::vector<Vector>& points);

// A flat convex polygon: its corners in order, seen from either side.
Polyhedron polyhedron_of_polygon(const std::vector<Vector>& corners);

// The quaternion is normalised in extended precision.
Polyhedron moved(const Polyhedron& polyhedron, const Vector& translation, const Quaternion& rotation);

}  // namespace graze::reference
