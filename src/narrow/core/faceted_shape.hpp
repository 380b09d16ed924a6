// A box, a triangle or a small hull with its facets in rows: a hull holds its own, those of the others are made here.
//
// Guarantee: faces, edges and vertices have the numbers that `Polyhedron` gives them.
#pragma once

#include "narrow/box_parts.hpp"
#include "narrow/sat/hull_axes.hpp"
#include "narrow/sat/polyhedron.hpp"

namespace graze {

/// The faces on both sides of each edge, which are perpendicular.
template <std::size_t count>
constexpr EdgeBlock perpendicular_edges(const std::array<HullEdge, count>& edges) {
  static_assert(count <= EdgeBlock::size);
  EdgeBlock block{};
  for (std::size_t i = 0; i < EdgeBlock::size; ++i) {
    const HullEdge& e = edges[i < count ? i : 0];
    block.left[i] = static_cast<std::uint8_t>(e.face[0]);
    block.right[i] = static_cast<std::uint8_t>(e.face[1]);
  }
  return block;
}
inline constexpr EdgeBlock box_edge_block = perpendicular_edges(box_parts.edges);

/// Each edge between the front (0) and a side, and again between the side and the back (1).
inline constexpr std::array<HullEdge, 6> triangle_edges{
    {{{0, 1}, {0, 2}}, {{0, 1}, {2, 1}}, {{1, 2}, {0, 3}}, {{1, 2}, {3, 1}}, {{2, 0}, {0, 4}}, {{2, 0}, {4, 1}}}};
inline constexpr EdgeBlock triangle_edge_block = perpendicular_edges(triangle_edges);

class FacetedShape {
 public:
  /// Takes a shape for which `has_facets` holds, and which must outlive this object.
  explicit FacetedShape(const Shape<float>& shape);
  FacetedShape(const FacetedShape&) = delete;
  FacetedShape& operator=(const FacetedShape&) = delete;

  const FacetedHull& view() const { return view_; }

 private:
  void write(const Vec3<float>& half);
  void write(const Triangle<float>& triangle);
  void write_rows(std::size_t vertices, std::size_t faces, const std::uint8_t* vertex_of_face);

  FacetedHull view_;
  // Storage for shapes other than hulls.
  VertexBlock block_;
  FaceBlock faces_;
  Vec3<float> vertices_[8];
  Plane<double> planes_[6];
};

/// Whether the shape is a box, a rectangle, a triangle that is no sliver, or a hull with few edges.
bool has_facets(const Shape<float>& shape);

}  // namespace graze
