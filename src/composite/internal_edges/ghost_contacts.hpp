// Contacts that only the cutting of a surface into pieces makes, and what is there instead.
//
// A piece of a composite does not know its neighbours: a box that slides over a floor of triangles meets, a little
// below the surface, the edges that they share, and is pushed aside by them. A normal is one of the surface only if it
// lies in the Voronoi region of the feature that it stands on (Mirtich 1998, "V-Clip", section 2), which is to say that
// nothing of the surface around its point rises above the plane through the point that it is the normal of.
//
// The surface's normal in place of one that is none is told by the neighbour that rises (`voronoi_neighbours.hpp`) or
// by what lies over the contact (`occluders.hpp`).
//
// Guarantee: no contact of a solid has a normal that is not the surface's. What would have one is laid along the least
// way out of the triangle if that is a ridge's or a corner's own, and then has the place where the two are deepest;
// else along the normal of the piece's own face, or of what covers it; or is left out where the piece is not met along
// that. No contact that is inside its region is lost, unless it leads to the back of all around it and another piece
// lies over it.
//
// Regions are told from each other by 1e-4 (sine) and by what coordinates lose by rounding (`leaf_in_context.hpp`): a
// normal that leaves one by less is kept. It is decided by where the pieces lie and not by which vertices they share:
// duplicated vertices, T-junctions, seams of height fields and of neighbouring bodies, solids beside sheets among them,
// are all alike. What a surface knows of itself spares searches and decides nothing: which triangles lie level, and
// which lies beyond each edge, where nearly every neighbour that rises is found (`voronoi_neighbours.hpp`).
//
// A triangle of a surface that has nothing beside it is covered by another of its triangles, which reaches into the
// other shape and has a contact of its own: the covered one has none.
#pragma once

#include "composite/internal_edges/leaf_in_context.hpp"
#include "graze/contact.hpp"

namespace graze {

/// The manifold of two pieces after its normal is settled.
template <class T>
struct Settled {
  Manifold<T> manifold;           ///< of the surface; it may have no points
  Manifold<T> instead;            ///< for when no other piece has any: one point, if the manifold has none
  bool instead_is_ghost = false;  ///< its normal is none of the surface's
};

/// Lays a manifold of two pieces along the surface where its normal is not one of the surface's. `distance`: of the
/// two, signed. No allocation.
template <class T>
Settled<T> settle_normal(const LeafInContext<T>& a, const LeafInContext<T>& b, T margin, const Manifold<T>& manifold,
                         T distance);

}  // namespace graze
