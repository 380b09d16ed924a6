// Vectors of three-dimensional space.
//
// Guarantee: every function here is branch-free arithmetic in IEEE-exact operations (+ - * / sqrt), in the order
// written, so that a scalar and each lane of a `Wide` give the same bits. `T` is `float`, `double` or a lane type.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>

#include "graze/detail/standard.hpp"

namespace graze {

/// A vector or point, in the caller's unit of length.
template <class T>
struct Vec3 {
  T x{}, y{}, z{};  ///< coordinates

  /// Coordinate 0, 1 or 2.
  constexpr T& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
  /// Coordinate 0, 1 or 2.
  constexpr const T& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }

  constexpr Vec3& operator+=(const Vec3& v) { return *this = *this + v; }
  constexpr Vec3& operator-=(const Vec3& v) { return *this = *this - v; }
  constexpr Vec3& operator*=(const T& s) { return *this = *this * s; }

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(const Vec3& a, const T& s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator*(const T& s, const Vec3& a) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator/(const Vec3& a, const T& s) { return {a.x / s, a.y / s, a.z / s}; }
  friend constexpr bool operator==(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

/// The dot product.
template <class T>
constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The cross product: perpendicular to both, right-handed.
template <class T>
constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The product component by component.
template <class T>
constexpr Vec3<T> scaled(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// The squared length, without a root.
template <class T>
constexpr T length_squared(const Vec3<T>& v) {
  return dot(v, v);
}

/// The length.
template <class T>
T length(const Vec3<T>& v) {
  using std::sqrt;
  return sqrt(dot(v, v));
}

/// The absolute value of each coordinate.
template <class T>
Vec3<T> abs(const Vec3<T>& v) {
  using std::abs;
  return {abs(v.x), abs(v.y), abs(v.z)};
}

/// The smaller of two scalars; without a branch for lane types, which overload it.
template <class T>
constexpr T least(const T& a, const T& b) {
  return b < a ? b : a;
}
/// The larger of two scalars.
template <class T>
constexpr T greatest(const T& a, const T& b) {
  return a < b ? b : a;
}
/// `condition ? yes : no`; overloaded for lanes.
template <class T>
requires std::is_arithmetic_v<T>
constexpr T select(bool condition, const T& yes, const T& no) { return condition ? yes : no; }
/// `yes` where the condition holds, else `no`.
template <class M, class T>
constexpr Vec3<T> select(const M& condition, const Vec3<T>& yes, const Vec3<T>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y), select(condition, yes.z, no.z)};
}

/// The smaller of each coordinate.
template <class T>
constexpr Vec3<T> least(const Vec3<T>& a, const Vec3<T>& b) {
  return {least(a.x, b.x), least(a.y, b.y), least(a.z, b.z)};
}
/// The larger of each coordinate.
template <class T>
constexpr Vec3<T> greatest(const Vec3<T>& a, const Vec3<T>& b) {
  return {greatest(a.x, b.x), greatest(a.y, b.y), greatest(a.z, b.z)};
}
/// The number in [low, high] nearest to `value`.
template <class T>
constexpr T clamp(const T& value, const T& low, const T& high) {
  return greatest(low, least(value, high));
}

/// The largest absolute coordinate: the size to which tolerances are relative.
template <class T>
T max_abs(const Vec3<T>& v) {
  const Vec3<T> a = abs(v);
  return greatest(a.x, greatest(a.y, a.z));
}

/// Conversion between scalars, component by component.
template <class S, class T>
constexpr Vec3<S> converted(const Vec3<T>& v) {
  return {static_cast<S>(v.x), static_cast<S>(v.y), static_cast<S>(v.z)};
}

/// `v` scaled to unit length; the given unit vector `fallback` where `v` is zero. Divides by the largest component
/// first, so that no square under- or overflows: any finite nonzero `v` will do.
template <class T>
Vec3<T> normalized(const Vec3<T>& v, const Vec3<T>& fallback = {T(0), T(1), T(0)}) {
  const T scale = max_abs(v);
  const auto nonzero = scale > T(0);
  const Vec3<T> w = v / select(nonzero, scale, T(1));
  const T l = length(w);
  return select(nonzero, w / select(nonzero, l, T(1)), fallback);
}

/// A unit vector perpendicular to the unit vector `n`, without a branch on the sign of zero.
/// Crosses `n` with the axis it is least aligned with, so the result is never short of length sqrt(2/3) before scaling.
template <class T>
Vec3<T> any_perpendicular(const Vec3<T>& n) {
  const Vec3<T> a = abs(n);
  const auto x_least = a.x < least(a.y, a.z);
  const auto y_least = a.y < a.z;
  const Vec3<T> axis =
      select(x_least, Vec3<T>{T(1), T(0), T(0)}, select(y_least, Vec3<T>{T(0), T(1), T(0)}, Vec3<T>{T(0), T(0), T(1)}));
  return normalized(cross(n, axis));
}

}  // namespace graze
