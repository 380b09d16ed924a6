// The faces and edges of a small polyhedron as the separating-axis test reads them by lanes.
//
// Guarantee: no vertex lies beyond a face's plane but for the rounding to float, and no point of the inner ball outside
// the polyhedron.
#pragma once

#include <limits>
#include <span>

#include "graze/shape/convex_hull.hpp"
#include "shape/hull_hierarchy.hpp"

namespace graze {

/// By Euler's formula, of triangles.
inline constexpr std::size_t most_scanned_faces = 2 * scan_limit - 4, most_scanned_edges = 3 * scan_limit - 6;

constexpr std::size_t face_blocks(std::size_t faces) { return (faces + FaceBlock::size - 1) / FaceBlock::size; }
constexpr std::size_t edge_blocks(std::size_t edges) { return (edges + EdgeBlock::size - 1) / EdgeBlock::size; }

/// Of the ball about the vertices' mean that touches the nearest face; rounded inwards.
struct InnerBall {
  Vec3<float> middle;
  float radius;
};

/// Puts a plane where no vertex lies beyond it.
inline void move_out(Plane<double>& plane, std::span<const Vec3d> vertices) {
  plane.offset = -std::numeric_limits<double>::infinity();
  for (const Vec3d& v : vertices) plane.offset = greatest(plane.offset, dot(plane.normal, v));
}

/// What a block has no face or edge for is the first again.
inline void write_faces(std::span<const Plane<double>> planes, FaceBlock* blocks) {
  for (std::size_t i = 0; i < face_blocks(planes.size()) * FaceBlock::size; ++i) {
    const Plane<double>& plane = planes[i < planes.size() ? i : 0];
    const std::size_t k = i % FaceBlock::size;
    const Vec3<float> n = cast<float>(plane.normal);
    FaceBlock& block = blocks[i / FaceBlock::size];
    block.x[k] = n.x, block.y[k] = n.y, block.z[k] = n.z;
    block.offset[k] = static_cast<float>(plane.offset);
  }
}
/// Every face has an edge, and so gets its vertex too.
inline void write_edges(std::span<const HullEdge> edges, std::span<const Plane<double>> planes, EdgeBlock* blocks,
                        FaceBlock* faces) {
  for (std::size_t i = 0; i < edge_blocks(edges.size()) * EdgeBlock::size; ++i) {
    const HullEdge& e = edges[i < edges.size() ? i : 0];
    const auto [left, right] = e.face;
    const std::size_t k = i % EdgeBlock::size;
    EdgeBlock& block = blocks[i / EdgeBlock::size];
    block.left[k] = static_cast<std::uint8_t>(left);
    block.right[k] = static_cast<std::uint8_t>(right);
    block.cosine[k] = static_cast<float>(dot(planes[left].normal, planes[right].normal));
    for (const std::uint32_t f : e.face)
      faces[f / FaceBlock::size].vertex[f % FaceBlock::size] = static_cast<std::uint8_t>(e.vertex[0]);
  }
}

inline InnerBall inner_ball(std::span<const Vec3d> vertices, std::span<const Plane<double>> planes) {
  Vec3d sum{};
  for (const Vec3d& v : vertices) sum += v;
  const Vec3<float> middle = cast<float>(sum / static_cast<double>(vertices.size()));
  double radius = std::numeric_limits<double>::infinity();
  for (const Plane<double>& plane : planes) radius = least(radius, -signed_distance(plane, cast<double>(middle)));
  return {middle, greatest(0.0f, static_cast<float>(radius) * (1 - std::numeric_limits<float>::epsilon()))};
}

/// Of a polyhedron whose vertices are scanned and whose normals are there.
inline void fill_facets(HullData<float>& hull) {
  std::vector<Vec3d> vertices;
  for (const Vec3<float>& v : hull.vertices) vertices.push_back(cast<double>(v));
  FacetRows& rows = hull.facets;
  for (Plane<double>& plane : rows.planes) move_out(plane, vertices);
  rows.faces.resize(face_blocks(rows.planes.size()));
  rows.edges.resize(edge_blocks(hull.edges.size()));
  write_faces(rows.planes, rows.faces.data());
  write_edges(hull.edges, rows.planes, rows.edges.data(), rows.faces.data());
  const InnerBall ball = inner_ball(vertices, rows.planes);
  rows.middle = ball.middle;
  rows.inner_radius = ball.radius;
}

}  // namespace graze
