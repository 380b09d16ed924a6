// Shapes with support points, of either space: what a language's `support` takes.
//
// Guarantee: the shape itself. Throws `InvalidValue` for a shape that is not convex or reaches to infinity, for which
// the C++ functions return the origin.
#pragma once

#include <type_traits>

#include "graze/detail/validate.hpp"
#include "graze/plane/shape.hpp"
#include "graze/shape.hpp"

namespace graze {

template <class T>
const Shape<T>& bounded_convex(const Shape<T>& shape) {
  const bool bounded = shape.visit([](const auto& c) { return BoundedConvex<std::decay_t<decltype(c)>>; });
  if (!bounded) validate::fail("shape", "a bounded convex shape", shape.name());
  return shape;
}

template <class T>
const plane::Shape<T>& bounded_convex(const plane::Shape<T>& shape) {
  if (!shape.convex() || shape.template as<plane::HalfPlane<T>>())
    validate::fail("shape", "a bounded convex shape", shape.name());
  return shape;
}

}  // namespace graze
