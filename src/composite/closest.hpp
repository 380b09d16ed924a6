// The nearest point of any shape's surface, with its side.
#pragma once

#include "graze/result.hpp"
#include "graze/shape.hpp"

namespace graze {

/// `closest` for every shape. A closed mesh is asked as the solid that it bounds.
template <class T>
Closest<T> any_closest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& point);

}  // namespace graze
