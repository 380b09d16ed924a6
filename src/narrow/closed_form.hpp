// A pair of the simplest cores: B's brought to A's frame, and the answer back to the world with the rounding radii on.
#pragma once

#include "graze/query.hpp"
#include "narrow/core.hpp"
#include "narrow/general.hpp"

namespace graze {

template <class S>
PointCore<S> moved(const PointCore<S>& core, const Pose<S>& pose) {
  return {transform(pose, core.point)};
}
template <class S>
SegmentCore<S> moved(const SegmentCore<S>& core, const Pose<S>& pose) {
  return {{transform(pose, core.segment.a), transform(pose, core.segment.b)}};
}

/// Two balls' centres in a frame at A's origin along the world's axes: nothing has to turn but centres off the origin.
template <class T>
struct BallCores {
  PointCore<T> a, b;
  Pose<T> frame;

  BallCores(const Sphere<T>& ball_a, const Pose<T>& pose_a, const Sphere<T>& ball_b, const Pose<T>& pose_b)
      : a{turned(ball_a, pose_a)},
        b{pose_b.translation - pose_a.translation + turned(ball_b, pose_b)},
        frame{pose_a.translation, {}} {}

 private:
  static Vec3<T> turned(const Sphere<T>& ball, const Pose<T>& pose) {
    return ball.center() == Vec3<T>{} ? Vec3<T>{} : rotate(pose.rotation, ball.center());
  }
};

/// Adds the rounding radii and takes the answer from A's frame to the world.
template <class T>
Distance<T> finished(const CoreDistance<T>& core, T radius_a, T radius_b, const Pose<T>& pose_a) {
  Distance<T> d;
  d.distance = core.distance - (radius_a + radius_b);
  d.normal = rotate(pose_a.rotation, core.normal);
  d.a = transform(pose_a, core.a + core.normal * radius_a);
  d.b = transform(pose_a, core.b - core.normal * radius_b);
  return d;
}

/// The same for what was computed in double: only the answer is rounded to T.
template <class T>
Distance<T> finished_in_double(const CoreDistance<double>& core, T radius_a, T radius_b, const Posed& frame) {
  const Distance<double> d = finished<double>(core, radius_a, radius_b, frame);
  return {static_cast<T>(d.distance), cast<T>(d.normal), cast<T>(d.a), cast<T>(d.b)};
}

}  // namespace graze
