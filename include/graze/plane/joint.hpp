// Joints of the plane: constraints on the relative motion of two bodies.
//
// Guarantee: that of `graze/joint.hpp`, whose type they share: a frame on either body, limits and drives. Frames have
// two axes to move along, x and y, and turn about the third, z: a `linear` limit names x or y or both, an `angular` one
// z, and a drive's axis is 0, 1 or 2. Other axes are refused.
#pragma once

#include "graze/joint.hpp"
#include "graze/plane/space.hpp"

namespace graze::plane {

template <class T>
using Joint = graze::Joint<T, Space<T>>;

/// A joint that keeps the two frames coincident.
template <class T>
Joint<T> fixed_joint(BodyId a, const Pose2<T>& frame_a, BodyId b, const Pose2<T>& frame_b) {
  return {
      a, b, frame_a, frame_b, {{JointSpace::linear, {true, true, false}}, {JointSpace::angular, {false, false, true}}},
      {}};
}
/// A joint that keeps the origins of the frames coincident and leaves the rotation free.
template <class T>
Joint<T> hinge_joint(BodyId a, const Pose2<T>& frame_a, BodyId b, const Pose2<T>& frame_b) {
  return {a, b, frame_a, frame_b, {{JointSpace::linear, {true, true, false}}}, {}};
}
/// A joint that leaves the translation along the x axis free, from `min` to `max`.
template <class T>
Joint<T> slider_joint(BodyId a, const Pose2<T>& frame_a, BodyId b, const Pose2<T>& frame_b,
                      T min = -std::numeric_limits<T>::infinity(), T max = std::numeric_limits<T>::infinity()) {
  Joint<T> joint{
      a, b, frame_a, frame_b, {{JointSpace::linear, {false, true, false}}, {JointSpace::angular, {false, false, true}}},
      {}};
  if (!(min == -std::numeric_limits<T>::infinity() && max == std::numeric_limits<T>::infinity()))
    joint.limits.push_back({JointSpace::linear, {true, false, false}, min, max, {}, T(0)});
  return joint;
}
/// A joint that keeps the origins of the frames from `min` to `max` apart.
template <class T>
Joint<T> distance_joint(BodyId a, const Pose2<T>& frame_a, BodyId b, const Pose2<T>& frame_b, T min, T max) {
  return {a, b, frame_a, frame_b, {{JointSpace::linear, {true, true, false}, min, max, {}, T(0)}}, {}};
}

}  // namespace graze::plane
