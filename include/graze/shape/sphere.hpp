// The ball.
//
// Guarantee: sixteen bytes in `float`. The core is the centre, so every query against a ball is one against a point.
#pragma once

#include "graze/aabb.hpp"
#include "graze/detail/validate.hpp"
#include "graze/pose.hpp"
#include "graze/shape/face.hpp"

namespace graze {

/// A ball.
template <class T>
class Sphere {
 public:
  static constexpr const char* name = "sphere";

  /// A ball of `radius` >= 0 about `center` (in the shape's frame). Throws `InvalidValue`.
  explicit Sphere(T radius, const Vec3<T>& center = {})
      : center_(validate::vertex(center, "center")), radius_(validate::size(radius, "radius")) {}

  /// The radius.
  T radius() const { return radius_; }
  /// The centre, in the shape's frame.
  const Vec3<T>& center() const { return center_; }

  T core_radius() const { return radius_; }
  T core_extent() const { return length(center_); }
  template <class S>
  Vec3<S> core_support(const Vec3<S>&) const {
    return converted<S>(center_);
  }
  void core_face(const Vec3<T>&, Face<T>& face) const {
    face.clear();
    face.push(center_, 0);
  }
  Aabb<T> core_bounds(const Pose<T>& pose) const {
    const Vec3<T> c = transform(pose, center_);
    return {c, c};
  }

 private:
  Vec3<T> center_;
  T radius_;
};

static_assert(sizeof(Sphere<float>) == 16);

}  // namespace graze
