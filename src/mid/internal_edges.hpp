// Contacts that only the cutting of a surface into pieces makes, and what is there instead.
//
// A piece of a composite does not know its neighbours: a box that slides over a floor of triangles meets, a little below
// the surface, the edges that they share, and is pushed aside by them. A normal is one of the surface only if it lies in
// the Voronoi region of the feature that it stands on (Mirtich 1998, "V-Clip", section 2), which is to say that nothing
// of the surface around its point rises above the plane through the point that it is the normal of.
//
// Where a normal is none, what rises (`risers.hpp`) or what lies over the contact (`cover.hpp`) tells the surface's.
//
// Guarantee: a contact of a solid whose normal is not the surface's is laid along the normal of the piece's own face, or of
// what covers it, or left out where the piece is not met along that. It is decided by where the pieces lie and not by which
// vertices they share, so that duplicated vertices, T-junctions, seams of height fields and of neighbouring bodies, solids
// beside sheets among them, are all alike. What a mesh knows of its level triangles only saves the search.
#pragma once

#include "graze/contact.hpp"
#include "mid/piece_of.hpp"

namespace graze {

/// What becomes of the manifold of two pieces.
template <class T>
struct Settled {
  Manifold<T> manifold;  ///< of the surface; it may have no points
  Manifold<T> instead;   ///< for when no other piece has any: one point, if the manifold has none
};

/// Lays a manifold of two pieces along the surface where its normal is not one of the surface's. `distance`: of the two,
/// signed. No allocation.
template <class T>
Settled<T> settle_normal(const PieceOf<T>& a, const PieceOf<T>& b, T margin, const Manifold<T>& manifold, T distance);

}  // namespace graze
