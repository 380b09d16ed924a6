// Arguments from C, read and checked: handles, arrays with strides, poses, numbers.
//
// Guarantee: each function throws `InvalidValue` that names the parameter, and otherwise returns the value bit for bit.
#pragma once

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "c/error.hpp"
#include "graze/detail/validate.hpp"
#include "graze/plane/pose2.hpp"
#include "graze/plane/shape/flat.hpp"
#include "graze/pose.hpp"

namespace graze::c {

/// The bits of a value as another type. Not every standard library has `std::bit_cast`; Emscripten's of Debian 12 has
/// not.
template <class To, class From>
constexpr To same_bytes(const From& value) {
  return __builtin_bit_cast(To, value);
}

/// The numbers of a rotation by an angle that is not finite, for which the library has the identity. Functions that
/// return a pose cannot fail: the call that takes the pose refuses it.
template <class T>
inline constexpr T no_rotation = std::numeric_limits<T>::quiet_NaN();

/// Throws for a null pointer where none is allowed.
[[noreturn]] inline void null(const char* path) { validate::fail(path, "a pointer", "null"); }

template <class P>
P* given(P* pointer, const char* path) {
  if (pointer == nullptr) null(path);
  return pointer;
}

/// The object behind a handle. Every such object begins with a number of its kind, so that a handle of another kind is
/// refused: in languages that call C, pointers may have no types.
template <class H>
H& opened(H* handle, const char* path) {
  if (handle == nullptr) null(path);
  if (handle->tag != H::own_tag) validate::fail(path, H::name, "a handle of another kind");
  return *handle;
}

/// The i-th element of an array whose elements begin `stride` bytes apart (0: one behind the other), wherever it lies.
template <class E>
E element(const E* first, std::size_t stride, std::size_t i) {
  E value;
  std::memcpy(&value, reinterpret_cast<const char*>(first) + i * (stride == 0 ? sizeof(E) : stride), sizeof(E));
  return value;
}
template <class E>
void set_element(E* first, std::size_t stride, std::size_t i, const E& value) {
  std::memcpy(reinterpret_cast<char*>(first) + i * (stride == 0 ? sizeof(E) : stride), &value, sizeof(E));
}

/// An array that may be null only where it has no elements.
template <class E>
const E* array(const E* first, std::size_t count, const char* path) {
  if (first == nullptr && count > 0) null(path);
  return first;
}

/// The path of the i-th element.
inline std::string at(const char* path, std::size_t i) { return std::string(path) + "[" + std::to_string(i) + "]"; }

/// An enumerator, by its number: one of the first `count`.
template <class To, class From>
To enumerator(From value, int count, const char* path) {
  const int number = static_cast<int>(value);
  if (number < 0 || number >= count)
    validate::fail(path, "an enumerator from 0 to " + std::to_string(count - 1), static_cast<double>(number));
  return static_cast<To>(number);
}

/// The largest difference from 1 of the squared length of a rotation: a larger one is a mistake and no rounding, since
/// even rotations from half precision (2^-11 a number) are nearer.
template <class T>
inline constexpr T unit_slack = T(1e-2);

template <class T>
bool unit(T squared) {
  return squared >= T(1) - unit_slack<T> && squared <= T(1) + unit_slack<T>;
}

/// Throws the reason why a pose is refused: a function of its own, so that the check itself is short.
template <class T>
[[noreturn]] void refuse(const Pose<T>& pose, const std::string& path) {
  validate::point(pose.translation, path + ".translation");
  validate::fail(path + ".rotation", "a quaternion of unit length",
                 "[" + validate::number(static_cast<double>(pose.rotation.x)) + ", " +
                     validate::number(static_cast<double>(pose.rotation.y)) + ", " +
                     validate::number(static_cast<double>(pose.rotation.z)) + ", " +
                     validate::number(static_cast<double>(pose.rotation.w)) + "]");
}
template <class T>
[[noreturn]] void refuse(const plane::Pose2<T>& pose, const std::string& path) {
  plane::detail::checked_point(pose.translation, path + ".translation");
  validate::fail(path + ".rotation", "a unit vector of cosine and sine",
                 "[" + validate::number(static_cast<double>(pose.rotation.cosine)) + ", " +
                     validate::number(static_cast<double>(pose.rotation.sine)) + "]");
}

template <class T>
bool good(const Vec3<T>& v) {
  return !validate::fault_of_coordinate(v.x) && !validate::fault_of_coordinate(v.y) &&
         !validate::fault_of_coordinate(v.z);
}
template <class T>
bool good(const plane::Vec2<T>& v) {
  return !validate::fault_of_coordinate(v.x) && !validate::fault_of_coordinate(v.y);
}
template <class T>
bool good(const Pose<T>& pose) {
  const Quat<T>& q = pose.rotation;
  return good(pose.translation) && unit(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
}
template <class T>
bool good(const plane::Pose2<T>& pose) {
  const plane::Rot2<T>& q = pose.rotation;
  return good(pose.translation) && unit(q.cosine * q.cosine + q.sine * q.sine);
}

/// A pose whose numbers queries take.
template <class P>
const P& checked(const P& pose, const char* path) {
  if (!good(pose)) refuse(pose, path);
  return pose;
}

/// A time: finite and >= 0.
template <class T>
T duration(T value, const char* path = "duration") {
  if (!(value >= T(0)) || !std::isfinite(value))
    validate::fail(path, "a finite number >= 0", static_cast<double>(value));
  return value;
}

/// The reach of a query: >= 0, without end where it is infinite.
template <class T>
T reach(T value, const char* path) {
  if (!(value >= T(0))) validate::fail(path, "a number >= 0", static_cast<double>(value));
  return value;
}

}  // namespace graze::c
