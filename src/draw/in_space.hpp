// Places of space and of the plane as a renderer takes them.
//
// Guarantee: exact; places of the plane have z = 0.
#pragma once

#include "graze/plane/vec2.hpp"
#include "graze/vec3.hpp"

namespace graze::draw_detail {

template <class T>
Vec3d in_space(const Vec3<T>& v) {
  return converted<double>(v);
}
template <class T>
Vec3d in_space(const plane::Vec2<T>& v) {
  return {double(v.x), double(v.y), 0};
}

}  // namespace graze::draw_detail
