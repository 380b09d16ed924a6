// Shapes of the plane: one value type for all kinds, with a rounding radius.
//
// Guarantee: a value, immutable once built, cheap to copy, safe to read from any thread. `ShapeList` is the one list of
// shapes: a shape listed there takes part in every query, and one without a core (`src/plane/core.hpp`) does not
// compile.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "graze/plane/pose2.hpp"
#include "graze/plane/shape/compound.hpp"
#include "graze/plane/shape/flat.hpp"
#include "graze/plane/shape/outlined.hpp"
#include "graze/plane/shape/round.hpp"
#include "graze/plane/shape/user_convex.hpp"
#include "graze/shape/listed.hpp"

namespace graze::plane {

/// All kinds of shapes of the plane.
template <class T>
using ShapeList = std::variant<Circle<T>, Capsule<T>, Box<T>, Segment<T>, ConvexPolygon<T>, Ellipse<T>, UserConvex<T>,
                               HalfPlane<T>, Polygon<T>, Chain<T>, Compound<T>>;

/// A shape of the plane of any kind, with its rounding: a value.
template <class T>
class Shape : public ListedShape<ShapeList<T>, T> {
 public:
  /// `concrete`, rounded by `rounding`: the Minkowski sum with a disc of that radius, which of a compound is each child
  /// grown by it. Throws `InvalidValue` for a rounding that is negative or larger than `largest_magnitude`.
  template <class C>
  requires std::is_constructible_v<ShapeList<T>, C> Shape(C concrete, T rounding = T(0))
      : ListedShape<ShapeList<T>, T>(std::move(concrete), validate::extent(rounding, "rounding")) {}

  /// Whether the shape is one convex piece.
  bool convex() const {
    return this->visit([](const auto& c) {
      using C = std::decay_t<decltype(c)>;
      return !std::is_same_v<C, Polygon<T>> && !std::is_same_v<C, Chain<T>> && !std::is_same_v<C, Compound<T>>;
    });
  }
};

namespace detail {

/// The index of a kind in `ShapeList`.
template <class C, class T>
constexpr std::size_t kind_of() {
  return Shape<T>::template index_of<C>();
}

}  // namespace detail

using Shapef = Shape<float>;
using Shaped = Shape<double>;

/// A shape in place.
template <class T>
struct GRAZE_API Placed {
  Shape<T> shape;   ///< the shape
  Pose2<T> pose{};  ///< pose of the shape's frame
};

/// The largest distance of a shape's points from its own origin, rounding included. Zero for a half-plane without
/// rounding.
template <class T>
T extent(const Shape<T>& shape) {
  return shape.visit([](const auto& c) { return c.core_extent(); }) + shape.rounding();
}

/// The bounds of a shape under a pose, rounding included; not less than the true ones.
template <class T>
GRAZE_API Aabb2<T> bounds(const Shape<T>& shape, const Pose2<T>& pose);

/// A shape in place, by reference.
template <class T>
struct PlacedRef {
  const Shape<T>* shape;  ///< the shape, which must outlive the reference
  const Pose2<T>* pose;   ///< its pose, which must outlive the reference
};

}  // namespace graze::plane
