// The manifold of two faces: the intersection of their projections along a normal.
//
// Guarantee: every point lies on both faces (extended along the normal), b - a is its distance along the normal, and
// the points span the whole area in which the faces overlap.
//
// There are four face clippers. This one takes any two faces of one pair, with lists that grow. Lanes cannot follow
// lists of different lengths, so pairs across lanes have clippers with a fixed number of slots, each for the directions
// of sides that it knows beforehand: two rectangles (`pairs/box_box/clip_box_faces.hpp`), a rectangle and a triangle
// (`pairs/box_triangle/clip_over_box.hpp`), and two triangles (`pairs/triangle_triangle/clip_triangles.hpp`). They
// share the polygon's slots and its simplification (`pairs/box_box/contact_polygon.hpp`), and tests hold them against
// this one.
#pragma once

#include <span>

#include "graze/contact.hpp"
#include "graze/shape/face.hpp"
#include "narrow/core/minkowski.hpp"
#include "narrow/manifold/features.hpp"

namespace graze {

/// A support face in the frame of the pair. One vertex, an edge or a convex polygon.
struct PlacedFace {
  SmallVector<Vec3d, 16> vertices;
  SmallVector<std::uint32_t, 16> ids;
  std::uint32_t id = 0;
};

/// A place where two faces touch, before rounding: apart along the normal, and where two edges run along each other not
/// quite in parallel, across it too.
struct FaceContact {
  Vec3d a, b;
  std::uint32_t feature;
};

using FaceContacts = SmallVector<FaceContact, 16>;

/// Receives the cuts of a clip, in the frame of the pair, without an influence on them.
class CutObserver {
 public:
  virtual ~CutObserver() = default;
  /// A cut along the edge from `from` to `to` of the cutting face, and what is left of the other one.
  virtual void cut(const Vec3d& from, const Vec3d& to, std::span<const Vec3d> left) = 0;
};

/// The outward unit normal of a polygon, by Newell's method; zero for anything less than a polygon with an area.
Vec3d polygon_normal(const PlacedFace& face);

/// Clips B's face by A's, projected along the unit normal (from A to B), and appends the vertices of their
/// intersection: vertices of one inside the other, and crossings of edges; for two edges that are about parallel, the
/// ends of the stretch along which they overlap, wherever they lie. Nothing when they cross in a point or do not meet:
/// the closest points serve better then. An edge along a rim may lie beside the face by `beside`, the effect of the
/// normal's rounding on its projection. `observer` may be null.
void clip_faces(const PlacedFace& a, const PlacedFace& b, const Vec3d& normal, double beside, FaceContacts& contacts,
                CutObserver* observer = nullptr);

/// The number of the features of A and B that a pair of points lies on, as in `clip_faces`. Takes faces of any kind.
std::uint32_t feature_at(const PlacedFace& a, const Vec3d& on_a, const PlacedFace& b, const Vec3d& on_b,
                         const Vec3d& normal);

}  // namespace graze
