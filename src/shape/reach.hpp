// The reach of a shape about its origin, for shapes that turn.
//
// Guarantee: no point of the shape, rounding included, is ever outside.
#pragma once

#include "shape/compound_data.hpp"
#include "shape/rounding.hpp"

namespace graze {

/// The radius of the ball about the shape's origin that holds it; infinite for a shape without end.
template <class T>
T reach_of(const Shape<T>& shape) {
  if (shape.template as<HalfSpace<T>>()) return std::numeric_limits<T>::infinity();
  if (const auto* compound = shape.template as<Compound<T>>(); compound && !compound->data().unbounded.empty())
    return std::numeric_limits<T>::infinity();
  return shape.visit([&](const auto& c) { return c.core_extent() + rounding_radius(c, shape.rounding()); });
}

/// The bounds of a shape at its pose or, where it turns, at all poses that it may turn to.
template <class T>
Aabb<T> bounds_turning(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& angular) {
  if (angular == Vec3<T>{}) return bounds(shape, pose);
  // The sums of a reach lose a few units in the last place, far less than this.
  const T safe = T(1.0001);
  return inflated(Aabb<T>{pose.translation, pose.translation}, reach_of(shape) * safe);
}

}  // namespace graze
