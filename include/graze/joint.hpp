// Joints: constraints on the relative motion of two bodies.
//
// Guarantee: plain values. One kind of joint, as in KHR_physics_rigid_bodies: a frame on either body, limits on the
// distance of the second along and about the first's axes, and drives that push it there. Axes without a limit are
// free. The named joints below are limits like any others.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "graze/pose.hpp"
#include "graze/world/bodies.hpp"

namespace graze {

/// A handle: the index of a joint, and how often the index was given away before.
struct JointId {
  /// The slot, and how often the slot was given away before.
  std::uint32_t index = ~std::uint32_t{0}, generation = 0;

  friend constexpr bool operator==(const JointId&, const JointId&) = default;
  friend constexpr auto operator<=>(const JointId&, const JointId&) = default;
};

/// The quantity of a limit or drive: the offset between the origins of the two frames, or the rotation between their
/// axes.
enum class JointSpace : std::uint8_t { linear, angular };

/// Bounds on one axis of frame A, or on two or three together: then on the length of the part of the offset (or of the
/// rotation) that lies in them, so that two linear axes make a tube, three a ball, and two angular axes a cone. In
/// units of length, or in radians. Turns about one axis are known up to whole ones: the one nearest to the middle of
/// the bounds counts, and bounds that are a whole turn or more apart bound nothing.
template <class T>
struct JointLimit {
  JointSpace space = JointSpace::linear;  ///< along an axis, or about it
  std::array<bool, 3> axes{};             ///< x, y, z of frame A; at least one
  T min = T(0), max = T(0);               ///< min <= max, either may be infinite; equal for what is held
  std::optional<T> stiffness{};           ///< >= 0, force per length or torque per radian beyond the bounds; none: hard
  T damping = T(0);                       ///< >= 0, of the soft limit: force per velocity

  friend bool operator==(const JointLimit&, const JointLimit&) = default;
};

/// Whether a drive's stiffness and damping are forces, or accelerations that mass and inertia do not change.
enum class DriveMode : std::uint8_t { force, acceleration };

/// A motor on one axis of frame A: stiffness (position_target - position) + damping (velocity_target - velocity).
template <class T>
struct JointDrive {
  JointSpace space = JointSpace::linear;  ///< along an axis, or about it
  DriveMode mode = DriveMode::force;      ///< whether stiffness and damping are of a force or of an acceleration
  std::uint8_t axis = 0;                  ///< 0, 1, 2: x, y, z of frame A
  T position_target = T(0), velocity_target = T(0);  ///< targets of the position and of the velocity
  T stiffness = T(0), damping = T(0);                ///< >= 0
  T max_force = std::numeric_limits<T>::infinity();  ///< >= 0; a torque for an angular axis

  friend bool operator==(const JointDrive&, const JointDrive&) = default;
};

/// A joint of two bodies. In the plane (`graze/plane/joint.hpp`) frames have two axes to move along, x and y, and turn
/// about the third, z.
template <class T, class Space = graze::Space<T>>
struct Joint {
  BodyId a{}, b{};                            ///< two different bodies; a fixed one ties the other to the world
  typename Space::Pose frame_a{}, frame_b{};  ///< each in its body's frame
  std::vector<JointLimit<T>> limits;          ///< bounds on the relative position
  std::vector<JointDrive<T>> drives;          ///< motors
  bool enable_collision = false;              ///< whether the two bodies may touch each other

  friend bool operator==(const Joint&, const Joint&) = default;
};

/// A joint that keeps the two frames coincident.
template <class T>
Joint<T> fixed_joint(BodyId a, const Pose<T>& frame_a, BodyId b, const Pose<T>& frame_b) {
  return {a, b, frame_a, frame_b, {{JointSpace::linear, {true, true, true}}, {JointSpace::angular, {true, true, true}}},
          {}};
}
/// A joint that keeps the origins of the frames coincident.
template <class T>
Joint<T> ball_joint(BodyId a, const Pose<T>& frame_a, BodyId b, const Pose<T>& frame_b) {
  return {a, b, frame_a, frame_b, {{JointSpace::linear, {true, true, true}}}, {}};
}
/// A joint that leaves the rotation about the x axis free.
template <class T>
Joint<T> hinge_joint(BodyId a, const Pose<T>& frame_a, BodyId b, const Pose<T>& frame_b) {
  return {
      a, b, frame_a, frame_b, {{JointSpace::linear, {true, true, true}}, {JointSpace::angular, {false, true, true}}},
      {}};
}
/// A joint that leaves the translation along the x axis free, from `min` to `max`.
template <class T>
Joint<T> slider_joint(BodyId a, const Pose<T>& frame_a, BodyId b, const Pose<T>& frame_b,
                      T min = -std::numeric_limits<T>::infinity(), T max = std::numeric_limits<T>::infinity()) {
  Joint<T> joint{
      a, b, frame_a, frame_b, {{JointSpace::linear, {false, true, true}}, {JointSpace::angular, {true, true, true}}},
      {}};
  if (!(min == -std::numeric_limits<T>::infinity() && max == std::numeric_limits<T>::infinity()))
    joint.limits.push_back({JointSpace::linear, {true, false, false}, min, max, {}, T(0)});
  return joint;
}
/// A joint that keeps the origins of the frames from `min` to `max` apart.
template <class T>
Joint<T> distance_joint(BodyId a, const Pose<T>& frame_a, BodyId b, const Pose<T>& frame_b, T min, T max) {
  return {a, b, frame_a, frame_b, {{JointSpace::linear, {true, true, true}, min, max, {}, T(0)}}, {}};
}

}  // namespace graze
