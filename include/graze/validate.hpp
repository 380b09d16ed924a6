// What the constructors of shapes demand of their numbers.
//
// Guarantee: a value that passes is finite and of the stated sign; one that does not raises `InvalidValue` naming it.
#pragma once

#include <cmath>
#include <string>

#include "graze/error.hpp"
#include "graze/quat.hpp"
#include "graze/vec3.hpp"

namespace graze::validate {

/// How numbers are printed in errors: shortest form that reads back to the same value.
std::string number(double value);

[[noreturn]] void fail(const std::string& path, const std::string& expectation, double found);

/// A finite length >= 0, returned as it came.
template <class T>
T extent(T value, const char* path) {
  if (!(std::isfinite(value) && value >= T(0))) fail(path, "a finite number >= 0", static_cast<double>(value));
  return value;
}

/// A vector of finite lengths >= 0.
template <class T>
Vec3<T> extents(const Vec3<T>& v, const std::string& path) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(std::isfinite(v[i]) && v[i] >= T(0)))
      fail(path + "[" + std::to_string(i) + "]", "a finite number >= 0", static_cast<double>(v[i]));
  return v;
}

/// A point with finite coordinates.
template <class T>
Vec3<T> point(const Vec3<T>& v, const std::string& path) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!std::isfinite(v[i])) fail(path + "[" + std::to_string(i) + "]", "a finite number", static_cast<double>(v[i]));
  return v;
}

/// The same without a string made for a path that is rarely needed.
template <class T>
Vec3<T> point(const Vec3<T>& v, const char* path) {
  if (std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) return v;
  return point(v, std::string(path));
}

/// A finite quaternion that is not zero, returned at unit length.
template <class T>
Quat<T> rotation(const Quat<T>& q, const std::string& path) {
  const T parts[4] = {q.x, q.y, q.z, q.w};
  for (std::size_t i = 0; i < 4; ++i)
    if (!std::isfinite(parts[i]))
      fail(path + "[" + std::to_string(i) + "]", "a finite number", static_cast<double>(parts[i]));
  if (q.x == T(0) && q.y == T(0) && q.z == T(0) && q.w == T(0))
    throw InvalidValue(path, "a quaternion that is not zero", "[0, 0, 0, 0]");
  return normalized(q);
}

}  // namespace graze::validate
