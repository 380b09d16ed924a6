// The pose of one body relative to another, as a matrix and a vector.
//
// Guarantee: rotations need not be of unit length; their matrices are divided by the squared length, or multiplied by
// it, without a root. Exact operations in the order written, no branches, any lane type.
#pragma once

#include "graze/pose.hpp"

namespace graze {

/// The frame of B in the frame of A.
template <class S>
struct RelativeFrame {
  Mat3<S> rotation;
  Vec3<S> translation;
};

template <class S>
S length_squared(const Quat<S>& q) {
  return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}

/// The rotation matrix of a quaternion that is not quite of unit length, given the square of its length.
template <class S>
Mat3<S> rotation_of(const Quat<S>& q, const S& squared) {
  const S s = S(2) / squared, one(1);
  const S x = q.x * s, y = q.y * s, z = q.z * s;
  const S xx = q.x * x, yy = q.y * y, zz = q.z * z, xy = q.x * y, xz = q.x * z, yz = q.y * z, wx = q.w * x,
          wy = q.w * y, wz = q.w * z;
  return {
      {{one - (yy + zz), xy - wz, xz + wy}, {xy + wz, one - (xx + zz), yz - wx}, {xz - wy, yz + wx, one - (xx + yy)}}};
}

template <class S>
Mat3<S> rotation_of(const Quat<S>& q) {
  return rotation_of(q, length_squared(q));
}

/// A rotation matrix times `scale`, the squared length of its quaternion, which takes no division.
template <class S>
struct ScaledRotation {
  Mat3<S> matrix;
  S scale;
};
template <class S>
ScaledRotation<S> scaled_rotation_of(const Quat<S>& q) {
  const S x = q.x + q.x, y = q.y + q.y, z = q.z + q.z;
  const S xy = q.x * y, xz = q.x * z, yz = q.y * z, wx = q.w * x, wy = q.w * y, wz = q.w * z;
  const S xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, ww = q.w * q.w;
  const S sum_wx = ww + xx, less_wx = ww - xx, sum_yz = yy + zz, less_yz = yy - zz;
  return {{{{sum_wx - sum_yz, xy - wz, xz + wy},
            {xy + wz, less_wx + less_yz, yz - wx},
            {xz - wy, yz + wx, less_wx - less_yz}}},
          sum_wx + sum_yz};
}

/// The frame of B in that of A. `turn_a` is A's rotation as a matrix.
template <class S>
RelativeFrame<S> relative_frame(const Pose<S>& a, const Mat3<S>& turn_a, const Pose<S>& b) {
  // The square of the product's length, from the factors' and so available before the product.
  return {rotation_of(conjugate(a.rotation) * b.rotation, length_squared(a.rotation) * length_squared(b.rotation)),
          transposed_times(turn_a, b.translation - a.translation)};
}
template <class S>
RelativeFrame<S> relative_frame(const Pose<S>& a, const Pose<S>& b) {
  return relative_frame(a, rotation_of(a.rotation), b);
}

}  // namespace graze
