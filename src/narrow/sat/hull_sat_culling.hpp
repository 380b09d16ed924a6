// Culling of separating axes across lanes: the faces and edges of one small polyhedron that may have the best axis
// against another. Only for `*.kernel.cpp`.
//
// Guarantee: lanes of float only rule out axes that cannot be the best, with their rounding allowed for.
#pragma once

#include "narrow/sat/hull_axes.hpp"
#include "shape/vertex_scan.hpp"
#include "simd/number_table.hpp"

namespace graze::GRAZE_ISA {

/// Number of one polyhedron's edges that may have the best axis, up to which their pairs cost less than EPA.
inline constexpr std::size_t most_promising = 16;

/// Position of a face relative to the other polyhedron.
struct FaceSeen {
  double separation;
  Vec3d nearest;  ///< the nearest vertex of the other, in the face's frame
  Vec3d vertex;   ///< a vertex of the face, in the other's frame
};

class HullSatCulling {
 public:
  /// `turn` rotates directions from the other's frame into its own, where `apart` is the other's origin. `slack`:
  /// rounding of a separation in float.
  [[gnu::always_inline]] HullSatCulling(const FacetedHull& own, const FacetedHull& other, const Mat3d& turn,
                                        const Vec3d& apart, float slack)
      : own_(own), other_(other), turn_(turn), apart_(apart), slack_(slack) {}

  /// Bounds the separation of each face by the distance of the other's inner ball in front of it. Returns the face with
  /// the largest.
  [[gnu::always_inline]] std::uint32_t bound_faces() {
    const Vec3<L> middle = converted<L>(converted<float>(turn_ * converted<double>(other_.ball.middle) + apart_));
    const Vec3<L> apart = converted<L>(converted<float>(apart_));
    const Mat3<L> turn = converted<L>(converted<float>(turn_));
    const L radius(other_.ball.radius);
    L most(-std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < own_.face_count; i += lanes) {
      const Planes planes = planes_from(i);
      const L bound = dot(planes.normal, middle) - planes.offset - radius;
      bound.store(bound_ + i);
      most = larger(bound, most);
      const Vec3<L> down = transposed_times(turn, -planes.normal);
      down.x.store(down_[0] + i);
      down.y.store(down_[1] + i);
      down.z.store(down_[2] + i);
      (planes.offset - dot(planes.normal, apart)).store(below_ + i);
    }
    return first_bit(faces_from(largest(most)));
  }

  /// The separation of the other in front of a face, in float.
  [[gnu::always_inline]] float separation(std::uint32_t face) {
    known_ |= std::uint32_t{1} << face;
    return other_.corners.count > VertexBlock::size ? -deepest<2>(face) : -deepest<1>(face);
  }
  /// Measures the faces whose bound is not less than `level`. Returns the largest of their separations and `most`.
  [[gnu::always_inline]] float measure(float level, float most) {
    measured_ = faces_from(level);
    for (std::uint32_t left = measured_; left != 0; left &= left - 1) {
      const std::uint32_t face = first_bit(left);
      separations_[face] = separation(face);
      most = greatest(most, separations_[face]);
    }
    return most;
  }
  /// Calls `f` for the measured faces whose separation is not less than `level`.
  template <class F>
  [[gnu::always_inline]] void visit_measured(float level, F&& f) const {
    for (std::uint32_t left = measured_; left != 0; left &= left - 1)
      if (separations_[first_bit(left)] >= level) f(first_bit(left));
  }

  const Vec3d& normal(std::uint32_t face) const { return own_.planes[face].normal; }
  /// The position of a face, in double.
  [[gnu::always_inline]] FaceSeen see(std::uint32_t face) const {
    const Plane<double>& plane = own_.planes[face];
    const std::uint32_t nearest = scan(other_.corners, transposed_times(turn_, -plane.normal));
    const std::uint32_t vertex = own_.faces[face / FaceBlock::size].vertex[face % FaceBlock::size];
    const Vec3d at = turn_ * corner(other_, nearest) + apart_;
    return {signed_distance(plane, at), at, transposed_times(turn_, corner(own_, vertex) - apart_)};
  }

  /// Lists the edges on whose arcs an axis may show a separation of more than `level`. Returns their number, or one
  /// more than `most_promising`, for which there is room. `vertex` is one of the other's. Branches are taken once for
  /// all of them and never edge by edge, since the remaining edges are unpredictable.
  [[gnu::always_inline]] std::size_t promising_edges(float level, const Vec3d& vertex, std::uint32_t* edges) {
    constexpr std::size_t most_tested = 2 * most_promising;
    std::uint32_t tested[most_tested];
    std::size_t test_count = 0;
    std::uint32_t faces = 0;
    for (std::uint64_t bits = open_edges(level, vertex); bits != 0; bits &= bits - 1) {
      if (test_count == most_tested) return most_promising + 1;
      const auto edge = static_cast<std::uint32_t>(__builtin_ctzll(bits));
      faces |= std::uint32_t{1} << own_.edges[edge].face[0] | std::uint32_t{1} << own_.edges[edge].face[1];
      tested[test_count++] = edge;
    }
    for (faces &= ~known_; faces != 0; faces &= faces - 1) separation(first_bit(faces));
    std::size_t count = 0;
    for (std::size_t i = 0; i < test_count; ++i) {
      edges[count < most_promising ? count : most_promising] = tested[i];
      count += other_.corners.count > VertexBlock::size ? vertices_exceed<2>(tested[i], level)
                                                        : vertices_exceed<1>(tested[i], level);
    }
    return least(count, most_promising + 1);
  }

 private:
  using L = Lanes<float>;
  static constexpr std::size_t lanes = static_cast<std::size_t>(L::lanes);
  static constexpr std::size_t face_room = NumberTable::size;
  static_assert(most_faceted_faces <= face_room && most_faceted_edges <= 64, "a bit a face and a bit an edge");

  struct Planes {
    Vec3<L> normal;
    L offset;
  };

  static std::uint32_t first_bit(std::uint32_t bits) { return static_cast<std::uint32_t>(__builtin_ctz(bits)); }

  [[gnu::always_inline]] Planes planes_from(std::size_t i) const {
    const FaceBlock& block = own_.faces[i / FaceBlock::size];
    const std::size_t k = i % FaceBlock::size;
    return {{L::load(block.x + k), L::load(block.y + k), L::load(block.z + k)}, L::load(block.offset + k)};
  }
  /// The faces whose bound is not less than `level`, as bits.
  [[gnu::always_inline]] std::uint32_t faces_from(float level) const {
    std::uint32_t faces = 0;
    for (std::size_t i = 0; i < own_.face_count; i += lanes)
      faces |= Chosen<float>::not_less(L::load(bound_ + i), L(level)).bits() << i;
    return faces & (~std::uint32_t{0} >> (32 - own_.face_count));
  }
  /// The depth of the other's deepest vertex below a face; writes those of all vertices.
  template <std::size_t blocks>
  [[gnu::always_inline]] float deepest(std::uint32_t face) {
    const Vec3<L> down{L(down_[0][face]), L(down_[1][face]), L(down_[2][face])};
    const L below(below_[face]);
    L most(-std::numeric_limits<float>::infinity());
    for (std::size_t b = 0; b < blocks; ++b) {
      const VertexBlock& block = other_.corners.blocks[b];
      for (std::size_t k = 0; k < VertexBlock::size; k += lanes) {
        const Vec3<L> p{L::load(block.x + k), L::load(block.y + k), L::load(block.z + k)};
        const L depth = dot(p, down) + below;
        depth.store(depth_[face] + VertexBlock::size * b + k);
        most = larger(depth, most);
      }
    }
    return largest(most);
  }

  /// Whether n . q exceeds `level` for some unit vector n of the arc between two whose cosine is c, given x and y,
  /// their dot products with q: at one of its ends, or where q's projection falls inside it. True where rounding leaves
  /// that open: x and y may be off by the slack each, and the squares by their slopes times that.
  [[gnu::always_inline]] auto may_exceed(const L& x, const L& y, const L& c, const L& level) const {
    const L slack(slack_), squares = x * x + y * y - L(2) * c * x * y;
    const L error = L(5) * slack * (abs(x) + abs(y) + abs(level));
    const auto inside = (y > c * x - slack) & (x > c * y - slack);
    return (x > level) | (y > level) | (inside & (squares + error >= level * level * (L(1) - c * c)));
  }
  /// The edges left open by the other's inner ball and one of its vertices, as bits. An edge lies in the planes of its
  /// faces, so that the heights of a point above these are all that is needed.
  [[gnu::always_inline]] std::uint64_t open_edges(float level, const Vec3d& vertex) const {
    alignas(64) float of_vertex[face_room];
    const Vec3<L> point = converted<L>(converted<float>(vertex));
    for (std::size_t i = 0; i < own_.face_count; i += lanes) {
      const Planes planes = planes_from(i);
      (dot(planes.normal, point) - planes.offset).store(of_vertex + i);
    }
    const NumberTable balls(bound_), vertices(of_vertex);
    const L radius(other_.ball.radius), of_ball(level + other_.ball.radius - slack_), low(level - slack_);
    std::uint64_t edges = 0;
    for (std::size_t b = 0; b < edge_blocks(own_.edge_count); ++b) {
      const EdgeBlock& block = own_.edge_blocks[b];
      std::uint64_t open = 0;
      for (std::size_t k = 0; k < EdgeBlock::size; k += lanes) {
        const L cosine = L::load(block.cosine + k);
        const auto by_ball =
            may_exceed(balls.at(block.left + k) + radius, balls.at(block.right + k) + radius, cosine, of_ball);
        const auto by_vertex = may_exceed(vertices.at(block.left + k), vertices.at(block.right + k), cosine, low);
        open |= std::uint64_t{bits_of(by_ball & by_vertex)} << k;
      }
      edges |= open << EdgeBlock::size * b;
    }
    return edges & ((std::uint64_t{1} << own_.edge_count) - 1);  // without those that fill up the last block
  }
  /// Whether each vertex of the other leaves open an axis on the edge's arc with a separation of more than `level`.
  template <std::size_t blocks>
  [[gnu::always_inline]] bool vertices_exceed(std::uint32_t edge, float level) const {
    const auto [left, right] = own_.edges[edge].face;
    const L cosine(own_.edge_blocks[edge / EdgeBlock::size].cosine[edge % EdgeBlock::size]), low(level - slack_);
    auto exceed = may_exceed(-L::load(depth_[left]), -L::load(depth_[right]), cosine, low);
    for (std::size_t i = lanes; i < blocks * VertexBlock::size; i += lanes)
      exceed = exceed & may_exceed(-L::load(depth_[left] + i), -L::load(depth_[right] + i), cosine, low);
    return all(exceed);
  }

  const FacetedHull& own_;
  const FacetedHull& other_;
  Mat3d turn_;
  Vec3d apart_;
  float slack_;
  std::uint32_t measured_ = 0, known_ = 0;  ///< faces with separations, and with depths
  alignas(64) float bound_[face_room];
  float separations_[face_room];
  alignas(64) float down_[3][face_room], below_[face_room];    ///< against the normals, in the other's frame
  alignas(64) float depth_[face_room][2 * VertexBlock::size];  ///< depths of the other's vertices below each face
};

}  // namespace graze::GRAZE_ISA
