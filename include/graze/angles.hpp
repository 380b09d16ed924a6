// Cosines and sines of angles, and angles of points.
//
// Guarantee: only + - * / and sqrt, so that every machine gives the same bits, which the sines of a C library do not
// promise. Right to a few units in the last place of the angle.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "graze/vec3.hpp"

namespace graze {

/// The unit vector to which an angle turns the X axis.
struct CosineSine {
  double cosine = 1, sine = 0;  ///< of the angle

  friend constexpr bool operator==(const CosineSine&, const CosineSine&) = default;
};

namespace detail {

/// The quarter turn nearest to an angle is taken off in three parts, of which the first two have so few digits that
/// their products with small whole numbers are exact (Cody and Waite 1980, "Software manual for the elementary
/// functions").
inline constexpr double quarter_high = 0x1.921fb544p+0, quarter_middle = 0x1.0b4611a6p-34,
                        quarter_low = 0x1.3198a2e037073p-69;
/// The largest angle for which the whole numbers are small.
inline constexpr double most_reduced = 1024;

/// Cosine and sine of an angle of at most an eighth turn, by the series, whose first terms left out are below 1e-18.
inline CosineSine cosine_sine_of_small(double x) {
  const double square = x * x;
  double cosine = 1, sine = 1;
  for (int n = 16; n > 0; n -= 2) {
    cosine = 1 - square * (1.0 / (n * (n - 1))) * cosine;
    sine = 1 - square * (1.0 / (n * (n + 1))) * sine;
  }
  return {cosine, x * sine};
}

/// Cosine and sine of twice the angle, at unit length.
inline CosineSine doubled(const CosineSine& of) {
  const double x = of.cosine * of.cosine - of.sine * of.sine, y = of.sine * of.cosine + of.cosine * of.sine,
               length = std::sqrt(x * x + y * y);
  return {x / length, y / length};
}

}  // namespace detail

/// The cosine and sine of `angle` radians; of an angle that is not finite those of zero.
inline CosineSine cosine_sine(double angle) {
  if (!(std::abs(angle) <= (std::numeric_limits<double>::max)())) return {};
  int halvings = 0;
  for (; std::abs(angle) > detail::most_reduced; ++halvings) angle /= 2;
  const double quarters = std::floor(angle * 0.63661977236758134 + 0.5);
  const double rest =
      ((angle - quarters * detail::quarter_high) - quarters * detail::quarter_middle) - quarters * detail::quarter_low;
  const CosineSine reduced = detail::cosine_sine_of_small(rest);
  const int turned = static_cast<int>(quarters) & 3;
  CosineSine out = turned == 0   ? reduced
                   : turned == 1 ? CosineSine{-reduced.sine, reduced.cosine}
                   : turned == 2 ? CosineSine{-reduced.cosine, -reduced.sine}
                                 : CosineSine{reduced.sine, -reduced.cosine};
  for (; halvings > 0; --halvings) out = detail::doubled(out);
  return out;
}

/// The angle of the point (x, y), from -pi to pi; 0 for the origin.
///
/// Three halvings, tan(a/2) = tan(a) / (1 + sqrt(1 + tan²(a))), take an angle of up to pi/4 below 0.0985; the series
/// of the arc tangent then loses 0.0985^21/21 = 3e-23 after ten terms.
template <class T>
T angle_of(T x, T y) {
  using std::abs, std::sqrt;
  constexpr T half_turn = std::numbers::pi_v<T>;
  const T ax = abs(x), ay = abs(y), large = greatest(ax, ay);
  if (!(large > T(0))) return T(0);
  T t = least(ax, ay) / large;
  for (int i = 0; i < 3; ++i) t = t / (T(1) + sqrt(T(1) + t * t));
  const T u = t * t;
  T sum(0);
  for (int n = 19; n >= 1; n -= 2) sum = T(1) / T(n) - u * sum;
  T angle = T(8) * t * sum;
  if (ay > ax) angle = half_turn / T(2) - angle;
  if (x < T(0)) angle = half_turn - angle;
  return y < T(0) ? -angle : angle;
}

}  // namespace graze
