// Rotations brought to unit length, as every query does with those of its poses.
//
// Guarantee: the results of `normalized`, within rounding of doubles.
#pragma once

#include <cmath>

#include "graze/plane/pose2.hpp"

namespace graze::plane {

/// The largest difference from 1 of the square of a rotation's length for which the series has all digits of a double:
/// the next term is 5/16 of its cube, less than a sixth of the rounding of 1. Rotations rounded to floats qualify.
inline constexpr double nearly_unit = 0x1p-18;

/// The rotation at unit length: where it nearly has that, by the series of the inverse square root, which takes neither
/// root nor division. Inlined, as are the queries' other first steps: a vector that a call writes is read back in
/// another size than it was written in, for which processors wait.
[[gnu::always_inline]] inline Rot2d at_unit(const Rot2d& q) {
  const double excess = q.cosine * q.cosine + q.sine * q.sine - 1;
  if (!(std::abs(excess) <= nearly_unit)) return normalized(q);
  const double scale = 1 - excess * (0.5 - 0.375 * excess);
  return {q.cosine * scale, q.sine * scale};
}
template <class T>
[[gnu::always_inline]] inline Pose2d at_unit(const Pose2<T>& pose) {
  return {converted<double>(pose.translation), at_unit(converted<double>(pose.rotation))};
}

/// Squares of lengths by which `unit_vector` divides as they are: those of all floats but zero.
inline constexpr double least_plain_square = 0x1p-900, most_plain_square = 0x1p900;

/// `normalized`, inlined for lengths whose squares doubles hold, as those of all floats.
[[gnu::always_inline]] inline Vec2d unit_vector(const Vec2d& v, const Vec2d& fallback) {
  const double square = length_squared(v);
  if (!(square >= least_plain_square && square <= most_plain_square)) return normalized(v, fallback);
  return v / std::sqrt(square);
}

}  // namespace graze::plane
