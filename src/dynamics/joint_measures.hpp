// The measures of a joint's limits and drives: lengths and angles of one frame seen from another, and the rates at
// which velocities change them.
//
// Guarantee: each row is the exact derivative of its measure, for any distance and angle of the frames, but for locked
// angles of frames that are far apart, as they are never while a joint holds. Any other row adds energy: frames that
// turn fast against each other differ within a sub-step. Lengths and angles that have no direction at zero get one of
// frame A's axes.
#pragma once

#include <array>
#include <numbers>

#include "dynamics/solver_body.hpp"
#include "graze/angles.hpp"

namespace graze {

/// The rate of a measure: linear · (v_B - v_A) + angular_b · w_B - angular_a · w_A, and its value.
template <class T, class Space = graze::Space<T>>
struct MeasuredRow {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;

  Vec linear{};
  Turning angular_a{}, angular_b{};
  T value{};

  T rate(const Vec& linear_a, const Turning& turning_a, const Vec& linear_b, const Turning& turning_b) const {
    return dot(linear, linear_b - linear_a) + dot(angular_b, turning_b) - dot(angular_a, turning_a);
  }
};

/// The kinds of measures: along an axis of frame A, or about it; or a length or angle over several axes.
enum class Measure : std::uint8_t { along, distance, twist, swing, whole_turn, locked_swing, locked_turn };

/// A measure and the axes that it is of.
struct Measured {
  Measure measure;
  std::uint8_t axis = 0;       ///< of frame A
  std::uint8_t other = 0;      ///< the axis that is held, of a locked swing
  std::array<bool, 3> axes{};  ///< of a distance
};

/// The frames of a joint in the world.
template <class T, class Space = graze::Space<T>>
struct JointFrames;

template <class T>
struct JointFrames<T, Space<T>> {
  using Body = SolverBody<T, Space<T>>;
  using Row = MeasuredRow<T, Space<T>>;

  /// The cosine of an angle of frames that a joint locks from which on it holds them, and does not recover them.
  static constexpr T near = T(0.5);

  Mat3<T> a, b;              ///< axes as columns
  Quat<T> turn{};            ///< of B seen from A, the shorter way
  Vec3<T> arm_a{}, arm_b{};  ///< from the centres of mass to the origins
  Vec3<T> way{};             ///< from A's origin to B's

  JointFrames(const Body& body_a, const Pose<T>& frame_a, const Body& body_b, const Pose<T>& frame_b) {
    const Quat<T> qa = body_a.rotation * frame_a.rotation, qb = body_b.rotation * frame_b.rotation;
    a = rotation_matrix(qa);
    b = rotation_matrix(qb);
    turn = conjugate(qa) * qb;
    if (turn.w < T(0)) turn = {-turn.x, -turn.y, -turn.z, -turn.w};
    arm_a = rotate(body_a.rotation, frame_a.translation);
    arm_b = rotate(body_b.rotation, frame_b.translation);
    way = (body_b.center - body_a.center) + (arm_b - arm_a);
  }

  /// The way along a direction that turns with A.
  Row along(const Vec3<T>& direction) const {
    return {direction, cross(arm_a + way, direction), cross(arm_b, direction), dot(way, direction)};
  }
  Row along_axis(std::size_t i) const { return along(a.column(i)); }

  /// The length of the part of the way that lies in some axes of A.
  Row distance(const std::array<bool, 3>& axes) const {
    Vec3<T> part{};
    Vec3<T> direction{};
    for (std::size_t i = 0; i < 3; ++i)
      if (axes[i]) {
        part += a.column(i) * dot(way, a.column(i));
        direction = a.column(i);
      }
    const T l = length(part);
    return along(l > T(0) ? part / l : direction);
  }

  /// A turning about a direction.
  static Row about(const Vec3<T>& direction, T angle) { return {{}, direction, direction, angle}; }

  /// The twist about an axis of A: with q the turn, 2 atan(q_i / q_w). Its rate is g · w in A's frame, w being B's
  /// turning seen from A: with q' = (0, w) q / 2, g = (q_w² e_i + q_w q_v × e_i + q_i q_v) / (q_w² + q_i²).
  Row twist(std::size_t i) const {
    const Vec3<T> v = turn.vector();
    const T w = turn.w, d = w * w + v[i] * v[i];
    if (!(d > T(0))) return about(a.column(i), std::numbers::pi_v<T>);
    Vec3<T> e{};
    e[i] = T(1);
    return about(a * ((e * (w * w) + cross(v, e) * w + v * v[i]) / d), T(2) * angle_of(w, v[i]));
  }

  /// The angle between the axes k of both.
  Row swing(std::size_t k) const {
    const Vec3<T> c = cross(a.column(k), b.column(k));
    const T s = length(c);
    return about(s > T(0) ? c / s : a.column((k + 1) % 3), angle_of(dot(a.column(k), b.column(k)), s));
  }

  /// The angle of the whole turn.
  Row whole_turn() const {
    const T s = length(turn.vector());
    return about(s > T(0) ? a * (turn.vector() / s) : a.column(0), T(2) * angle_of(turn.w, s));
  }

  /// The part about axis i of what keeps the axes k together: of the cross product of both. Where they are far apart
  /// its rate vanishes about some axes, and it is that of frames that agree.
  Row locked_swing(std::size_t i, std::size_t k) const {
    const Vec3<T> across = cross(a.column(i), a.column(k)), own = b.column(k);
    const Vec3<T> rate = dot(a.column(k), own) > near ? cross(own, across) : a.column(i);
    return about(rate, dot(own, across));
  }
  /// The part about axis i of what keeps both frames together: twice the turn's. Its rate is that of `twist`'s q_i.
  Row locked_turn(std::size_t i) const {
    Vec3<T> e{};
    e[i] = T(1);
    const Vec3<T> v = turn.vector();
    return about(turn.w > near ? a * (e * turn.w + cross(v, e)) : a.column(i), T(2) * v[i]);
  }

  Row measured(const Measured& what) const {
    switch (what.measure) {
    case Measure::along: return along_axis(what.axis);
    case Measure::distance: return distance(what.axes);
    case Measure::twist: return twist(what.axis);
    case Measure::swing: return swing(what.axis);
    case Measure::whole_turn: return whole_turn();
    case Measure::locked_swing: return locked_swing(what.axis, what.other);
    case Measure::locked_turn: break;
    }
    return locked_turn(what.axis);
  }
};

/// The frames of a joint of the plane, where there is one angle, and no row that holds it by others.
template <class T>
struct JointFrames<T, plane::Space<T>> {
  using Vec = plane::Vec2<T>;
  using Body = SolverBody<T, plane::Space<T>>;
  using Row = MeasuredRow<T, plane::Space<T>>;

  Vec axes_a[2];          ///< of frame A
  plane::Rot2<T> turn{};  ///< of B seen from A
  Vec arm_a{}, arm_b{};   ///< from the centres of mass to the origins
  Vec way{};              ///< from A's origin to B's

  JointFrames(const Body& body_a, const plane::Pose2<T>& frame_a, const Body& body_b, const plane::Pose2<T>& frame_b) {
    const plane::Rot2<T> qa = body_a.rotation * frame_a.rotation, qb = body_b.rotation * frame_b.rotation;
    axes_a[0] = {qa.cosine, qa.sine};
    axes_a[1] = left(axes_a[0]);
    turn = inverse(qa) * qb;
    arm_a = rotate(body_a.rotation, frame_a.translation);
    arm_b = rotate(body_b.rotation, frame_b.translation);
    way = (body_b.center - body_a.center) + (arm_b - arm_a);
  }

  Row along(const Vec& direction) const {
    return {direction, cross(arm_a + way, direction), cross(arm_b, direction), dot(way, direction)};
  }

  Row measured(const Measured& what) const {
    if (what.measure == Measure::along) return along(axes_a[what.axis]);
    if (what.measure != Measure::distance) return {{}, T(1), T(1), angle_of(turn.cosine, turn.sine)};
    Vec part{}, direction{};
    for (std::size_t i = 0; i < 2; ++i)
      if (what.axes[i]) {
        part += axes_a[i] * dot(way, axes_a[i]);
        direction = axes_a[i];
      }
    const T l = length(part);
    return along(l > T(0) ? part / l : direction);
  }
};

}  // namespace graze
