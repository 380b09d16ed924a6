// Sphere against capsule: a point against a segment, or against the hull of two balls for a tapered capsule.
//
// Guarantee: exact up to rounding, inside and out, also for spheres of zero radius.
#pragma once

#include <optional>

#include "narrow/pairs/one_contact_pair.hpp"

namespace graze {

/// The signed distance of a point from the hull of two balls along Y, in the half-plane through the axis, and its
/// outward normal there. The support function of the hull along a unit vector n is the larger of the two balls', so the
/// distance is the smaller of n.(p - center) - radius over both balls, at the n for which that is largest: along the
/// line from the centre of a ball where that ball reaches further, and else along the side's normal, where both reach
/// equally far.
struct RoundConeDistance {
  double distance;
  double across, along;  ///< the normal: components away from the axis, and along it
};
inline RoundConeDistance round_cone_distance(double half_height, double bottom, double top, double across,
                                             double along) {
  const auto from_ball = [&](double radius, double y) -> RoundConeDistance {
    const double d = std::sqrt(across * across + y * y);
    if (!(d > 0)) return {-radius, 1, 0};
    return {d - radius, across / d, y / d};
  };
  const double height = 2 * half_height, taper = bottom - top, above_bottom = along + half_height,
               above_top = along - half_height;
  if (taper >= height) return from_ball(bottom, above_bottom);  // one ball holds the other
  if (-taper >= height) return from_ball(top, above_top);
  const double sine = taper / height, cosine = std::sqrt((1 - sine) * (1 + sine));
  if (cosine * above_bottom < sine * across) return from_ball(bottom, above_bottom);
  if (cosine * above_top > sine * across) return from_ball(top, above_top);
  return {cosine * across + sine * above_bottom - bottom, cosine, sine};
}

/// Sphere against capsule, tapered capsules included.
struct SphereCapsule : OneContactPair<Sphere, Capsule> {
  template <class T>
  static std::optional<Distance<T>> distance(const InPlace<Sphere<T>, T>& sphere,
                                             const InPlace<Capsule<T>, T>& capsule) {
    if (!capsule.shape.tapered()) return OneContactPair::distance(sphere, capsule);
    return tapered_distance(sphere, capsule);
  }

 private:
  template <class T>
  static Distance<T> tapered_distance(const InPlace<Sphere<T>, T>& sphere, const InPlace<Capsule<T>, T>& capsule) {
    const Posed frame = in_double(capsule.pose), of_sphere = in_double(sphere.pose);
    const Posed seen = relative(frame, of_sphere);
    const Vec3d p = transform(seen, converted<double>(sphere.shape.center()));
    const double half_height = static_cast<double>(capsule.shape.half_height()),
                 rounding = static_cast<double>(capsule.rounding()),
                 bottom = static_cast<double>(capsule.shape.radius_bottom()) + rounding,
                 top = static_cast<double>(capsule.shape.radius_top()) + rounding,
                 radius = static_cast<double>(sphere.radius());
    const double across = std::sqrt(p.x * p.x + p.z * p.z);
    const RoundConeDistance at = round_cone_distance(half_height, bottom, top, across, p.y);
    const Vec3d beside = across > 0 ? Vec3d{p.x / across, 0, p.z / across} : Vec3d{1, 0, 0};
    const Vec3d outward{beside.x * at.across, at.along, beside.z * at.across};
    // A distance within rounding of zero is zero: the two touch.
    const double extent = half_height + greatest(bottom, top),
                 noise = rounding_error * (greatest(extent, radius) + max_abs(p));
    const double from_center = std::abs(at.distance - radius) <= noise ? radius : at.distance;
    const CoreDistance<double> core{from_center, outward, p - outward * from_center, p};
    return mirrored(finished_in_double(core, T(0), static_cast<T>(radius), frame));
  }
};

}  // namespace graze
