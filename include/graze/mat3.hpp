// Three by three matrices, as rotations and as inertia tensors.
//
// Guarantee: exact operations in the order written, no branches, any lane type, as in `vec3.hpp`.
#pragma once

#include "graze/vec3.hpp"

namespace graze {

/// A matrix, stored by rows. The columns of a rotation matrix are the axes of the rotated frame.
template <class T>
struct Mat3 {
  Vec3<T> row[3];  ///< by rows

  /// The identity.
  static constexpr Mat3 identity() { return {{{T(1), T(0), T(0)}, {T(0), T(1), T(0)}, {T(0), T(0), T(1)}}}; }
  /// The diagonal matrix with these numbers.
  static constexpr Mat3 diagonal(const Vec3<T>& d) {
    return {{{d.x, T(0), T(0)}, {T(0), d.y, T(0)}, {T(0), T(0), d.z}}};
  }
  /// The matrix with these columns.
  static constexpr Mat3 from_columns(const Vec3<T>& x, const Vec3<T>& y, const Vec3<T>& z) {
    return {{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}};
  }

  /// The i-th column.
  constexpr Vec3<T> column(std::size_t i) const { return {row[0][i], row[1][i], row[2][i]}; }

  /// The matrix applied to a vector.
  friend constexpr Vec3<T> operator*(const Mat3& m, const Vec3<T>& v) {
    return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)};
  }
  /// The matrix product: first `b`, then `a`.
  friend constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
    return from_columns(a * b.column(0), a * b.column(1), a * b.column(2));
  }
  friend constexpr Mat3 operator+(const Mat3& a, const Mat3& b) {
    return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}};
  }
  friend constexpr Mat3 operator-(const Mat3& a, const Mat3& b) {
    return {{a.row[0] - b.row[0], a.row[1] - b.row[1], a.row[2] - b.row[2]}};
  }
  /// The matrix times a number.
  friend constexpr Mat3 operator*(const Mat3& m, const T& s) { return {{m.row[0] * s, m.row[1] * s, m.row[2] * s}}; }
};

using Mat3f = Mat3<float>;
using Mat3d = Mat3<double>;

/// The transposed matrix; for a rotation its inverse.
template <class T>
constexpr Mat3<T> transposed(const Mat3<T>& m) {
  return Mat3<T>::from_columns(m.row[0], m.row[1], m.row[2]);
}
/// `transposed(m) * v`: for a rotation, the inverse rotation.
template <class T>
constexpr Vec3<T> transposed_times(const Mat3<T>& m, const Vec3<T>& v) {
  return m.row[0] * v.x + m.row[1] * v.y + m.row[2] * v.z;
}
/// The determinant: the signed volume of the parallelepiped that the columns span.
template <class T>
constexpr T determinant(const Mat3<T>& m) {
  return dot(m.row[0], cross(m.row[1], m.row[2]));
}
/// The matrix u vᵀ.
template <class T>
constexpr Mat3<T> outer(const Vec3<T>& u, const Vec3<T>& v) {
  return {{v * u.x, v * u.y, v * u.z}};
}
/// The absolute value of each component.
template <class T>
Mat3<T> abs(const Mat3<T>& m) {
  return {{abs(m.row[0]), abs(m.row[1]), abs(m.row[2])}};
}
/// `yes` where the condition holds, else `no`, lane by lane.
template <class M, class T>
constexpr Mat3<T> select(const M& condition, const Mat3<T>& yes, const Mat3<T>& no) {
  return {{select(condition, yes.row[0], no.row[0]), select(condition, yes.row[1], no.row[1]),
           select(condition, yes.row[2], no.row[2])}};
}
template <class S, class T>
constexpr Mat3<S> converted(const Mat3<T>& m) {
  return {{converted<S>(m.row[0]), converted<S>(m.row[1]), converted<S>(m.row[2])}};
}

}  // namespace graze
