// Poses: rigid transforms from a body's frame to the world.
//
// Guarantee: exact operations as in `vec3.hpp`. A relative pose is made from the *difference* of two translations, so
// it does not lose digits when both bodies are far from the origin.
#pragma once

#include "graze/quat.hpp"

namespace graze {

/// A rigid motion from a body's frame to the world: p -> translation + rotation p.
template <class T>
struct Pose {
  Vec3<T> translation{};  ///< origin of the frame, in the world
  Quat<T> rotation{};     ///< orientation, of unit length

  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

using Posef = Pose<float>;
using Posed = Pose<double>;

/// A point of the frame, in world coordinates.
template <class T>
constexpr Vec3<T> transform(const Pose<T>& pose, const Vec3<T>& point) {
  return pose.translation + rotate(pose.rotation, point);
}
/// A point of the world, in coordinates of the frame.
template <class T>
constexpr Vec3<T> inverse_transform(const Pose<T>& pose, const Vec3<T>& point) {
  return rotate(conjugate(pose.rotation), point - pose.translation);
}
/// The motion `b` followed by `a`.
template <class T>
constexpr Pose<T> compose(const Pose<T>& a, const Pose<T>& b) {
  return {transform(a, b.translation), a.rotation * b.rotation};
}
/// The inverse motion.
template <class T>
constexpr Pose<T> inverse(const Pose<T>& pose) {
  const Quat<T> q = conjugate(pose.rotation);
  return {rotate(q, -pose.translation), q};
}
/// The pose `b` in the frame of `a`.
template <class T>
constexpr Pose<T> relative(const Pose<T>& a, const Pose<T>& b) {
  return {inverse_transform(a, b.translation), conjugate(a.rotation) * b.rotation};
}
template <class S, class T>
constexpr Pose<S> converted(const Pose<T>& pose) {
  return {converted<S>(pose.translation), converted<S>(pose.rotation)};
}

}  // namespace graze
