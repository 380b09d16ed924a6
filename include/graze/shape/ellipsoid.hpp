// The ellipsoid.
//
// Guarantee: any radii >= 0; a zero one flattens it to an elliptic disc, a segment or a point.
#pragma once

#include "graze/aabb.hpp"
#include "graze/detail/validate.hpp"
#include "graze/pose.hpp"
#include "graze/shape/face.hpp"

namespace graze {

/// An ellipsoid about its origin.
template <class T>
class Ellipsoid {
 public:
  static constexpr const char* name = "ellipsoid";

  /// An ellipsoid with `radii` along the axes, about the origin, each >= 0. Throws `InvalidValue`.
  explicit Ellipsoid(const Vec3<T>& radii) : radii_(validate::resolved(validate::extents(radii, "radii"))) {}

  /// The radii along X, Y and, in space, Z.
  const Vec3<T>& radii() const { return radii_; }

  T core_radius() const { return T(0); }
  T core_extent() const { return max_abs(radii_); }

  /// The image of the unit ball's support point: R (R d) / |R d| for R = diag(radii).
  template <class S>
  Vec3<S> core_support(const Vec3<S>& direction) const {
    const Vec3<S> r = converted<S>(radii_);
    return scaled(r, normalized(scaled(r, direction), Vec3<S>{}));
  }
  void core_face(const Vec3<T>& direction, Face<T>& face) const {
    face.clear();
    face.push(core_support(direction), 0);
  }
  Aabb<T> core_bounds(const Pose<T>& pose) const {
    const Mat3<T> m = rotation_matrix(pose.rotation);
    const Vec3<T> reach{length(scaled(m.row[0], radii_)), length(scaled(m.row[1], radii_)),
                        length(scaled(m.row[2], radii_))};
    return {pose.translation - reach, pose.translation + reach};
  }

 private:
  Vec3<T> radii_;
};

}  // namespace graze
