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

namespace graze::plane {

/// All kinds of shapes of the plane.
template <class T>
using ShapeList = std::variant<Circle<T>, Capsule<T>, Box<T>, Segment<T>, ConvexPolygon<T>, Ellipse<T>, UserConvex<T>,
                               HalfPlane<T>, Polygon<T>, Chain<T>, Compound<T>>;

/// A shape of the plane of any kind, with its rounding: a value.
template <class T>
class Shape {
 public:
  static constexpr std::size_t count = std::variant_size_v<ShapeList<T>>;  ///< number of kinds

  /// `concrete`, rounded by `rounding`: the Minkowski sum with a disc of that radius, which of a compound is each child
  /// grown by it. Throws `InvalidValue` for a rounding that is negative or larger than `largest_magnitude`.
  template <class C>
  requires std::is_constructible_v<ShapeList<T>, C> Shape(C concrete, T rounding = T(0))
      : list_(std::move(concrete)), rounding_(validate::extent(rounding, "rounding")) {}

  /// The rounding radius: that of the disc in the Minkowski sum.
  T rounding() const { return rounding_; }
  /// The kind of the shape: its index in `ShapeList`.
  std::size_t index() const { return list_.index(); }
  /// The name of the kind in files and messages.
  const char* name() const {
    return visit([](const auto& c) { return std::decay_t<decltype(c)>::name; });
  }

  /// Whether the shape is one convex piece.
  bool convex() const {
    return visit([](const auto& c) {
      using C = std::decay_t<decltype(c)>;
      return !std::is_same_v<C, Polygon<T>> && !std::is_same_v<C, Chain<T>> && !std::is_same_v<C, Compound<T>>;
    });
  }

  /// The shape as `C`, or null when it is of another kind.
  template <class C>
  const C* as() const {
    return std::get_if<C>(&list_);
  }
  /// Calls `f` with the shape as an object of the class of its kind.
  template <class F>
  decltype(auto) visit(F&& f) const {
    return visit_from<0>(std::forward<F>(f));
  }

 private:
  /// A chain of comparisons that compilers turn into one jump, where `std::visit` calls through a table.
  template <std::size_t I, class F>
  decltype(auto) visit_from(F&& f) const {
    if constexpr (I + 1 == count) {
      return f(*std::get_if<I>(&list_));
    } else {
      if (list_.index() == I) return f(*std::get_if<I>(&list_));
      return visit_from<I + 1>(std::forward<F>(f));
    }
  }

  ShapeList<T> list_;
  T rounding_;
};

using Shapef = Shape<float>;
using Shaped = Shape<double>;

/// A shape in place.
template <class T>
struct Placed {
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
