// The separating-axis test of any two polyhedra: face normals by support queries, and products of those edges only
// whose arcs cross on the Gauss map (Gregorius 2013, "The separating axis test between convex polyhedra", Game
// Developers Conference): exactly the facets of the Minkowski difference.
//
// Guarantee: the largest separation of all is a lower bound of the distance, and for overlapping polyhedra exactly
// minus their depth. Only the intervals decide it; the choice of an axis for contacts is separate.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "narrow/sat/polyhedron.hpp"
#include "narrow/sat/separating_axis.hpp"

namespace graze {

/// The best axes; or, where a face already separates the polyhedra by more than `enough`, those of faces only. Costs
/// faces of A times vertices of B and the reverse, and little more: few edges can show a larger separation than the
/// faces.
SeparatingAxes separating_axes(const Polyhedron& a, const Polyhedron& b, double enough);

/// Every axis, one by one, for an explanation: A's faces, B's, and all pairs of edges that cross on the Gauss map.
/// Costs the vertices of both for each.
std::vector<SeparatingAxis> all_separating_axes(const Polyhedron& a, const Polyhedron& b);

/// The least dot product of a point with a direction.
double lowest(std::span<const Vec3d> points, const Vec3d& direction);

/// `name` followed by a number.
std::string numbered(std::string name, std::size_t number);
/// The name of an axis of two polyhedra: "A face 3", "B face 12", "A edge 1 × B edge 7".
std::string axis_name(const SeparatingAxis& axis);

}  // namespace graze
