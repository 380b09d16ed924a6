// The manifold of two faces: where they lie over each other along a normal.
//
// Guarantee: every point lies on both faces (prolonged along the normal), b - a is its distance along the normal, and
// the points span the whole area in which the faces lie over each other.
#pragma once

#include "graze/contact.hpp"
#include "graze/shape/face.hpp"
#include "graze/trace.hpp"
#include "narrow/core/minkowski.hpp"
#include "narrow/manifold/features.hpp"

namespace graze {

/// A support face in the frame of the pair. One vertex, an edge or a convex polygon.
struct PlacedFace {
  SmallVector<Vec3d, 16> vertices;
  SmallVector<std::uint32_t, 16> ids;
  std::uint32_t id = 0;
};

/// A place where two faces touch, before rounding: apart along the normal, and where two edges run along each other
/// not quite in parallel, across it too.
struct FaceContact {
  Vec3d a, b;
  std::uint32_t feature;
};

using FaceContacts = SmallVector<FaceContact, 16>;

/// The outward unit normal of a polygon, by Newell's method; zero for anything less than a polygon with an area.
Vec3d polygon_normal(const PlacedFace& face);

/// Lays B's face over A's along the unit normal (from A to B) and appends the vertices of the area that they share:
/// vertices of one inside the other, and crossings of edges; for two edges that are about parallel, the ends of the
/// stretch they run along each other, wherever they lie. Nothing when they cross in a point or do not meet: the closest
/// points serve better then. An edge that runs along a rim may lie beside the face by `beside`, what the normal's
/// rounding may do to where it is seen. Where somebody asks, `cuts` is told every cut.
void clip_faces(const PlacedFace& a, const PlacedFace& b, const Vec3d& normal, double beside, FaceContacts& contacts,
                std::vector<TraceCut>* cuts = nullptr);

/// The number of the features of A and B that a pair of points lies on, as `clip_faces` names them. Faces of any kind.
std::uint32_t feature_at(const PlacedFace& a, const Vec3d& on_a, const PlacedFace& b, const Vec3d& on_b,
                         const Vec3d& normal);

}  // namespace graze
