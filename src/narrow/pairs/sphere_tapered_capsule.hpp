// Point against the hull of two balls: sphere against tapered capsule.
//
// Guarantee: exact up to rounding, inside and out, for spheres without size too.
#pragma once

#include <optional>

#include "narrow/pairs/closed_form.hpp"

namespace graze {

/// The signed distance of a point from the hull of two balls along Y, in the half-plane through the axis, and its
/// outward normal there. The hull's support along a unit vector n is the larger of the two balls', so the distance is
/// the smaller of n.(p - center) - radius over both balls, at the n for which that is largest: along the way from the
/// centre of a ball where that ball reaches further, and else along the side's normal, where both reach equally far.
struct RoundConeDistance {
  double distance;
  double across, along;  ///< the normal: away from the axis, and along it
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

/// Of a tapered capsule only: even ones have a closed form for lanes.
template <class T>
std::optional<Distance<T>> own_distance(const Sphere<T>& sphere, T margin_sphere, const Pose<T>& pose_sphere,
                                        const Capsule<T>& capsule, T margin_capsule, const Pose<T>& pose_capsule) {
  if (!capsule.tapered()) return std::nullopt;
  const Posed frame = in_double(pose_capsule), of_sphere = in_double(pose_sphere);
  const Posed seen = relative(frame, of_sphere);
  const Vec3d p = transform(seen, converted<double>(sphere.center()));
  const double half_height = static_cast<double>(capsule.half_height()), margin = static_cast<double>(margin_capsule),
               bottom = static_cast<double>(capsule.radius_bottom()) + margin,
               top = static_cast<double>(capsule.radius_top()) + margin,
               radius = static_cast<double>(rounding_radius(sphere, margin_sphere));
  const double across = std::sqrt(p.x * p.x + p.z * p.z);
  const RoundConeDistance at = round_cone_distance(half_height, bottom, top, across, p.y);
  const Vec3d beside = across > 0 ? Vec3d{p.x / across, 0, p.z / across} : Vec3d{1, 0, 0};
  const Vec3d outward{beside.x * at.across, at.along, beside.z * at.across};
  // A distance that rounding cannot tell from none is none: they touch.
  const double extent = half_height + greatest(bottom, top),
               noise = rounding_error * (greatest(extent, radius) + max_abs(p));
  const double from_center = std::abs(at.distance - radius) <= noise ? radius : at.distance;
  const CoreDistance<double> core{from_center, outward, p - outward * from_center, p};
  return mirrored(finished_in_double(core, T(0), static_cast<T>(radius), frame));
}

}  // namespace graze
