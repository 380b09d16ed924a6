// Vectors of the plane.
//
// Guarantee: that of `vec3.hpp`: branch-free arithmetic in IEEE-exact operations (+ - * / sqrt), in the order written.
#pragma once

#include <limits>

#include "graze/vec3.hpp"

namespace graze::plane {

using graze::greatest;
using graze::least;
using graze::select;

/// A vector or point of the plane, in the caller's unit of length.
template <class T>
struct Vec2 {
  T x{}, y{};  ///< coordinates

  constexpr Vec2& operator+=(const Vec2& v) { return *this = *this + v; }
  constexpr Vec2& operator-=(const Vec2& v) { return *this = *this - v; }
  constexpr Vec2& operator*=(const T& s) { return *this = *this * s; }

  friend constexpr Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(const Vec2& a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(const Vec2& a, const T& s) { return {a.x * s, a.y * s}; }
  friend constexpr Vec2 operator*(const T& s, const Vec2& a) { return {a.x * s, a.y * s}; }
  friend constexpr Vec2 operator/(const Vec2& a, const T& s) { return {a.x / s, a.y / s}; }
  friend constexpr bool operator==(const Vec2& a, const Vec2& b) { return a.x == b.x && a.y == b.y; }
};

using Vec2f = Vec2<float>;
using Vec2d = Vec2<double>;

/// The dot product.
template <class T>
constexpr T dot(const Vec2<T>& a, const Vec2<T>& b) {
  return a.x * b.x + a.y * b.y;
}

/// The z component of the cross product: positive where `b` lies to the left of `a`.
template <class T>
constexpr T cross(const Vec2<T>& a, const Vec2<T>& b) {
  return a.x * b.y - a.y * b.x;
}

/// The vector turned by a quarter counter-clockwise.
template <class T>
constexpr Vec2<T> left(const Vec2<T>& v) {
  return {-v.y, v.x};
}
/// The vector turned by a quarter clockwise.
template <class T>
constexpr Vec2<T> right(const Vec2<T>& v) {
  return {v.y, -v.x};
}

/// The squared length, without a root.
template <class T>
constexpr T length_squared(const Vec2<T>& v) {
  return dot(v, v);
}

/// The length.
template <class T>
T length(const Vec2<T>& v) {
  using std::sqrt;
  return sqrt(dot(v, v));
}

/// The absolute value of each coordinate.
template <class T>
Vec2<T> abs(const Vec2<T>& v) {
  using std::abs;
  return {abs(v.x), abs(v.y)};
}

/// The smaller of each coordinate.
template <class T>
constexpr Vec2<T> least(const Vec2<T>& a, const Vec2<T>& b) {
  return {least(a.x, b.x), least(a.y, b.y)};
}
/// The larger of each coordinate.
template <class T>
constexpr Vec2<T> greatest(const Vec2<T>& a, const Vec2<T>& b) {
  return {greatest(a.x, b.x), greatest(a.y, b.y)};
}

/// `yes` where the condition holds, else `no`.
template <class M, class T>
constexpr Vec2<T> select(const M& condition, const Vec2<T>& yes, const Vec2<T>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y)};
}

/// The largest absolute coordinate: the size to which tolerances are relative.
template <class T>
T max_abs(const Vec2<T>& v) {
  const Vec2<T> a = abs(v);
  return greatest(a.x, a.y);
}

/// Conversion between scalars, component by component.
template <class S, class T>
constexpr Vec2<S> converted(const Vec2<T>& v) {
  return {static_cast<S>(v.x), static_cast<S>(v.y)};
}

/// `v` scaled to unit length; the given unit vector `fallback` where `v` is zero. Divides by the largest component
/// first where a square under- or overflows.
template <class T>
Vec2<T> normalized(const Vec2<T>& v, const Vec2<T>& fallback = {T(0), T(1)}) {
  using std::sqrt;
  // From here on, underflow takes from a square only digits below its rounding.
  constexpr T least_square = (std::numeric_limits<T>::min)() / std::numeric_limits<T>::epsilon();
  if (const T square = length_squared(v); square >= least_square && square <= (std::numeric_limits<T>::max)())
    return v / sqrt(square);
  const T scale = max_abs(v);
  if (!(scale > T(0))) return fallback;
  const Vec2<T> w = v / scale;
  return w / length(w);
}

}  // namespace graze::plane
