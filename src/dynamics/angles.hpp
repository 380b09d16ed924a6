// Angles from sines and cosines, with + - * / and sqrt alone, so that every machine gives the same bits.
//
// Guarantee: within a few roundings of the true angle.
#pragma once

#include "graze/vec3.hpp"

namespace graze {

template <class T>
inline constexpr T pi = T(3.14159265358979323846264338327950288L);

/// The angle of the point (x, y), from -pi to pi; 0 for the origin.
///
/// Three halvings, tan(a/2) = tan(a) / (1 + sqrt(1 + tan²(a))), take an angle of up to pi/4 below 0.0985; the series
/// of the arc tangent then loses 0.0985^21/21 = 3e-23 after ten terms.
template <class T>
T angle_of(T x, T y) {
  using std::abs, std::sqrt;
  const T ax = abs(x), ay = abs(y), large = greatest(ax, ay);
  if (!(large > T(0))) return T(0);
  T t = least(ax, ay) / large;
  for (int i = 0; i < 3; ++i) t = t / (T(1) + sqrt(T(1) + t * t));
  const T u = t * t;
  T sum(0);
  for (int n = 19; n >= 1; n -= 2) sum = T(1) / T(n) - u * sum;
  T angle = T(8) * t * sum;
  if (ay > ax) angle = pi<T> / T(2) - angle;
  if (x < T(0)) angle = pi<T> - angle;
  return y < T(0) ? -angle : angle;
}

}  // namespace graze
