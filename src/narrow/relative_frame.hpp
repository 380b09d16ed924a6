// One body seen from another as a matrix and a vector.
//
// Guarantee: rotations need not be of unit length; their matrices are divided by the squared length, without a root.
// Exact operations in the order written, no branches, any lane type.
#pragma once

#include "graze/pose.hpp"

namespace graze {

/// The frame of B seen from A.
template <class S>
struct RelativeFrame {
  Mat3<S> rotation;
  Vec3<S> translation;
};

/// The rotation matrix of a quaternion that rounding has left not quite of unit length.
template <class S>
Mat3<S> rotation_of(const Quat<S>& q) {
  const S s = S(2) / (q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w), one(1);
  const S x = q.x * s, y = q.y * s, z = q.z * s;
  const S xx = q.x * x, yy = q.y * y, zz = q.z * z, xy = q.x * y, xz = q.x * z, yz = q.y * z, wx = q.w * x,
          wy = q.w * y, wz = q.w * z;
  return {
      {{one - (yy + zz), xy - wz, xz + wy}, {xy + wz, one - (xx + zz), yz - wx}, {xz - wy, yz + wx, one - (xx + yy)}}};
}

/// `turn_a` is A's rotation as a matrix.
template <class S>
RelativeFrame<S> relative_frame(const Pose<S>& a, const Mat3<S>& turn_a, const Pose<S>& b) {
  return {rotation_of(conjugate(a.rotation) * b.rotation), transposed_times(turn_a, b.translation - a.translation)};
}
template <class S>
RelativeFrame<S> relative_frame(const Pose<S>& a, const Pose<S>& b) {
  return relative_frame(a, rotation_of(a.rotation), b);
}

}  // namespace graze
