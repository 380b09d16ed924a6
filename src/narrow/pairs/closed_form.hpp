// What all closed forms have in common: cores are moved into the frame of A, and the answer for them to the world.
//
// Guarantee: exact operations in the order written, no branches, any lane type.
#pragma once

#include "graze/query.hpp"
#include "narrow/core.hpp"

namespace graze {

template <class S>
PointCore<S> moved(const PointCore<S>& core, const Pose<S>& pose) {
  return {transform(pose, core.point)};
}
template <class S>
SegmentCore<S> moved(const SegmentCore<S>& core, const Pose<S>& pose) {
  return {{transform(pose, core.segment.a), transform(pose, core.segment.b)}};
}

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

}  // namespace graze
