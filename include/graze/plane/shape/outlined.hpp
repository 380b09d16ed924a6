// Shapes of the plane that need not be convex: the solid polygon and the chain.
//
// Guarantee: shared and immutable, so that copies are cheap and queries from any thread are safe. Constructors throw
// `InvalidValue` naming the vertex at fault. Whether outlines cross and which vertices are convex is decided exactly.
#pragma once

#include <memory>
#include <span>

#include "graze/plane/shape/pieces.hpp"
#include "graze/validate.hpp"

namespace graze::plane {

/// A solid polygon, convex or not, without holes. It is cut into convex pieces; the cuts give no contacts, and a depth
/// is that of a way out through the outline. `distance` of what lies deep inside several pieces is an upper bound of
/// the depth; `closest` of a point is exact.
template <class T>
class GRAZE_API Polygon {
 public:
  static constexpr const char* name = "polygon";

  /// At least three points around the polygon, either way. Throws where two are the same in a row, where the outline
  /// turns back on itself, and where it crosses or touches itself. Cost up to n^2 in the number of points.
  explicit Polygon(std::span<const Vec2<T>> points);

  /// The convex pieces it consists of.
  const Pieces<T>& pieces() const { return *pieces_; }
  T core_extent() const { return extent_; }

 private:
  std::shared_ptr<const Pieces<T>> pieces_;
  T extent_{};
};

/// Which sides of a chain give contacts.
enum class ChainSides : std::uint8_t {
  one,   ///< the right of its segments: the outside of a chain that runs counter-clockwise
  both,  ///< the side on which the other body's centre lies, at the time of the query
};

/// Segments joined end to end, without an inside. What slides over it meets the chain and not its seams: a segment
/// gives contacts only along normals that belong to it or to the corners that it shares with its neighbours. Sides
/// concern `contacts` alone; for all other queries a chain is the line that it is.
template <class T>
class GRAZE_API Chain {
 public:
  static constexpr const char* name = "chain";

  /// At least two points in order. A `closed` chain goes on from the last to the first. Throws where two points in a
  /// row are the same.
  explicit Chain(std::span<const Vec2<T>> points, bool closed = false, ChainSides sides = ChainSides::both);

  /// The convex pieces it consists of.
  const Pieces<T>& pieces() const { return *pieces_; }
  /// Whether its end is tied to its beginning.
  bool closed() const { return closed_; }
  /// Which sides count.
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
