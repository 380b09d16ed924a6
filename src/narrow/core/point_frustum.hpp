// Point against cylinder, cone or truncated cone: the nearest point of the surface, with its side, in closed form.
//
// Guarantee: near a face the distance and the normal are the face's own and have all their digits; the normal at an
// edge is that of the line to it, and within the edge's cone of normals.
#pragma once

#include "graze/vec3.hpp"

namespace graze {

/// A truncated cone about Y, whose ends are at -half_height and half_height; a cone where one radius is zero, a
/// cylinder where both are the same. All three may be zero.
struct FrustumCore {
  double half_height, bottom, top;
};

/// The signed distance of a point from a surface, and the outward normal of that.
struct OutwardDistance {
  double distance;
  Vec3d normal;
};

namespace detail {

/// A signed distance and its outward normal in the half-plane of the axis and the point: across and along the axis.
struct ProfileDistance {
  double distance, across, along;
};

/// The distance from an edge, which is `across` and `along` away; `face` holds where that is nothing.
inline ProfileDistance distance_from_edge(double across, double along, const ProfileDistance& face) {
  const double d = length(Vec3d{across, along, 0});
  return d > 0 ? ProfileDistance{d, across / d, along / d} : face;
}

/// The distance of a point at `rho` from the axis and at the height `y`, by the regions of the profile: the caps, the
/// side, and the edges between them.
inline ProfileDistance distance_from_profile(const FrustumCore& core, double rho, double y) {
  const double half = core.half_height;
  // Without a height it is a disc of the larger radius.
  const double bottom = half > 0 ? core.bottom : greatest(core.bottom, core.top), top = half > 0 ? core.top : bottom;
  const double rise = 2 * half, run = top - bottom, slant = length(Vec3d{rise, run, 0});
  // The side is asked from its nearer end: its distance has the digits of the distance from there.
  const bool upper = y > 0;
  const double across = rho - (upper ? top : bottom), along = upper ? y - half : y + half;
  const bool has_side = slant > 0;
  const ProfileDistance side = has_side
                                   ? ProfileDistance{(rise * across - run * along) / slant, rise / slant, -run / slant}
                                   : ProfileDistance{across, 1, 0};
  const double up_side = has_side ? (run * across + rise * along) / slant : along;  // from that end
  const bool beyond_top = up_side >= (upper ? 0 : slant), beyond_bottom = up_side <= (upper ? -slant : 0);

  const ProfileDistance above{y - half, 0, 1}, below{-half - y, 0, -1};
  const ProfileDistance& cap = above.distance >= below.distance ? above : below;
  const bool by_top = cap.along > 0;
  if (cap.distance <= 0 && side.distance <= 0) return side.distance > cap.distance ? side : cap;
  if (cap.distance > 0 && rho <= (by_top ? top : bottom)) return cap;
  if (side.distance > 0 && !beyond_top && !beyond_bottom) return side;
  const bool at_top = beyond_top || (!beyond_bottom && by_top);
  return distance_from_edge(rho - (at_top ? top : bottom), at_top ? y - half : y + half, side);
}

}  // namespace detail

/// The distance of a point from a core, in whose frame it is given. A point inside leaves by the nearest face, one on
/// the axis that leaves by the side does so along X.
inline OutwardDistance distance_from(const FrustumCore& core, const Vec3d& p) {
  const double rho = length(Vec3d{p.x, 0, p.z});
  const detail::ProfileDistance d = detail::distance_from_profile(core, rho, p.y);
  const Vec3d out = rho > 0 ? Vec3d{p.x / rho, 0, p.z / rho} : Vec3d{1, 0, 0};
  return {d.distance, {out.x * d.across, d.along, out.z * d.across}};
}

}  // namespace graze
