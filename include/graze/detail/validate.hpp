// Validation of the numbers that constructors of shapes take.
//
// Guarantee: a value that passes is finite, of the stated sign and no larger than `largest_magnitude`; another one
// raises `InvalidValue` naming it. Sizes and coordinates of shapes below `smallest_magnitude` become zero.
#pragma once

#include <cmath>
#include <string>

#include "graze/error.hpp"
#include "graze/quat.hpp"
#include "graze/vec3.hpp"

namespace graze {

/// The largest length or coordinate that is accepted: of shapes, poses, margins, points, rays and velocities. Queries
/// multiply lengths with each other, and a product that overflows gives a wrong answer or none.
///
/// With M for this number: a shape reaches at most 8 M from its own origin (of convex ones, a hull reaches furthest,
/// sqrt(3) M and its margin M; a compound is held to it), so the difference of two shapes reaches 20 M: 8 M each and
/// the 2 sqrt(3) M between their origins.
///
/// Computations in double have six factors at most: GJK compares the sides of a tetrahedron's face by a product of two
/// volumes, each up to 40 * 40 * 40 M^3. 4.1e9 M^6 stays below 1.8e308 up to M = 5.9e49.
template <class T>
inline constexpr T largest_magnitude = T(1e48);
/// Computations in float have two factors: the squared length of a difference is up to 400 M^2, and nearest points of
/// segments take the dot product of a vector of up to 16 * 20 M^2 with one of sqrt(3). 555 M^2 stays below 3.4e38 up to
/// M = 7.8e17.
template <>
inline constexpr float largest_magnitude<float> = 1e17f;

/// The smallest length or coordinate of a shape that is not zero. Constructors take a smaller one as zero: a ball is
/// then a point, a box a rectangle. Sizes of zero are handled like any others, whereas a product of small lengths that
/// underflows gives a wrong sign. A shape is therefore within sqrt(3) times this number of the given one, and answers
/// are right to `tolerance` times the size or to a few times this number, whichever is larger. For shapes less than
/// this number apart `overlap` may report a touch where `distance` has the gap. Poses, points and the results of a
/// user's support function are left as they are, except for a function that reaches nowhere further than this: that one
/// is the origin.
///
/// With m for this number: products of six factors in double (see `largest_magnitude`) are down to m^6 = 1e-288, and
/// their last digit, 1e-304, is still above the smallest normal number, 2.2e-308.
template <class T>
inline constexpr T smallest_magnitude = T(1e-48);
/// Products of two factors in float are down to m^2 = 1e-34, and their last digit, 6e-42, above the smallest number,
/// 1.4e-45.
template <>
inline constexpr float smallest_magnitude<float> = 1e-17f;

}  // namespace graze

namespace graze::validate {

/// A number as it is printed in errors: the shortest form that reads back to the same value.
GRAZE_API std::string number(double value);

/// Throws `InvalidValue`.
[[noreturn]] GRAZE_API void fail(const std::string& path, const std::string& expectation, double found);
/// Throws `InvalidValue`.
[[noreturn]] GRAZE_API void fail(const std::string& path, const std::string& expectation, const std::string& found);

/// The unmet expectation of a coordinate with this value, or null if it is valid.
template <class T>
const char* fault_of_coordinate(T value) {
  if (!std::isfinite(value)) return "a finite number";
  if (value >= -largest_magnitude<T> && value <= largest_magnitude<T>) return nullptr;
  return sizeof(T) == sizeof(float) ? "a magnitude of at most 1e17 (in float)" : "a magnitude of at most 1e48";
}
/// The unmet expectation of a length with this value, or null if it is valid.
template <class T>
const char* fault_of_length(T value) {
  return std::isfinite(value) && value >= T(0) ? fault_of_coordinate(value) : "a finite number >= 0";
}

/// A length from 0 to `largest_magnitude`, returned unchanged. Throws `InvalidValue`.
template <class T>
T extent(T value, const char* path) {
  if (const char* expectation = fault_of_length(value)) fail(path, expectation, static_cast<double>(value));
  return value;
}

/// `value`, or zero (of the same sign) if it is smaller than `smallest_magnitude`. NaN stays NaN.
template <class T>
T resolved(T value) {
  return std::abs(value) < smallest_magnitude<T> ? value * T(0) : value;
}
/// A vector whose coordinates smaller than `smallest_magnitude` become zero.
template <class T>
Vec3<T> resolved(const Vec3<T>& v) {
  return {resolved(v.x), resolved(v.y), resolved(v.z)};
}

/// A length of a shape: an `extent`, zero where it is smaller than `smallest_magnitude`.
template <class T>
T size(T value, const char* path) {
  return resolved(extent(value, path));
}

/// A vector of lengths from 0 to `largest_magnitude`, returned unchanged. Throws `InvalidValue`.
template <class T>
Vec3<T> extents(const Vec3<T>& v, const std::string& path) {
  for (std::size_t i = 0; i < 3; ++i)
    if (const char* expectation = fault_of_length(v[i]))
      fail(path + "[" + std::to_string(i) + "]", expectation, static_cast<double>(v[i]));
  return v;
}

/// A point with coordinates up to `largest_magnitude`, returned unchanged. Throws `InvalidValue`.
template <class T>
Vec3<T> point(const Vec3<T>& v, const std::string& path) {
  for (std::size_t i = 0; i < 3; ++i)
    if (const char* expectation = fault_of_coordinate(v[i]))
      fail(path + "[" + std::to_string(i) + "]", expectation, static_cast<double>(v[i]));
  return v;
}

/// A point, validated without making a string for the path, which is rarely needed.
template <class T>
Vec3<T> point(const Vec3<T>& v, const char* path) {
  if (!fault_of_coordinate(v.x) && !fault_of_coordinate(v.y) && !fault_of_coordinate(v.z)) return v;
  return point(v, std::string(path));
}

/// A vertex of a shape: a `point` whose coordinates are zero where they are smaller than `smallest_magnitude`.
template <class T>
Vec3<T> vertex(const Vec3<T>& v, const char* path) {
  return resolved(point(v, path));
}

/// A finite quaternion that is not zero, returned at unit length.
template <class T>
Quat<T> rotation(const Quat<T>& q, const std::string& path) {
  const T parts[4] = {q.x, q.y, q.z, q.w};
  for (std::size_t i = 0; i < 4; ++i)
    if (!std::isfinite(parts[i]))
      fail(path + "[" + std::to_string(i) + "]", "a finite number", static_cast<double>(parts[i]));
  if (q.x == T(0) && q.y == T(0) && q.z == T(0) && q.w == T(0))
    fail(path, "a quaternion that is not zero", "[0, 0, 0, 0]");
  return normalized(q);
}

}  // namespace graze::validate
