// The first hit of a ray on a rounded outline, piece by piece: its edges moved outward, and the discs about its
// vertices.
#pragma once

#include <cmath>
#include <limits>

#include "plane/unit_rotation.hpp"

namespace graze::plane {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// A ray from the origin, with a unit direction, against a rounded outline: the first of its pieces.
struct OutlineHit {
  double t = never;
  Vec2d normal{};
};

/// Whether a point surely lies further than `radius` above the line of an edge: `start` and `edge` seen from that
/// point. The test leaves room for rounding, so that a point nearer to the line is left to a measurement.
inline bool surely_above(const Vec2d& start, const Vec2d& edge, double radius) {
  const double above = -dot(right(edge), start);
  return above > 0 && above * above * (1 - 0x1p-40) > radius * radius * length_squared(edge);
}

/// A bound for the error of a vertex's place beside a ray, relative to the numbers it is made of, and for that of the
/// end of an edge in `meet_edge`: both are a few units of rounding, and this is far more, since no answer comes of it.
inline constexpr double beside_rounding = 0x1p-40;

/// Whether a ray from the origin may pass between the ends of an edge that it sees from the front, from the left of the
/// ray, looking along it, to its right: both ends moved by no more than `radius`.
inline bool may_pass(const Vec2d& start, const Vec2d& edge, double radius, const Vec2d& direction) {
  const double slack = radius + beside_rounding * (max_abs(start) + max_abs(edge) + radius);
  return cross(direction, start) >= -slack && cross(direction, start + edge) <= slack;
}

/// Whether an edge moved outward by `radius` is met before `best`, which it then becomes, and from its front. Its ends
/// are met within the rounding of the path: a ray through the vertex of two edges meets one of them.
inline bool meet_edge(const Vec2d& start, const Vec2d& edge, double radius, const Vec2d& direction, OutlineHit& best) {
  // An edge seen from behind needs no root.
  if (!(dot(right(edge), direction) < 0)) return false;
  if (!may_pass(start, edge, radius, direction)) return false;
  const double l = length(edge);
  const Vec2d along = edge / l, n = right(along);
  const double toward = -dot(n, direction), above = -dot(n, start) - radius;
  if (!(toward > 0) || above < 0) return false;
  const double t = above / toward;
  if (!(t < best.t)) return false;
  const double at = dot(direction * t - start, along);
  const double slack = 8 * std::numeric_limits<double>::epsilon() * (t + length(start) + l + radius);
  if (!(at >= -slack && at <= l + slack)) return false;
  best = {t, n};
  return true;
}

/// Whether the disc about a vertex is met before `best`, which it then becomes. A disc of no radius is met within the
/// rounding of the path.
inline bool meet_disc(const Vec2d& center, double radius, const Vec2d& direction, OutlineHit& best) {
  const double along = dot(center, direction), across = cross(direction, center);
  const double reach = radius > 0 ? radius : 8 * std::numeric_limits<double>::epsilon() * length(center);
  const double under = (reach - across) * (reach + across);
  if (!(along >= 0) || !(under >= 0)) return false;
  const double t = radius > 0 ? along - std::sqrt(under) : along;
  if (!(t < best.t)) return false;
  best = {greatest(t, 0.0), unit_vector(direction * t - center, -direction)};
  return true;
}

}  // namespace graze::plane
