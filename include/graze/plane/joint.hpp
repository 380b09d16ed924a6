// Joints of the plane: what two bodies may do relative to each other.
//
// Guarantee: as `graze/joint.hpp`, of which they are: a frame on either body, limits and drives. Frames have two axes
// to move along, x and y, and turn about the third, z: a limit that is `linear` names x or y or both, one that is
// `angular` z, and a drive's axis is 0, 1 or 2. Whatever names others is refused.
#pragma once

#include "graze/joint.hpp"
#include "graze/plane/space.hpp"

namespace graze::plane {

template <class T>
using Joint = graze::Joint<T, Space<T>>;

/// The frames stay one.
template <class T>
Joint<T> fixed_joint(BodyId a, const Pose2<T>& frame_a, BodyId b, const Pose2<T>& frame_b) {
  return {
      a, b, frame_a, frame_b, {{JointSpace::linear, {true, true, false}}, {JointSpace::angular, {false, false, true}}},
      {}};
}
/// The origins of the frames stay one, and a turn is free.
template <class T>
Joint<T> hinge_joint(BodyId a, const Pose2<T>& frame_a, BodyId b, const Pose2<T>& frame_b) {
  return {a, b, frame_a, frame_b, {{JointSpace::linear, {true, true, false}}}, {}};
}
/// A way along the x axis is free, from `min` to `max`.
template <class T>
Joint<T> slider_joint(BodyId a, const Pose2<T>& frame_a, BodyId b, const Pose2<T>& frame_b,
                      T min = -std::numeric_limits<T>::infinity(), T max = std::numeric_limits<T>::infinity()) {
  Joint<T> joint{
      a, b, frame_a, frame_b, {{JointSpace::linear, {false, true, false}}, {JointSpace::angular, {false, false, true}}},
      {}};
  if (min > -std::numeric_limits<T>::infinity() || max < std::numeric_limits<T>::infinity())
    joint.limits.push_back({JointSpace::linear, {true, false, false}, min, max, {}, T(0)});
  return joint;
}
/// The origins of the frames stay from `min` to `max` apart.
template <class T>
Joint<T> distance_joint(BodyId a, const Pose2<T>& frame_a, BodyId b, const Pose2<T>& frame_b, T min, T max) {
  return {a, b, frame_a, frame_b, {{JointSpace::linear, {true, true, false}, min, max, {}, T(0)}}, {}};
}

}  // namespace graze::plane
