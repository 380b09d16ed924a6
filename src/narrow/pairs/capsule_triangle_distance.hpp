// Untapered capsule against triangle: an end of the capsule, or its side across an edge of the triangle, across lanes,
// in double.
//
// Guarantee: an answer is known only with its proof, a plane that separates the cores by the distance found.
// `distance`, `overlap` and `contacts` share this answer, so that they agree on touching, for one pair and for many.
// The general path answers for slivers and where the cores about meet.
#pragma once

#include "narrow/pairs/sphere_triangle_distance.hpp"

namespace graze {

/// The closest points of an untapered capsule and a triangle. Results are meaningful only where they are known.
template <class S>
class CapsuleAndTriangle {
  using Mask = decltype(S() < S());

 public:
  CapsuleAndTriangle(const Rounded<AxisCore<S>, S>& capsule, const Pose<S>& pose,
                     const Rounded<TriangleCore<S>, S>& triangle, const Pose<S>& pose_triangle)
      : pair_(capsule.radius, capsule.core.half_height, pose, triangle, pose_triangle),
        half_(capsule.core.half_height) {
    const Mask regular = pair_.triangle.regular();
    if (!any(regular)) return;
    axis_ = rotation_of(pose.rotation).column(1);
    take(at_end(S(-1)));
    if (!all(near_.known)) take(at_end(S(1)));
    if (!all(near_.known)) take(at_side());
    near_.known = near_.known & regular;
  }

  Mask known() const { return near_.known; }
  CoreDistance<S> distance() const { return pair_.in_world(axis_ * along_, near_); }
  /// Whether the two touch in one point at most: at an end of the capsule, where the general path finds one point too.
  Mask one_point() const {
    using std::abs;
    return abs(rise_of(near_)) > S(face_lean<double>);
  }
  /// The parts of the capsule and of the triangle that touch.
  S part() const { return select(rise_of(near_) < S(0), S(1), S(0)); }
  S triangle_part() const { return pair_.triangle.part(near_.place, near_.outward); }

 private:
  /// A candidate for the nearest point of the axis.
  struct Place {
    S along;
    NearTriangle<S> near;
  };

  /// The slope of the axis over the triangle.
  S rise_of(const NearTriangle<S>& near) const { return dot(axis_, pair_.turn * near.outward); }
  /// An end is nearest where the rest of the capsule leads away from its nearest point on the triangle.
  Place at_end(const S& sign) const {
    const S along = half_ * sign;
    NearTriangle<S> near = pair_.nearest_to(axis_ * along);
    near.known = near.known & (rise_of(near) * sign <= S(0));
    return {along, near};
  }
  Place at_side() const {
    const SegmentNearTriangle<S> found = pair_.triangle.nearest_across(
        pair_.seen_by_triangle(axis_ * -half_), transposed_times(pair_.turn, axis_ * (S(2) * half_)), pair_.noise);
    return {half_ * (S(2) * found.along - S(1)), found.at};
  }
  /// Takes a candidate for the pairs that are not known yet.
  void take(const Place& place) {
    const Mask before = near_.known;
    near_ = select(before, near_, place.near);
    along_ = select(before, along_, place.along);
  }

  SphereCapsuleAndTriangle<S> pair_;
  S half_, along_{};  ///< `along_`: position on the axis of the nearest point
  Vec3<S> axis_{};
  NearTriangle<S> near_{};
};

template <class T>
CapsuleAndTriangle<double> with_triangle(const Capsule<T>& capsule, T margin, const Pose<T>& pose,
                                         const Triangle<T>& triangle, T margin_triangle, const Pose<T>& pose_triangle) {
  const auto of = rounded_core(capsule, margin);
  return {{{static_cast<double>(of.core.half_height)}, static_cast<double>(of.radius)},
          converted<double>(pose),
          rounded_in_double(triangle, margin_triangle),
          converted<double>(pose_triangle)};
}

}  // namespace graze
