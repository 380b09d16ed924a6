// A first look at the pieces of a surface and a convex shape: may they come within a limit?
//
// Guarantee: says no only where the signed distance exceeds the limit; rounding is allowed for. Of a triangle it costs
// some sixty products and one point of the shape, where the pair's own routine costs hundreds of nanoseconds.
#pragma once

#include "composite/triangle_pair.hpp"
#include "graze/mat3.hpp"
#include "graze/shape.hpp"

namespace graze {

/// A question about boxes, as any hierarchy takes, and then about the triangles in those that pass.
template <class T>
class NearConvex : public BoxQuestion<T> {
 public:
  /// A bounded shape where it stands in the surface's frame. `slack`: what the coordinates of both may be off by.
  NearConvex(const Shape<T>& shape, const Pose<T>& pose, T slack)
      : BoxQuestion<T>{inflated(bounds(shape, pose), slack)},
        shape_(shape),
        own_(bounds(shape, Pose<T>{})),
        rotation_(rotation_matrix(pose.rotation)),
        translation_(pose.translation),
        slack_(slack) {}

  /// Whether a triangle may come within `limit`: along the axes of the shape's own frame, and along its normal.
  bool may_reach(const Corners<T>& corners, const T& limit) const {
    Corners<T> own;
    for (std::size_t i = 0; i < 3; ++i) own[i] = transposed_times(rotation_, corners[i] - translation_);
    if (BoxQuestion<T>{own_}(bounds_of(own)) > signed_square(limit + slack_)) return false;
    const Vec3<T> u = own[1] - own[0], v = own[2] - own[0], n = cross(u, v);
    const Vec3<T> away = dot(n, own_.center() - own[0]) < T(0) ? -n : n, nearest = support(shape_, -away) - own[0];
    return !is_off_plane(u, v, n, dot(away, nearest), max_abs(nearest), limit + slack_);
  }

 private:
  const Shape<T>& shape_;
  Aabb<T> own_;  ///< bounds in the shape's own frame
  Mat3<T> rotation_;
  Vec3<T> translation_;
  T slack_;
};

}  // namespace graze
