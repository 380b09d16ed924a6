// Shapes of the plane that need not be convex: the solid polygon and the chain.
//
// Guarantee: shared and immutable, so that copies are cheap and queries from any thread are safe. Constructors throw
// `InvalidValue` naming the vertex at fault. Crossings of outlines and convexity of vertices are decided exactly.
#pragma once

#include <memory>
#include <span>

#include "graze/detail/validate.hpp"
#include "graze/plane/shape/pieces.hpp"

namespace graze::plane {

/// A solid polygon, convex or not, without holes. It is cut into convex pieces; the cuts give no contacts, and a depth
/// is that of a way out through the outline. For a shape deep inside several pieces `distance` is an upper bound of the
/// depth; `closest` of a point is exact.
template <class T>
class GRAZE_API Polygon {
 public:
  static constexpr const char* name = "polygon";

  /// A polygon of at least three points around it, either way. Throws where two in a row are equal, where the outline
  /// turns back on itself, and where it crosses or touches itself. Cost up to n^2 in the number of points.
  explicit Polygon(std::span<const Vec2<T>> points);

  /// The convex pieces of the polygon.
  const Pieces<T>& pieces() const { return *pieces_; }
  T core_extent() const { return extent_; }

 private:
  std::shared_ptr<const Pieces<T>> pieces_;
  T extent_{};
};

/// The sides of a chain that give contacts.
enum class ChainSides : std::uint8_t {
  one,   ///< the right of its segments: the outside of a chain that runs counter-clockwise
  both,  ///< the side on which the other body's centre lies, at the time of the query
};

/// Segments joined end to end, without an inside. A body that slides over it meets the chain and not its seams: a
/// segment gives contacts only along normals that belong to it or to the corners that it shares with its neighbours.
/// Sides concern `contacts` alone; for all other queries a chain is a line.
template <class T>
class GRAZE_API Chain {
 public:
  static constexpr const char* name = "chain";

  /// A chain of at least two points in order. A `closed` chain goes on from the last to the first. Throws where two
  /// points in a row are equal.
  explicit Chain(std::span<const Vec2<T>> points, bool closed = false, ChainSides sides = ChainSides::both);

  /// The segments of the chain.
  const Pieces<T>& pieces() const { return *pieces_; }
  /// Whether the last point is joined to the first.
  bool closed() const { return closed_; }
  /// The sides that give contacts.
  ChainSides sides() const { return sides_; }
  T core_extent() const { return extent_; }

 private:
  std::shared_ptr<const Pieces<T>> pieces_;
  bool closed_;
  ChainSides sides_;
  T extent_{};
};

extern template class Polygon<float>;
extern template class Polygon<double>;
extern template class Chain<float>;
extern template class Chain<double>;

}  // namespace graze::plane
