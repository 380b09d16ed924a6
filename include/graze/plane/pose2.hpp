// Poses: rigid transforms of the plane, and axis-aligned boxes in it.
//
// Guarantee: exact operations as in `pose.hpp`: a relative pose is made from the difference of two translations, so it
// does not lose digits when both bodies are far from the origin. A rotation is held as its cosine and sine, so that no
// query computes either.
#pragma once

#include <cmath>
#include <limits>

#include "graze/angles.hpp"
#include "graze/plane/vec2.hpp"

namespace graze::plane {

/// A rotation of the plane, counter-clockwise: the unit vector to which it turns the X axis.
template <class T>
struct Rot2 {
  T cosine{T(1)}, sine{};  ///< cosine and sine of the angle

  /// The rotation by `angle` radians; an angle that is not finite gives the identity.
  static Rot2 from_angle(T angle) {
    const CosineSine turn = cosine_sine(static_cast<double>(angle));
    return {static_cast<T>(turn.cosine), static_cast<T>(turn.sine)};
  }
  /// The product of rotations: first `b`, then `a`.
  friend constexpr Rot2 operator*(const Rot2& a, const Rot2& b) {
    return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
  }
  /// Equality of both components.
  friend constexpr bool operator==(const Rot2& a, const Rot2& b) { return a.cosine == b.cosine && a.sine == b.sine; }
};

/// The inverse rotation.
template <class T>
constexpr Rot2<T> inverse(const Rot2<T>& q) {
  return {q.cosine, -q.sine};
}
/// The vector turned by the rotation.
template <class T>
constexpr Vec2<T> rotate(const Rot2<T>& q, const Vec2<T>& v) {
  return {q.cosine * v.x - q.sine * v.y, q.sine * v.x + q.cosine * v.y};
}
/// The vector turned by the inverse rotation.
template <class T>
constexpr Vec2<T> inverse_rotate(const Rot2<T>& q, const Vec2<T>& v) {
  return {q.cosine * v.x + q.sine * v.y, q.cosine * v.y - q.sine * v.x};
}
template <class S, class T>
constexpr Rot2<S> converted(const Rot2<T>& q) {
  return {static_cast<S>(q.cosine), static_cast<S>(q.sine)};
}
/// The rotation at unit length, from which rounding or conversion to another scalar may have moved it a little.
template <class T>
Rot2<T> normalized(const Rot2<T>& q) {
  const Vec2<T> x = normalized(Vec2<T>{q.cosine, q.sine}, {T(1), T(0)});
  return {x.x, x.y};
}

/// A rigid motion from a body's frame to the world: p -> translation + rotation p.
template <class T>
struct Pose2 {
  Vec2<T> translation{};  ///< origin of the frame, in the world
  Rot2<T> rotation{};     ///< orientation, of unit length

  friend constexpr bool operator==(const Pose2&, const Pose2&) = default;
};

using Rot2d = Rot2<double>;
using Pose2f = Pose2<float>;
using Pose2d = Pose2<double>;

/// A point of the frame, in world coordinates.
template <class T>
constexpr Vec2<T> transform(const Pose2<T>& pose, const Vec2<T>& point) {
  return pose.translation + rotate(pose.rotation, point);
}
/// A point of the world, in coordinates of the frame.
template <class T>
constexpr Vec2<T> inverse_transform(const Pose2<T>& pose, const Vec2<T>& point) {
  return inverse_rotate(pose.rotation, point - pose.translation);
}
/// The motion `b` followed by `a`.
template <class T>
constexpr Pose2<T> compose(const Pose2<T>& a, const Pose2<T>& b) {
  return {transform(a, b.translation), a.rotation * b.rotation};
}
/// The pose `b` in the frame of `a`.
template <class T>
constexpr Pose2<T> relative(const Pose2<T>& a, const Pose2<T>& b) {
  return {inverse_transform(a, b.translation), inverse(a.rotation) * b.rotation};
}
template <class S, class T>
constexpr Pose2<S> converted(const Pose2<T>& pose) {
  return {converted<S>(pose.translation), converted<S>(pose.rotation)};
}

/// An axis-aligned box: all points between `lower` and `upper`, both included.
template <class T>
struct Aabb2 {
  Vec2<T> lower{}, upper{};  ///< the corners with the least and the greatest coordinates

  friend constexpr bool operator==(const Aabb2&, const Aabb2&) = default;
};

/// Whether two closed boxes have a point in common; touching counts.
template <class T>
constexpr bool overlap(const Aabb2<T>& a, const Aabb2<T>& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y;
}
/// The smallest box that contains both boxes.
template <class T>
constexpr Aabb2<T> merged(const Aabb2<T>& a, const Aabb2<T>& b) {
  return {least(a.lower, b.lower), greatest(a.upper, b.upper)};
}

}  // namespace graze::plane
