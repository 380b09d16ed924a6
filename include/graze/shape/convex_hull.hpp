// The convex hull of points: a polyhedron, a flat polygon, a segment or a point.
//
// Guarantee: every input point lies inside the hull within `tolerance()`, whatever the points: duplicates, near
// duplicates, collinear, coplanar, any scale, up to 100,000 and more. Shared and immutable once built.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "graze/aabb.hpp"
#include "graze/detail/lent.hpp"
#include "graze/detail/validate.hpp"
#include "graze/lines.hpp"
#include "graze/pose.hpp"
#include "graze/shape/face.hpp"

namespace graze {

/// An edge of a polyhedron, by numbers.
struct HullEdge {
  std::uint32_t vertex[2];  ///< the two ends
  std::uint32_t face[2];    ///< faces left of vertex[0] -> vertex[1] seen from outside, then right; `no_face` for a
                            ///< segment
};

/// Sixteen vertices of a hull, transposed for a scan: the vertex of that number, or the first again where there are
/// fewer. A coordinate takes one cache line.
struct alignas(64) VertexBlock {
  static constexpr std::size_t size = 16;  ///< lanes of a block
  float x[size], y[size], z[size];         ///< lane by lane
};

/// Sixteen faces, transposed for a scan: their outward unit normals, the offsets of their planes, and a vertex of each.
struct alignas(64) FaceBlock {
  static constexpr std::size_t size = VertexBlock::size;  ///< lanes of a block
  float x[size], y[size], z[size], offset[size];          ///< lane by lane
  std::uint8_t vertex[size];                              ///< a vertex of each face
};
/// Sixteen edges, transposed: the numbers of the faces to their left and right, and the cosine between the faces'
/// normals.
struct alignas(32) EdgeBlock {
  static constexpr std::size_t size = VertexBlock::size;  ///< lanes of a block
  std::uint8_t left[size], right[size];                   ///< faces on both sides of each edge
  float cosine[size];                                     ///< cosine of the angle between the faces' normals
};

/// Data for the separating-axis test of a small polyhedron across lanes, in its own frame, and the planes themselves.
struct FacetRows {
  std::vector<FaceBlock> faces;       ///< all faces
  std::vector<EdgeBlock> edges;       ///< all edges
  std::vector<Plane<double>> planes;  ///< planes of the faces: no vertex lies beyond one
  Vec3<float> middle{};               ///< centre of a ball inside the polyhedron
  float inner_radius = 0;             ///< radius of that ball
};

/// The data of a hull. Faces are convex polygons: coplanar triangles are merged.
template <class T>
struct HullData {
  static constexpr std::uint32_t no_face = 0xffffffffu;  ///< placeholder where there is no face

  int dimension = 0;   ///< 0 a point, 1 a segment, 2 a flat polygon, 3 a polyhedron
  T tolerance = T(0);  ///< largest distance of an input point from the hull
  T extent = T(0);     ///< the greatest distance of a vertex from the frame's origin
  // The data of support queries come first, in one cache line.
  std::vector<VertexBlock> blocks;            ///< all vertices, for a hull that is scanned
  std::vector<Vec3<T>> vertices;              ///< the vertices of the hull
  std::vector<Plane<T>> planes;               ///< one a face, outward; a flat polygon has two, back to back
  std::vector<std::uint32_t> face_begin;      ///< face f's loop is loops[face_begin[f] .. face_begin[f + 1])
  std::vector<std::uint32_t> loops;           ///< vertex indices, counter-clockwise seen from outside
  std::vector<HullEdge> edges;                ///< each edge once
  std::vector<std::uint32_t> neighbor_begin;  ///< vertex v's neighbours are neighbors[neighbor_begin[v] .. [v + 1])
  std::vector<std::uint32_t> neighbors;       ///< neighbours of all vertices, those of a vertex contiguous
  std::vector<std::uint32_t> incident_begin;  ///< vertex v's faces are incident[incident_begin[v] .. [v + 1])
  std::vector<std::uint32_t> incident;        ///< faces of all vertices, those of a vertex contiguous
  /// Dobkin and Kirkpatrick's hierarchy, coarsest level first; empty for hulls that a scan answers faster.
  struct Level {
    std::vector<std::uint32_t> vertices;        ///< indices into the hull's vertices
    std::vector<std::uint32_t> finer;           ///< index of each in the next finer level (for the last level in the
                                                ///< hull)
    std::vector<std::uint32_t> neighbor_begin;  ///< as the hull's, for this level
    std::vector<std::uint32_t> neighbors;       ///< indices into this level's vertices
  };
  std::vector<Level> hierarchy;  ///< from the coarsest hull to the finest (Dobkin and Kirkpatrick)
  FacetRows facets;              ///< for a polyhedron in float with few edges

  /// The vertices of a face, counter-clockwise seen from outside.
  std::span<const std::uint32_t> loop(std::size_t face) const {
    return std::span(loops).subspan(face_begin[face], face_begin[face + 1] - face_begin[face]);
  }
  /// The neighbours of a vertex.
  std::span<const std::uint32_t> around(std::size_t vertex) const {
    return std::span(neighbors).subspan(neighbor_begin[vertex], neighbor_begin[vertex + 1] - neighbor_begin[vertex]);
  }
  /// The faces around a vertex.
  std::span<const std::uint32_t> faces_at(std::size_t vertex) const {
    return std::span(incident).subspan(incident_begin[vertex], incident_begin[vertex + 1] - incident_begin[vertex]);
  }
};

/// The convex hull of points.
template <class T>
class GRAZE_API ConvexHull {
 public:
  static constexpr const char* name = "convex";

  /// The hull of at least one point, up to `largest_magnitude`. Expected time n log n. Throws `InvalidValue`.
  explicit ConvexHull(std::span<const Vec3<T>> points);
  ConvexHull(const ConvexHull& lender, Lent) : data_(std::shared_ptr<void>(), lender.data_.get()) {}

  /// The data that copies of the shape share.
  const HullData<T>& data() const { return *data_; }
  /// Distance by which points that count as in a face may lie off it.
  T tolerance() const { return data_->tolerance; }

  /// The index of the vertex furthest along `direction`: a scan for small hulls, else a descent of the
  /// Dobkin-Kirkpatrick hierarchy in logarithmic time (Dobkin, Kirkpatrick 1990, "Determining the separation of
  /// preprocessed polyhedra").
  template <class S>
  std::size_t support_vertex(const Vec3<S>& direction) const;

  T core_radius() const { return T(0); }
  T core_extent() const { return data_->extent; }
  template <class S>
  Vec3<S> core_support(const Vec3<S>& direction) const {
    return converted<S>(data_->vertices[support_vertex(direction)]);
  }
  /// The face, edge or vertex at the support vertex that leans least from `direction`.
  void core_face(const Vec3<T>& direction, Face<T>& face, T lean = face_lean<T>) const;
  Aabb<T> core_bounds(const Pose<T>& pose) const;

 private:
  std::shared_ptr<const HullData<T>> data_;
};

}  // namespace graze
