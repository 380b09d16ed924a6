// The faces and edges of a small polyhedron as the separating-axis test reads them by lanes.
//
// Guarantee: no vertex lies beyond a face's plane but for the rounding to float. Planes of merged faces stand off their
// vertices, and the inner ball out of the polyhedron, by no more than faces are merged by.
#pragma once

#include <limits>
#include <span>

#include "graze/shape/convex_hull.hpp"

namespace graze {

/// Pairs of edges up to which the separating axes give contacts about as soon as GJK with EPA. Measured on lanes: of a
/// box with a hull of 4 points 0.87 of that time, of a triangle with one of 8 0.83, of two hulls 0.98 to 1.08; one by
/// one, as doubles and flat hulls still do, 0.96 to 1.16. Two hulls of 32 points would take 1.26 on lanes.
/// No polyhedron has fewer edges than a triangle's six, so that one with more than `most_faceted_edges` is never taken.
inline constexpr std::size_t most_edge_pairs = 200, most_faceted_edges = (most_edge_pairs + 1) / 6;
/// The most faces of such a polyhedron by Euler's formula, as every vertex and every face has at least three edges.
inline constexpr std::size_t most_faceted_faces = 2 * most_faceted_edges / 3;

constexpr std::size_t face_blocks(std::size_t faces) { return (faces + FaceBlock::size - 1) / FaceBlock::size; }
constexpr std::size_t edge_blocks(std::size_t edges) { return (edges + EdgeBlock::size - 1) / EdgeBlock::size; }

/// The ball about the vertices' mean that touches the nearest face; rounded inwards.
struct InnerBall {
  Vec3<float> middle;
  float radius;
};

/// Puts a plane where no vertex lies beyond it.
inline void move_out(Plane<double>& plane, std::span<const Vec3d> vertices) {
  plane.offset = -std::numeric_limits<double>::infinity();
  for (const Vec3d& v : vertices) plane.offset = greatest(plane.offset, dot(plane.normal, v));
}

/// Writes the planes of faces into blocks; places without a face repeat the first.
inline void write_faces(std::span<const Plane<double>> planes, FaceBlock* blocks) {
  for (std::size_t i = 0; i < face_blocks(planes.size()) * FaceBlock::size; ++i) {
    const Plane<double>& plane = planes[i < planes.size() ? i : 0];
    const std::size_t k = i % FaceBlock::size;
    const Vec3<float> n = converted<float>(plane.normal);
    FaceBlock& block = blocks[i / FaceBlock::size];
    block.x[k] = n.x, block.y[k] = n.y, block.z[k] = n.z;
    block.offset[k] = static_cast<float>(plane.offset);
  }
}
/// Writes edges into blocks, and a vertex of each face, since every face has an edge.
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
  const Vec3<float> middle = converted<float>(sum / static_cast<double>(vertices.size()));
  double radius = std::numeric_limits<double>::infinity();
  for (const Plane<double>& plane : planes) radius = least(radius, -signed_distance(plane, converted<double>(middle)));
  return {middle, greatest(0.0f, static_cast<float>(radius) * (1 - std::numeric_limits<float>::epsilon()))};
}

/// Fills the facets of a polyhedron with few edges, from the unit normals of its faces.
inline void fill_facets(HullData<float>& hull, std::span<const Vec3d> normals) {
  std::vector<Vec3d> vertices;
  for (const Vec3<float>& v : hull.vertices) vertices.push_back(converted<double>(v));
  FacetRows& rows = hull.facets;
  for (const Vec3d& n : normals) move_out(rows.planes.emplace_back(Plane<double>{n, 0}), vertices);
  rows.faces.resize(face_blocks(rows.planes.size()));
  rows.edges.resize(edge_blocks(hull.edges.size()));
  write_faces(rows.planes, rows.faces.data());
  write_edges(hull.edges, rows.planes, rows.edges.data(), rows.faces.data());
  const InnerBall ball = inner_ball(vertices, rows.planes);
  rows.middle = ball.middle;
  rows.inner_radius = ball.radius;
}

}  // namespace graze
