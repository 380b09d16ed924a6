// The space that a shape ever covers while it turns about its body's origin.
//
// Guarantee: no less than the shape covers, but for roundings far below the tolerance of a cast; exact for shapes that
// are round about the axis, such as wheels and tops.
#pragma once

#include "cast/separating_plane_bound.hpp"

namespace graze {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

template <class T>
bool is_half_space(const Piece<T>& piece) {
  return piece.shape.template as<HalfSpace<T>>() != nullptr;
}

/// The unit quaternion that turns the unit vector `axis` to +Y: half way of a half turn about what lies between them.
inline Quatd to_y(const Vec3d& axis) {
  const Vec3d between = unit(axis + Vec3d{0, axis.y < 0 ? -1.0 : 1.0, 0});
  return {between.x, between.y, between.z, 0};  // half a turn swaps the two, up to sign of Y
}

/// The distance from +Y.
inline double from_axis(const Vec3d& p) { return std::sqrt(p.x * p.x + p.z * p.z); }

/// The `turning_radius` of a shape that is round about its own Y: exact when that is the axis.
template <class T>
double round_radius(const Piece<T>& piece, const Posed& upright) {
  return piece.shape.visit([&](const auto& c) {
    if constexpr (requires { c.radius_bottom(); }) {
      const auto h = static_cast<double>(c.half_height());
      return greatest(from_axis(transform(upright, {0, -h, 0})) + static_cast<double>(c.radius_bottom()),
                      from_axis(transform(upright, {0, h, 0})) + static_cast<double>(c.radius_top()));
    } else {
      return infinity;
    }
  });
}

/// The distance from the axis about which its body turns within which all points of a core lie.
template <class T>
double turning_radius(const Piece<T>& piece, const Turning& turning) {
  if (turning.none()) return 0;
  if (is_half_space(piece)) return infinity;
  const Vec3d axis = unit(rotate(conjugate(turning.start), turning.angular));
  const Posed upright = compose(Posed{{}, to_y(axis)}, piece.local);
  const Vec3d far = piece.shape.visit([&](const auto& c) {
    const Aabb<T> box = c.core_bounds(converted<T>(upright));
    return converted<double>(greatest(abs(box.lower), abs(box.upper)));
  });
  constexpr double slack = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());
  return least(piece.core_reach, least(from_axis(far), round_radius(piece, upright)) + slack * piece.core_reach);
}

/// The cylinder about the axis in which all places of a core lie while its body turns; for a body that stands still the
/// core itself.
template <class T>
class Envelope {
 public:
  Envelope(const Piece<T>& piece, const Turning& turning, double radius) : still_(turning.none()), radius_(radius) {
    if (still_) return;
    axis_ = unit(turning.angular);
    const PieceAt<T> at(piece, turning.start);
    top_ = dot(axis_, at.support(axis_));
    bottom_ = dot(axis_, at.support(-axis_));
  }
  /// The extent along a unit vector.
  double along(const Vec3d& n, const PieceAt<T>& now) const {
    if (still_) return dot(n, now.support(n));
    const double up = dot(axis_, n);
    return up * (up > 0 ? top_ : bottom_) + length(n - axis_ * up) * radius_;
  }

 private:
  bool still_;
  Vec3d axis_;
  double radius_, top_ = 0, bottom_ = 0;
};

}  // namespace graze
