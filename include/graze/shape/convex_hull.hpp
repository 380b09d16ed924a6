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
#include "graze/lines.hpp"
#include "graze/pose.hpp"
#include "graze/shape/face.hpp"
#include "graze/shape/lent.hpp"
#include "graze/validate.hpp"

namespace graze {

/// An edge of a polyhedron, by numbers.
struct HullEdge {
  std::uint32_t vertex[2];  ///< the two ends
  std::uint32_t face[2];    ///< left of vertex[0] -> vertex[1] seen from outside, then right; `no_face` of a segment
};

/// Sixteen vertices of a hull by their coordinates, as a scan reads them: the vertex of that number, or the first again
/// where there are fewer. A line of the cache a coordinate.
struct alignas(64) VertexBlock {
  static constexpr std::size_t size = 16;  ///< lanes of a block
  float x[size], y[size], z[size];         ///< lane by lane
};

/// Sixteen faces likewise: their outward unit normals, where their planes stand along them, and a vertex of each.
struct alignas(64) FaceBlock {
  static constexpr std::size_t size = VertexBlock::size;  ///< lanes of a block
  float x[size], y[size], z[size], offset[size];          ///< lane by lane
  std::uint8_t vertex[size];                              ///< A vertex of each face.
};
/// Sixteen edges: the numbers of the faces to their left and right, and the cosine between the normals of these.
struct alignas(32) EdgeBlock {
  static constexpr std::size_t size = VertexBlock::size;  ///< lanes of a block
  std::uint8_t left[size], right[size];                   ///< the faces on both sides of each edge
  float cosine[size];                                     ///< of the angle between the two faces
};

/// What the separating-axis test of a small polyhedron reads by lanes, in its own frame, and the planes themselves.
struct FacetRows {
  std::vector<FaceBlock> faces;       ///< all faces
  std::vector<EdgeBlock> edges;       ///< all edges
  std::vector<Plane<double>> planes;  ///< of the faces: no vertex lies beyond one
  Vec3<float> middle{};               ///< of a ball that lies inside
  float inner_radius = 0;             ///< its radius
};

/// What a hull is made of. Faces are convex polygons: coplanar triangles are merged.
template <class T>
struct HullData {
  static constexpr std::uint32_t no_face = 0xffffffffu;  ///< in place of a face where there is none

  int dimension = 0;   ///< 0 a point, 1 a segment, 2 a flat polygon, 3 a polyhedron
  T tolerance = T(0);  ///< how far an input point may lie outside
  T extent = T(0);     ///< the greatest distance of a vertex from the frame's origin
  // What support queries look at comes first, in one line of the cache.
  std::vector<VertexBlock> blocks;            ///< of a hull that is scanned: all its vertices
  std::vector<Vec3<T>> vertices;              ///< the corners
  std::vector<Plane<T>> planes;               ///< one a face, outward; a flat polygon has two, back to back
  std::vector<std::uint32_t> face_begin;      ///< face f's loop is loops[face_begin[f] .. face_begin[f + 1])
  std::vector<std::uint32_t> loops;           ///< vertex indices, counter-clockwise seen from outside
  std::vector<HullEdge> edges;                ///< each once
  std::vector<std::uint32_t> neighbor_begin;  ///< vertex v's neighbours are neighbors[neighbor_begin[v] .. [v + 1])
  std::vector<std::uint32_t> neighbors;       ///< of each vertex, one behind the other
  std::vector<std::uint32_t> incident_begin;  ///< and its faces incident[incident_begin[v] .. [v + 1])
  std::vector<std::uint32_t> incident;        ///< the faces of each vertex, one behind the other
  /// Dobkin and Kirkpatrick's hierarchy, coarsest level first; empty for hulls that a scan answers faster.
  struct Level {
    std::vector<std::uint32_t> vertices;        ///< indices into the hull's vertices
    std::vector<std::uint32_t> finer;           ///< for each, its place in the next finer level (of the last: the hull)
    std::vector<std::uint32_t> neighbor_begin;  ///< as that of the hull, for this level
    std::vector<std::uint32_t> neighbors;       ///< places in this level
  };
  std::vector<Level> hierarchy;  ///< from the coarsest hull to the finest (Dobkin and Kirkpatrick)
  FacetRows facets;              ///< of a polyhedron in float with few edges

  /// The vertices of a face, counter-clockwise seen from outside.
  std::span<const std::uint32_t> loop(std::size_t face) const {
    return std::span(loops).subspan(face_begin[face], face_begin[face + 1] - face_begin[face]);
  }
  /// The neighbours of a vertex.
  std::span<const std::uint32_t> around(std::size_t vertex) const {
    return std::span(neighbors).subspan(neighbor_begin[vertex], neighbor_begin[vertex + 1] - neighbor_begin[vertex]);
  }
  /// The faces of a vertex.
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

  /// What copies of the shape share.
  const HullData<T>& data() const { return *data_; }
  /// By how much a face may miss points that count as in it.
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
