// Even capsule against triangle: an end of the capsule, or its side across an edge of the triangle, in double.
//
// Guarantee: an answer is given only with its proof, a plane between the cores as far from both as it says. `distance`,
// `overlap` and `contacts` take theirs from here, so that they agree on what touches. Where the cores meet or about do,
// and of slivers, the general path answers; so it does for the contacts of the capsule's side, which may be two.
#pragma once

#include "narrow/pairs/sphere_triangle.hpp"

namespace graze {

template <class T>
class CapsuleAndTriangle {
 public:
  CapsuleAndTriangle(const Capsule<T>& capsule, T margin, const Pose<T>& pose, const Triangle<T>& triangle,
                     T margin_triangle, const Pose<T>& pose_triangle)
      : pair_(rounding_radius(capsule, margin), static_cast<double>(capsule.core_extent()), pose, triangle,
              margin_triangle, pose_triangle) {
    if (!has_even_side(capsule) || pair_.triangle.thin()) return;
    axis_ = rotation_of(cast<double>(pose.rotation)).column(1);
    half_ = static_cast<double>(capsule.half_height());
    if (!take_end(-1) && !take_end(1)) take_side();
  }

  bool known() const { return near_.has_value(); }
  /// Only where it is known, as what follows.
  Distance<T> distance() const { return pair_.in_world(axis_ * along_, *near_); }
  /// That of an end which the general path sees alone.
  bool one_point() const { return std::abs(dot(axis_, pair_.turn * near_->outward)) > face_lean<double>; }
  std::uint32_t feature() const {
    const bool top = dot(axis_, pair_.turn * near_->outward) < 0;
    return feature_id(vertex_feature(top ? 1 : 0), pair_.triangle.feature(near_->place, near_->outward));
  }

 private:
  /// An end from whose place on the triangle the rest of the capsule leads further away is what is nearest.
  bool take_end(double sign) {
    const Vec3d end = axis_ * (half_ * sign);
    const auto found = pair_.nearest_to(end);
    if (!found || dot(axis_, pair_.turn * found->outward) * sign > 0) return false;
    near_ = found;
    along_ = half_ * sign;
    return true;
  }
  void take_side() {
    const Segment<double> side{pair_.seen_by_triangle(axis_ * -half_), pair_.seen_by_triangle(axis_ * half_)};
    const auto found = pair_.triangle.nearest_across(side, pair_.noise);
    if (!found) return;
    near_ = found->at;
    along_ = half_ * (2 * found->along - 1);
  }

  RoundAndTriangle<T> pair_;
  Vec3d axis_{};
  double half_ = 0, along_ = 0;  ///< along: where on the axis it is nearest
  std::optional<NearTriangle> near_{};
};

template <class T>
std::optional<Distance<T>> own_distance(const Capsule<T>& capsule, T margin, const Pose<T>& pose,
                                        const Triangle<T>& triangle, T margin_triangle, const Pose<T>& pose_triangle) {
  return distance_of<T>(CapsuleAndTriangle<T>(capsule, margin, pose, triangle, margin_triangle, pose_triangle));
}

template <class T>
std::optional<T> own_contacts(const Capsule<T>& capsule, T margin_capsule, const Pose<T>& pose,
                              const Triangle<T>& triangle, T margin_triangle, const Pose<T>& pose_triangle, T margin,
                              Manifold<T>& manifold) {
  return contact_of<T>(CapsuleAndTriangle<T>(capsule, margin_capsule, pose, triangle, margin_triangle, pose_triangle),
                       margin, manifold);
}

}  // namespace graze
