// Pairs of simple cores: B's transformed to A's frame, and the answer back to the world with the rounding radii added.
#pragma once

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/core/core.hpp"
#include "narrow/general.hpp"
#include "shape/rounding.hpp"

namespace graze {

template <class S>
PointCore<S> moved(const PointCore<S>& core, const Pose<S>& pose) {
  return {transform(pose, core.point)};
}
/// The core in another frame. Its ends keep the roundings of numbers that may have cancelled: a rotation and a sum have
/// some five of them.
template <class S>
SegmentCore<S> moved(const SegmentCore<S>& core, const Pose<S>& pose) {
  const auto& [a, b] = core.segment;
  return {{transform(pose, a), transform(pose, b)},
          core.error + S(8) * epsilon<S> * (max_abs(pose.translation) + greatest(max_abs(a), max_abs(b)))};
}

/// A core under a pose, in a frame at `offset` from the pose's origin along the world's axes.
template <class S>
PointCore<S> turned(const PointCore<S>& core, const Quat<S>& rotation, const Vec3<S>& offset) {
  // The shortcut gives the same bits, since zeros lose their sign: most balls are about their origins.
  const Vec3<S> zero{S(0), S(0), S(0)};
  if (is_origin(core.point)) return {offset + zero};
  return {offset + (rotate(rotation, core.point) + zero)};
}
template <class S>
TurnedAxis<S> turned(const AxisCore<S>& core, const Quat<S>& rotation, const Vec3<S>& offset) {
  return {offset, rotation_matrix(rotation).column(1), core.half_height};
}

/// The signed distance of two cores from their nearest points.
template <class A, class B>
auto core_distance(const A& a, const B& b) -> decltype(core_distance(a, b, nearest_points(a, b))) {
  return core_distance(a, b, nearest_points(a, b));
}

/// Two spheres or capsules in a frame at A's origin along the world's axes: cores are rotated, and the answer is only
/// translated.
template <class A, class B, class S>
struct SphereCapsulePair {
  Vec3<S> origin;  ///< origin of that frame, in the world
  decltype(turned(A(), Quat<S>(), Vec3<S>())) a;
  decltype(turned(B(), Quat<S>(), Vec3<S>())) b;
  S radius_a, radius_b;

  SphereCapsulePair(const Rounded<A, S>& of_a, const Pose<S>& pose_a, const Rounded<B, S>& of_b, const Pose<S>& pose_b)
      : origin(pose_a.translation),
        a(turned(of_a.core, pose_a.rotation, Vec3<S>{S(0), S(0), S(0)})),
        b(turned(of_b.core, pose_b.rotation, pose_b.translation - pose_a.translation)),
        radius_a(of_a.radius),
        radius_b(of_b.radius) {}

  S radii() const { return radius_a + radius_b; }
  CorePoints<S> nearest() const { return nearest_points(a, b); }
  CoreDistance<S> core(const CorePoints<S>& nearest) const { return core_distance(a, b, nearest); }
  /// The distance of the rounded shapes, in the world.
  CoreDistance<S> in_world(const CoreDistance<S>& core) const {
    return {core.distance - radii(), core.normal, origin + (core.a + core.normal * radius_a),
            origin + (core.b - core.normal * radius_b)};
  }
};

/// A ball and a box, whose core is about its own origin: the ball's centre in the box's frame.
template <class S>
struct BallAndBox {
  Vec3<S> center;  ///< offset from the box's origin along the world's axes
  Mat3<S> rotation;
  Vec3<S> origin;  ///< origin of the box, in the world
  PointCore<S> ball;
  BoxCore<S> box;
  S radius_ball, radius_box;

  BallAndBox(const Rounded<PointCore<S>, S>& of_ball, const Pose<S>& pose_ball, const Rounded<BoxCore<S>, S>& of_box,
             const Pose<S>& pose_box)
      : center(turned(of_ball.core, pose_ball.rotation, pose_ball.translation - pose_box.translation).point),
        rotation(rotation_matrix(pose_box.rotation)),
        origin(pose_box.translation),
        ball{transposed_times(rotation, center)},
        box(of_box.core),
        radius_ball(of_ball.radius),
        radius_box(of_box.radius) {}

  S radii() const { return radius_ball + radius_box; }
  /// The nearest points of the box and the ball, in the box's frame.
  CorePoints<S> nearest() const { return nearest_points(box, ball); }
  CoreDistance<S> core(const CorePoints<S>& nearest) const { return core_distance(box, ball, nearest); }
  /// The distance from the rounded ball to the rounded box, in the world.
  CoreDistance<S> in_world(const CoreDistance<S>& core) const {
    const Vec3<S> outward = rotation * core.normal;
    return {core.distance - radii(), -outward, origin + (center - outward * radius_ball),
            origin + (rotation * core.a + outward * radius_box)};
  }
};

template <class A, class B, class S>
SphereCapsulePair<A, B, S> sphere_capsule_pair(const Rounded<A, S>& a, const Pose<S>& pose_a, const Rounded<B, S>& b,
                                               const Pose<S>& pose_b) {
  return {a, pose_a, b, pose_b};
}
template <class S>
BallAndBox<S> sphere_capsule_pair(const Rounded<PointCore<S>, S>& ball, const Pose<S>& pose_ball,
                                  const Rounded<BoxCore<S>, S>& box, const Pose<S>& pose_box) {
  return {ball, pose_ball, box, pose_box};
}

template <class T>
Rounded<PointCore<T>, T> rounded_core(const Sphere<T>& sphere, T rounding) {
  return {core_of(sphere), rounding_radius(sphere, rounding)};
}
/// The core of an untapered capsule.
template <class T>
Rounded<AxisCore<T>, T> rounded_core(const Capsule<T>& capsule, T rounding) {
  return {{capsule.half_height()}, rounding_radius(capsule, rounding)};
}
template <class T>
Rounded<BoxCore<T>, T> rounded_core(const Box<T>& box, T rounding) {
  return {core_of(box), rounding};
}
template <class T>
Rounded<BoxCore<T>, T> rounded_core(const Rectangle<T>& rectangle, T rounding) {
  return {core_of(rectangle), rounding};
}
template <class T>
Rounded<TriangleCore<T>, T> rounded_core(const Triangle<T>& triangle, T rounding) {
  return {{{triangle.point(0), triangle.point(1), triangle.point(2)}}, rounding};
}

/// The distance of the rounded shapes in the world, from that of the cores in A's frame.
template <class T>
Distance<T> finished(const CoreDistance<T>& core, T radius_a, T radius_b, const Pose<T>& pose_a) {
  Distance<T> d;
  d.distance = core.distance - (radius_a + radius_b);
  d.normal = rotate(pose_a.rotation, core.normal);
  d.a = transform(pose_a, core.a + core.normal * radius_a);
  d.b = transform(pose_a, core.b - core.normal * radius_b);
  return d;
}

/// Copies number by number from registers: g++ writes an aggregate to the stack first, and wider loads from there stall
/// store forwarding.
template <class T>
void put(const Vec3<T>& from, Vec3<T>& to) {
  to = {from.x, from.y, from.z};
}
template <class T>
void put(const Distance<T>& from, Distance<T>& to) {
  to.distance = from.distance;
  put(from.normal, to.normal);
  put(from.a, to.a);
  put(from.b, to.b);
  to.status = from.status;
  to.error = from.error;
}

template <class T>
Distance<T> mirrored(const Distance<T>& d) {
  return {d.distance, -d.normal, {d.b.x, d.b.y, d.b.z}, {d.a.x, d.a.y, d.a.z}, d.status, d.error};
}

/// The largest distance in S that is within `margin` once it is rounded to T.
template <class T, class S>
S before_rounding(const S& margin) {
  return margin * S(1 + 2 * static_cast<double>(std::numeric_limits<T>::epsilon()));
}

/// A distance that was computed in double, rounded to T.
template <class T>
Distance<T> rounded(const Distance<double>& d) {
  return {static_cast<T>(d.distance), converted<T>(d.normal), converted<T>(d.a), converted<T>(d.b)};
}

/// The distance of the rounded shapes, finished in double; only the result is rounded to T.
template <class T>
Distance<T> finished_in_double(const CoreDistance<double>& core, T radius_a, T radius_b, const Posed& frame) {
  return rounded<T>(finished<double>(core, radius_a, radius_b, frame));
}

}  // namespace graze
