// The convex pieces of a solid polygon or of a chain, with what surrounds each on the outline.
//
// Guarantee: pieces keep their order; a search by place costs log n, where neighbours in order are neighbours in place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graze/plane/pose2.hpp"

namespace graze::plane {

/// The outline about vertex i of a piece, and whether the piece's edge from it belongs to the outline. The outline's
/// outside lies to the right of its edges.
struct OutlineVertex {
  /// What stands at a vertex of the outline.
  enum class Kind : std::uint8_t {
    convex,  ///< its normals are those between the normals of the two edges
    reflex,  ///< nothing outside is nearest to it alone
    first,   ///< where an open chain begins
    last,    ///< and where it ends
  };
  Vec2d arriving{}, leaving{};  ///< unit vectors along the edges that end and begin here
  Kind kind = Kind::convex;     ///< what stands there
  bool outer = true;            ///< whether edge i of the piece is an edge of the outline
  std::uint32_t number = 0;     ///< of the vertex on the outline
};

/// The convex pieces of an outline.
template <class T>
class GRAZE_API Pieces {
 public:
  /// Appends a piece: its vertices counter-clockwise, and the outline about each. `outline` is empty or as long, or
  /// for a chain's segment twice as long: seen from the right, and then from the left.
  void add(std::span<const Vec2<T>> vertices, std::span<const OutlineVertex> outline);
  /// To be called once, after the last piece.
  void build();

  std::uint32_t size() const { return static_cast<std::uint32_t>(first_.size()); }
  /// Of one piece, counter-clockwise.
  std::span<const Vec2<T>> vertices(std::uint32_t piece) const {
    return std::span(vertices_).subspan(first_[piece], end(piece) - first_[piece]);
  }
  /// What the vertices of one piece are in the outline.
  const OutlineVertex* outline(std::uint32_t piece) const { return outline_.data() + first_outline_[piece]; }

  /// The corners of the whole outline in their order. Those on straight lines were left out when it was cut.
  std::vector<Vec2<T>> outline_vertices() const;

  /// Calls `f` with every piece in order, but for those in boxes that `wanted` refuses.
  template <class Wanted, class F>
  void for_each(const Wanted& wanted, F&& f) const {
    visit(0, 0, size(), wanted, f);
  }

 private:
  std::uint32_t end(std::uint32_t piece) const {
    return piece + 1 < size() ? first_[piece + 1] : static_cast<std::uint32_t>(vertices_.size());
  }
  Aabb2<double> build(std::uint32_t node, std::uint32_t from, std::uint32_t to);
  /// Node i has the children 2 i + 1 and 2 i + 2, each with half of its pieces.
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
