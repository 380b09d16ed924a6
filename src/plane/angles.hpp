// Rotations of angles and angles of directions.
//
// Guarantee: only + - * / and sqrt, so that every machine gives the same bits, which the sines of its library do not
// promise. Right to a few units in the last place of the angle.
#pragma once

#include <cmath>
#include <limits>

#include "graze/plane/pose2.hpp"

namespace graze::plane {

namespace detail {

/// The quarter turn nearest to an angle is taken off in three parts, of which the first two have so few digits that
/// their products with small whole numbers are exact (Cody and Waite 1980, "Software manual for the elementary
/// functions").
inline constexpr double quarter_high = 0x1.921fb544p+0, quarter_middle = 0x1.0b4611a6p-34,
                        quarter_low = 0x1.3198a2e037073p-69;
/// The largest angle for which those whole numbers are small.
inline constexpr double most_reduced = 1024;

/// The rotation by at most an eighth turn, from the series of sine and cosine: the first terms left out are below
/// 1e-18.
inline Rot2d rotation_of_small(double x) {
  const double square = x * x;
  double cosine = 1, sine = 1;
  for (int n = 16; n > 0; n -= 2) {
    cosine = 1 - square * (1.0 / (n * (n - 1))) * cosine;
    sine = 1 - square * (1.0 / (n * (n + 1))) * sine;
  }
  return {cosine, x * sine};
}

}  // namespace detail

/// The rotation by `angle` radians; an angle that is not finite turns nothing.
inline Rot2d rotation_of(double angle) {
  if (!(std::abs(angle) <= (std::numeric_limits<double>::max)())) return {};
  int halvings = 0;
  for (; std::abs(angle) > detail::most_reduced; ++halvings) angle /= 2;
  const double quarters = std::floor(angle * 0.63661977236758134 + 0.5);
  const double rest =
      ((angle - quarters * detail::quarter_high) - quarters * detail::quarter_middle) - quarters * detail::quarter_low;
  const Rot2d small = detail::rotation_of_small(rest);
  const int turned = static_cast<int>(quarters) & 3;
  Rot2d out = turned == 0   ? small
              : turned == 1 ? Rot2d{-small.sine, small.cosine}
              : turned == 2 ? Rot2d{-small.cosine, -small.sine}
                            : Rot2d{small.sine, -small.cosine};
  for (; halvings > 0; --halvings) out = normalized(out * out);
  return out;
}

/// The angle of a unit vector from the X axis, in [-pi, pi]: eight times that of an eighth, from the series of the arc
/// tangent, whose first terms left out are below 1e-17.
inline double angle_of(const Vec2d& direction) {
  // Measured from the nearer of X and -X, where the other coordinate holds the digits of the angle.
  constexpr double half_turn = 3.14159265358979323846;
  Vec2d d{std::abs(direction.x), direction.y};
  for (int i = 0; i < 3; ++i) d = normalized(Vec2d{d.x + 1, d.y});
  const double t = d.y / d.x, square = t * t;
  double sum = 0;
  for (int n = 25; n > 1; n -= 2) sum = square * (1.0 / n - sum);
  const double from_nearer = 8 * t * (1 - sum);
  return direction.x >= 0 ? from_nearer : (direction.y < 0 ? -half_turn : half_turn) - from_nearer;
}

}  // namespace graze::plane
