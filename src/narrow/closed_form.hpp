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
template <class S>
struct BallCores {
  PointCore<S> a, b;
  Vec3<S> origin;  ///< of that frame, in the world

  BallCores(const Vec3<S>& center_a, const Pose<S>& pose_a, const Vec3<S>& center_b, const Pose<S>& pose_b)
      : a{turned(center_a, pose_a)},
        b{pose_b.translation - pose_a.translation + turned(center_b, pose_b)},
        origin(pose_a.translation) {}

  /// Adds the radii and moves the answer to the world.
  Distance<S> distance(const CoreDistance<S>& core, const S& radius_a, const S& radius_b) const {
    Distance<S> d;
    d.distance = core.distance - (radius_a + radius_b);
    d.normal = core.normal;
    d.a = origin + (core.a + core.normal * radius_a);
    d.b = origin + (core.b - core.normal * radius_b);
    return d;
  }

 private:
  /// The same bits without the question, which pays for a scalar alone.
  static Vec3<S> turned(const Vec3<S>& center, const Pose<S>& pose) {
    if constexpr (std::is_floating_point_v<S>)
      if (center == Vec3<S>{}) return {};
    return rotate(pose.rotation, center);
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

template <class T>
Distance<T> mirrored(Distance<T> d) {
  d.normal = -d.normal;
  std::swap(d.a, d.b);
  return d;
}

/// The same for what was computed in double: only the answer is rounded to T.
template <class T>
Distance<T> finished_in_double(const CoreDistance<double>& core, T radius_a, T radius_b, const Posed& frame) {
  const Distance<double> d = finished<double>(core, radius_a, radius_b, frame);
  return {static_cast<T>(d.distance), cast<T>(d.normal), cast<T>(d.a), cast<T>(d.b)};
}

}  // namespace graze
