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
#include "graze/shape/listed.hpp"
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
class Shape : public ListedShape<ShapeList<T>, T> {
 public:
  /// `concrete`, rounded by `rounding`: the Minkowski sum with a ball of that radius. Throws `InvalidValue` for a
  /// rounding that is negative, larger than `largest_magnitude`, or given to a composite.
  template <class C>
  requires std::is_constructible_v<ShapeList<T>, C> Shape(C concrete, T rounding = T(0))
      : ListedShape<ShapeList<T>, T>(std::move(concrete), validate::size(rounding, "rounding")) {
    if constexpr (!BoundedConvex<C> && !std::is_same_v<C, HalfSpace<T>>)
      if (rounding != T(0))
        validate::fail("rounding", "0 (only convex shapes are rounded)", static_cast<double>(rounding));
  }

  /// Whether the shape is one convex piece.
  bool convex() const {
    return this->visit([](const auto& c) {
      using C = std::decay_t<decltype(c)>;
      return BoundedConvex<C> || std::is_same_v<C, HalfSpace<T>>;
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
