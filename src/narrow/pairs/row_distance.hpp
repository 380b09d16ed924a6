// The distances of a bundle of pairs in closed form: spheres, capsules, balls with boxes, and all of these and
// triangles with half-spaces. Only for `*.kernel.cpp`.
//
// Guarantee: in every lane the bits that the pair gives alone; everything is inlined.
#pragma once

#include "narrow/batch/row_bundle.hpp"
#include "narrow/core/point_box.hpp"
#include "narrow/core/point_point.hpp"
#include "narrow/core/point_segment.hpp"
#include "narrow/core/segment_segment.hpp"
#include "narrow/pairs/closed_form.hpp"
#include "narrow/pairs/half_space_distance.hpp"

namespace graze::GRAZE_ISA {

/// The distance of two shapes in place, in the world.
template <class A, class B, class S>
inline CoreDistance<S> distance_of(const Rounded<A, S>& a, const Pose<S>& pose_a, const Rounded<B, S>& b,
                                   const Pose<S>& pose_b) {
  const auto pair = sphere_capsule_pair(a, pose_a, b, pose_b);
  return pair.in_world(pair.core(pair.nearest()));
}
template <class A, class S>
inline CoreDistance<S> distance_of(const Rounded<A, S>& body, const Pose<S>& pose, const Rounded<PlaneCore, S>& plane,
                                   const Pose<S>& pose_plane) {
  const Distance<S> d = mirrored(
      finished(half_space_distance(body.core, relative(pose_plane, pose)), plane.radius, body.radius, pose_plane));
  return {d.distance, d.normal, d.a, d.b};
}
template <class A, class B, class T>
inline CoreDistance<Lanes<T>> distance_of(const RowBundle<A, B, T>& p) {
  return distance_of(p.a.shapes, p.pose_a, p.b.shapes, p.pose_b);
}

}  // namespace graze::GRAZE_ISA
