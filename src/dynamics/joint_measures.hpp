// What a limit or drive of a joint measures: lengths and angles of one frame seen from another, and how velocities
// change them.
//
// Guarantee: each row is the exact derivative of its measure, for any distance and angle of the frames, but for the
// locked angles, whose rows are those of frames that agree, as they do while a joint holds. Lengths and angles that
// have no direction at zero get one of frame A's axes.
#pragma once

#include "dynamics/angles.hpp"
#include "dynamics/solver_body.hpp"

namespace graze {

/// The rate of a measure: linear · (v_B - v_A) + angular_b · w_B - angular_a · w_A, and its value.
template <class T>
struct MeasuredRow {
  Vec3<T> linear{}, angular_a{}, angular_b{};
  T value{};

  T rate(const Vec3<T>& linear_a, const Vec3<T>& turning_a, const Vec3<T>& linear_b, const Vec3<T>& turning_b) const {
    return dot(linear, linear_b - linear_a) + dot(angular_b, turning_b) - dot(angular_a, turning_a);
  }
};

/// The frames of a joint in the world.
template <class T>
struct JointFrames {
  Mat3<T> a, b;              ///< axes as columns
  Quat<T> turn{};            ///< of B seen from A, the shorter way
  Vec3<T> arm_a{}, arm_b{};  ///< from the centres of mass to the origins
  Vec3<T> way{};             ///< from A's origin to B's

  JointFrames(const SolverBody<T>& body_a, const Pose<T>& frame_a, const SolverBody<T>& body_b,
              const Pose<T>& frame_b) {
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
  MeasuredRow<T> along(const Vec3<T>& direction) const {
    return {direction, cross(arm_a + way, direction), cross(arm_b, direction), dot(way, direction)};
  }
  MeasuredRow<T> along_axis(std::size_t i) const { return along(a.column(i)); }

  /// The length of the part of the way that lies in some axes of A.
  MeasuredRow<T> distance(const std::array<bool, 3>& axes) const {
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
  static MeasuredRow<T> about(const Vec3<T>& direction, T angle) { return {{}, direction, direction, angle}; }

  /// The twist about an axis of A: with q the turn, 2 atan(q_i / q_w). Its rate is g · w in A's frame, w being B's
  /// turning seen from A: with q' = (0, w) q / 2, g = (q_w² e_i + q_w q_v × e_i + q_i q_v) / (q_w² + q_i²).
  MeasuredRow<T> twist(std::size_t i) const {
    const Vec3<T> v = turn.vector();
    const T w = turn.w, d = w * w + v[i] * v[i];
    if (!(d > T(0))) return about(a.column(i), pi<T>);
    Vec3<T> e{};
    e[i] = T(1);
    return about(a * ((e * (w * w) + cross(v, e) * w + v * v[i]) / d), T(2) * angle_of(w, v[i]));
  }

  /// The angle between the axes k of both.
  MeasuredRow<T> swing(std::size_t k) const {
    const Vec3<T> c = cross(a.column(k), b.column(k));
    const T s = length(c);
    return about(s > T(0) ? c / s : a.column((k + 1) % 3), angle_of(dot(a.column(k), b.column(k)), s));
  }

  /// The angle of the whole turn.
  MeasuredRow<T> whole_turn() const {
    const T s = length(turn.vector());
    return about(s > T(0) ? a * (turn.vector() / s) : a.column(0), T(2) * angle_of(turn.w, s));
  }

  /// The part about axis i of what keeps the axes k together.
  MeasuredRow<T> locked_swing(std::size_t i, std::size_t k) const {
    return about(a.column(i), dot(cross(a.column(k), b.column(k)), a.column(i)));
  }
  /// The part about axis i of what keeps both frames together.
  MeasuredRow<T> locked_turn(std::size_t i) const { return about(a.column(i), T(2) * turn.vector()[i]); }
};

}  // namespace graze
