// Unit quaternions: rotations of space.
//
// Guarantee: as `vec3.hpp`; the sine of `from_axis_angle` is that of `angles.hpp`.
#pragma once

#include "graze/angles.hpp"
#include "graze/mat3.hpp"

namespace graze {

/// A quaternion x i + y j + z k + w; a rotation when of unit length. The order is glTF's.
template <class T>
struct Quat {
  T x{}, y{}, z{}, w{T(1)};  ///< x i + y j + z k + w.

  /// The vector part (x, y, z).
  constexpr Vec3<T> vector() const { return {x, y, z}; }

  /// The rotation by `angle` radians about the unit vector `axis`, right-handed.
  static Quat from_axis_angle(const Vec3<T>& axis, T angle) {
    const CosineSine half = cosine_sine(static_cast<double>(angle) / 2);
    const Vec3<T> v = axis * static_cast<T>(half.sine);
    return {v.x, v.y, v.z, static_cast<T>(half.cosine)};
  }

  /// Hamilton's product: the rotation `b` followed by `a`.
  friend constexpr Quat operator*(const Quat& a, const Quat& b) {
    const Vec3<T> v = b.vector() * a.w + a.vector() * b.w + cross(a.vector(), b.vector());
    return {v.x, v.y, v.z, a.w * b.w - dot(a.vector(), b.vector())};
  }
  /// Equality of all four components.
  friend constexpr bool operator==(const Quat& a, const Quat& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
  }
};

using Quatf = Quat<float>;
using Quatd = Quat<double>;

/// The inverse of a unit quaternion.
template <class T>
constexpr Quat<T> conjugate(const Quat<T>& q) {
  return {-q.x, -q.y, -q.z, q.w};
}

/// `q` scaled to unit length. The caller sees to it that `q` is finite and not zero; neither under- nor overflows.
template <class T>
Quat<T> normalized(const Quat<T>& q) {
  using std::abs, std::sqrt;
  const T scale = greatest(max_abs(q.vector()), abs(q.w));
  const Quat<T> p{q.x / scale, q.y / scale, q.z / scale, q.w / scale};
  const T l = sqrt(p.x * p.x + p.y * p.y + p.z * p.z + p.w * p.w);
  return {p.x / l, p.y / l, p.z / l, p.w / l};
}

/// The vector `v` turned by the unit quaternion `q`.
template <class T>
constexpr Vec3<T> rotate(const Quat<T>& q, const Vec3<T>& v) {
  const Vec3<T> t = cross(q.vector(), v) * T(2);
  return v + t * q.w + cross(q.vector(), t);
}

/// The rotation matrix of the unit quaternion `q`.
template <class T>
constexpr Mat3<T> rotation_matrix(const Quat<T>& q) {
  const T xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const T xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const T wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  const T one(1), two(2);
  return {{{one - two * (yy + zz), two * (xy - wz), two * (xz + wy)},
           {two * (xy + wz), one - two * (xx + zz), two * (yz - wx)},
           {two * (xz - wy), two * (yz + wx), one - two * (xx + yy)}}};
}

template <class S, class T>
constexpr Quat<S> converted(const Quat<T>& q) {
  return {static_cast<S>(q.x), static_cast<S>(q.y), static_cast<S>(q.z), static_cast<S>(q.w)};
}

}  // namespace graze
