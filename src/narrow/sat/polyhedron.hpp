// A polyhedron for the separating-axis test: box, rectangle, triangle and convex hull in one form, placed in the frame
// of the pair.
//
// Guarantee: numbers of vertices and faces are the shape's own. A flat polygon is a prism of zero height: its front (0)
// and back (1), and one side an edge, so that it has the axes and arcs of a solid.
#pragma once

#include <cstdint>
#include <span>

#include "graze/shape.hpp"
#include "narrow/manifold/clip_faces.hpp"
#include "narrow/manifold/polygon.hpp"

namespace graze {

/// The normal of a triangle, not of unit length; zero for a sliver.
template <class T>
Vec3d triangle_normal(const Triangle<T>& triangle);

class Polyhedron {
 public:
  Polyhedron() = default;
  Polyhedron(const Polyhedron&) = delete;  // it refers to its own members
  Polyhedron& operator=(const Polyhedron&) = delete;

  /// The number of edges of a shape's polyhedron; 0 when it has none: for a shape that is not flat-sided, or so slender
  /// that its normal would be mere rounding.
  template <class T>
  static std::size_t edge_count(const Shape<T>& shape);

  /// Takes the core of `shape`, which must have edges and outlive this object, moved by a rotation and a translation.
  template <class T>
  void set(const Shape<T>& shape, const Mat3d& rotation, const Vec3d& translation);
  /// Takes the core of `shape` in its own frame.
  template <class T>
  void set(const Shape<T>& shape);

  std::span<const Vec3d> vertices() const { return {vertices_.data(), vertices_.size()}; }
  std::span<const Vec3d> normals() const { return {normals_.data(), normals_.size()}; }
  /// The offset of face `f`'s plane along its normal.
  double offset(std::size_t f) const { return offsets_[f]; }
  std::span<const HullEdge> edges() const { return edges_; }
  /// The vertices of a face, counter-clockwise seen from outside; for a flat polygon's side, its edge.
  std::span<const std::uint32_t> loop(std::size_t face) const {
    return loops_.subspan(begins_[face], begins_[face + 1] - begins_[face]);
  }

  /// The vertex that lies furthest along a direction; `support_face` is the face there that leans least from it.
  std::size_t support_vertex(const Vec3d& direction) const;
  PlacedFace support_face(const Vec3d& direction) const;

 private:
  template <class T>
  void set(const Box<T>& box);
  template <class T>
  void set(const Triangle<T>& triangle);
  template <class T>
  void set(const ConvexHull<T>& hull);
  template <class T>
  void take(const Shape<T>& shape);
  void add_sides();
  void add_offsets();

  SmallVector<Vec3d, 96> vertices_, normals_;
  SmallVector<double, 96> offsets_;
  std::span<const HullEdge> edges_;
  std::span<const std::uint32_t> begins_, loops_;
  /// The faces at each vertex; without begins one list serves for every vertex.
  std::span<const std::uint32_t> incident_begins_, incident_;
  // Parts of a flat polygon that its shape does not store.
  SmallVector<HullEdge, 16> flat_edges_;
  SmallVector<std::uint32_t, 32> flat_begins_, flat_loops_;
};

}  // namespace graze
