// The furthest point of a shape of the plane along a direction.
//
// Guarantee: a point of the shape, rounding included, right up to the rounding of `T`; the same one whenever it is
// asked for again. Safe from any thread.
#pragma once

#include "graze/plane/shape.hpp"

namespace graze::plane {

/// The point of a bounded convex shape that lies furthest along `direction`, which is in the shape's frame, not zero
/// and need not be unit; the origin for all other shapes.
template <class T>
GRAZE_API Vec2<T> support(const Shape<T>& shape, const Vec2<T>& direction);

}  // namespace graze::plane
