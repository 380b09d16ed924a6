// The convex pieces of a solid polygon or of a chain, each with its surroundings on the outline.
//
// Guarantee: pieces keep their order; a spatial search costs log n where neighbours in order are neighbours in place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graze/plane/pose2.hpp"

namespace graze::plane {

/// The outline around vertex i of a piece, and whether the piece's edge from it belongs to the outline. The outside
/// lies to the right of the outline's edges.
struct OutlineVertex {
  /// Kind of a vertex of the outline.
  enum class Kind : std::uint8_t {
    convex,  ///< its normals are those between the normals of the two edges
    reflex,  ///< no outside point has it alone as its nearest one
    first,   ///< beginning of an open chain
    last,    ///< end of an open chain
  };
  Vec2d arriving{}, leaving{};  ///< unit vectors along the edges that end and begin here
  Kind kind = Kind::convex;     ///< kind of the vertex
  bool outer = true;            ///< whether edge i of the piece is an edge of the outline
  std::uint32_t number = 0;     ///< number of the vertex on the outline
};

/// The convex pieces of an outline.
template <class T>
class GRAZE_API Pieces {
 public:
  /// Appends a piece: its vertices counter-clockwise, and the outline around each. `outline` is empty or as long as
  /// `vertices`, or for a chain's segment twice as long: seen from the right, and then from the left.
  void add(std::span<const Vec2<T>> vertices, std::span<const OutlineVertex> outline);
  /// Builds the search tree. To be called once, after the last piece.
  void build();

  std::uint32_t size() const { return static_cast<std::uint32_t>(first_.size()); }
  /// The vertices of one piece, counter-clockwise.
  std::span<const Vec2<T>> vertices(std::uint32_t piece) const {
    return std::span(vertices_).subspan(first_[piece], end(piece) - first_[piece]);
  }
  /// The outline around the vertices of one piece.
  const OutlineVertex* outline(std::uint32_t piece) const { return outline_.data() + first_outline_[piece]; }

  /// The corners of the whole outline in their order, without those on straight lines, which the cutting leaves out.
  std::vector<Vec2<T>> outline_vertices() const;

  /// Calls `f` with every piece in order, except for those in boxes that `wanted` refuses.
  template <class Wanted, class F>
  void for_each(const Wanted& wanted, F&& f) const {
    visit(0, 0, size(), wanted, f);
  }

 private:
  std::uint32_t end(std::uint32_t piece) const {
    return piece + 1 < size() ? first_[piece + 1] : static_cast<std::uint32_t>(vertices_.size());
  }
  Aabb2<double> build(std::uint32_t node, std::uint32_t from, std::uint32_t to);
  /// Visits the tree below a node. Node i has the children 2 i + 1 and 2 i + 2, each with half of its pieces.
  template <class Wanted, class F>
  void visit(std::uint32_t node, std::uint32_t from, std::uint32_t to, const Wanted& wanted, F&& f) const {
    if (from == to || !wanted(boxes_[node])) return;
    if (to - from == 1) return f(from);
    const std::uint32_t middle = from + (to - from) / 2;
    visit(2 * node + 1, from, middle, wanted, f);
    visit(2 * node + 2, middle, to, wanted, f);
  }

  std::vector<Vec2<T>> vertices_;
  std::vector<OutlineVertex> outline_;
  std::vector<std::uint32_t> first_, first_outline_;
  std::vector<Aabb2<double>> boxes_;
};

extern template class Pieces<float>;
extern template class Pieces<double>;

}  // namespace graze::plane
