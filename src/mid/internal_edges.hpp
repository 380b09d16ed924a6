// Contacts that only the cutting of a surface into pieces makes, and what is there instead.
//
// A piece of a composite does not know its neighbours: a box that slides over a floor of triangles meets, a little below
// the surface, the edges that they share, and is pushed aside by them. A normal is one of the surface only if it lies in
// the Voronoi region of the feature that it stands on (Mirtich 1998, "V-Clip", section 2), which is to say that nothing
// of the surface around its point rises above the plane through the point that it is the normal of.
//
// Guarantee: a contact of a solid whose normal is not the surface's is laid along the normal of the piece's own face, or left out
// where that face is not met. It is decided by where the pieces lie and not by which vertices they share, so that
// duplicated vertices, T-junctions, seams of height fields and of neighbouring bodies are all alike.
#pragma once

#include <span>

#include "graze/contact.hpp"
#include "graze/shape.hpp"

namespace graze {

/// A convex piece of a shape, the shape, and what stands still beside it and may continue its surface.
template <class T>
struct PieceOf {
  const Shape<T>& whole;
  const Pose<T>& whole_pose;
  const Shape<T>& piece;
  const Pose<T>& pose;
  std::span<const PlacedRef<T>> beside = {};
};

/// Whether a shape can lie on a surface. Two surfaces cross rather than lie on each other, and the normal of a half-space
/// is right wherever it is met.
template <class T>
bool is_solid(const Shape<T>& shape) {
  return !shape.template as<Triangle<T>>() && !shape.template as<HalfSpace<T>>();
}

/// What becomes of the manifold of two pieces.
template <class T>
struct Settled {
  Manifold<T> manifold;  ///< of the surface; it may have no points
  Manifold<T> instead;   ///< for when no other piece has any: one point, if the manifold has none
};

/// Lays a manifold of two pieces along the surface where its normal is not one of the surface's. No allocation.
template <class T>
Settled<T> settle_normal(const PieceOf<T>& a, const PieceOf<T>& b, T margin, const Manifold<T>& manifold);

}  // namespace graze
