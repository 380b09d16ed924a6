// Shapes: one value type for all kinds, with a rounding radius.
//
// Guarantee: a value, immutable once built, cheap to copy (big shapes share their data), safe to read from any thread.
// `ShapeList` is the one list of shapes: a shape listed there takes part in every query, and one without a support
// function or an entry in the table of pairs does not compile.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "graze/shape/box.hpp"
#include "graze/shape/capsule.hpp"
#include "graze/shape/compound.hpp"
#include "graze/shape/convex_hull.hpp"
#include "graze/shape/cylinder.hpp"
#include "graze/shape/ellipsoid.hpp"
#include "graze/shape/half_space.hpp"
#include "graze/shape/height_field.hpp"
#include "graze/shape/mesh.hpp"
#include "graze/shape/rectangle.hpp"
#include "graze/shape/sphere.hpp"
#include "graze/shape/triangle.hpp"
#include "graze/shape/user_convex.hpp"

namespace graze {

/// All kinds of shapes. The order decides which shape of a pair is A: the one that stands first here.
template <class T>
using ShapeList =
    std::variant<Sphere<T>, Capsule<T>, Box<T>, Rectangle<T>, Cylinder<T>, Ellipsoid<T>, LineSegment<T>, Triangle<T>,
                 ConvexHull<T>, UserConvex<T>, HalfSpace<T>, Mesh<T>, HeightField<T>, Compound<T>>;

/// Bounded convex shapes: those with a support function.
template <class C>
concept BoundedConvex = requires(const C& c) {
  c.core_support(Vec3<double>{});
};

/// A shape of any kind, with its rounding: a value.
template <class T>
class Shape {
 public:
  static constexpr std::size_t count = std::variant_size_v<ShapeList<T>>;  ///< number of kinds

  /// `concrete`, rounded by `rounding`: the Minkowski sum with a ball of that radius. Throws `InvalidValue` for a
  /// rounding that is negative, larger than `largest_magnitude`, or given to a composite.
  template <class C>
  requires std::is_constructible_v<ShapeList<T>, C> Shape(C concrete, T rounding = T(0))
      : list_(std::move(concrete)), rounding_(validate::size(rounding, "rounding")) {
    if constexpr (!BoundedConvex<C> && !std::is_same_v<C, HalfSpace<T>>)
      if (rounding != T(0))
        validate::fail("rounding", "0 (only convex shapes are rounded)", static_cast<double>(rounding));
  }

  /// The rounding radius: that of the ball in the Minkowski sum.
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
      return BoundedConvex<C> || std::is_same_v<C, HalfSpace<T>>;
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

namespace detail {

/// The index of a kind in `ShapeList`.
template <class C, class T>
constexpr std::size_t kind_of() {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    std::size_t place = 0;
    static_cast<void>(((place = I, std::is_same_v<std::variant_alternative_t<I, ShapeList<T>>, C>) || ...));
    return place;
  }
  (std::make_index_sequence<Shape<T>::count>());
}

}  // namespace detail

using Shapef = Shape<float>;
using Shaped = Shape<double>;

/// A shape in place.
template <class T>
struct Placed {
  Shape<T> shape;  ///< the shape
  Pose<T> pose{};  ///< pose of the shape's frame
};

/// A shape in place, by reference.
template <class T>
struct PlacedRef {
  const Shape<T>* shape;  ///< the shape, which must outlive the reference
  const Pose<T>* pose;    ///< its pose, which must outlive the reference
};

/// The bounds of a shape under a pose, rounding included; not less than the true ones.
template <class T>
GRAZE_API Aabb<T> bounds(const Shape<T>& shape, const Pose<T>& pose);

/// The point of a bounded convex shape, rounding included, that lies furthest along `direction` (in the shape's frame).
template <class T>
GRAZE_API Vec3<T> support(const Shape<T>& shape, const Vec3<T>& direction);

/// Volume, centre of mass and inertia of a body of density one.
template <class T>
struct MassProperties {
  T volume{};         ///< volume of the solid
  Vec3<T> center{};   ///< centre of mass, in the shape's frame
  Mat3<T> inertia{};  ///< inertia tensor about `center`, in the shape's frame
};

/// The mass properties of a solid, rounding included. Surfaces (height fields and open meshes too) and half-spaces have
/// none: volume 0 and all else zero. A closed mesh has those of the solid it bounds, a compound the sum of its
/// children's.
template <class T>
GRAZE_API MassProperties<T> mass_properties(const Shape<T>& shape);

extern template class ConvexHull<float>;
extern template class ConvexHull<double>;
extern template class Mesh<float>;
extern template class Mesh<double>;
extern template class HeightField<float>;
extern template class HeightField<double>;
extern template class Compound<float>;
extern template class Compound<double>;

}  // namespace graze
