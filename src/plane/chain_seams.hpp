// The vertices at which a segment of a chain goes on in others.
//
// Guarantee: a line across a normal that leads over such a vertex cuts the segment beyond it, and so separates nothing
// from the chain, whatever it does to the one segment. A body that is thin along such a normal would else slide through
// the chain between two segments, each of which it leaves to one side (`cast/surface_seams.hpp` in space).
#pragma once

#include "plane/advance.hpp"

namespace graze::plane {

/// The sine from which on a normal leads over a vertex. Vertices rounded to float turn a segment by some
/// ten-millionths.
inline constexpr double over_vertex = 1e-6;

/// Whether a unit vector in a segment's frame leads over its end into the next segment of its chain.
template <class T>
bool leads_over_seam(const Core<T>& segment, const Vec2d& n) {
  if (!segment.chain) return false;
  const Vec2d along = normalized(segment.edge(0));
  const OutlineVertex &start = segment.outline[0], &end = segment.outline[1];
  const auto over = [&](const Vec2d& outward, const Vec2d& beyond) {
    return dot(n, outward) > over_vertex && dot(n, beyond) > over_vertex;
  };
  return (start.kind != OutlineVertex::Kind::first && over(-along, -start.arriving)) ||
         (end.kind != OutlineVertex::Kind::last && over(along, end.leaving));
}

/// Replaces a normal that leads over a seam of a chain, along which pieces touch, by that of the segment, on the side
/// on which the middle of the other piece is. `near`: the gap that counts as touching.
template <class T>
void keep_off_seams(const Mover<T>& a, const Mover<T>& b, double near, Nearby& now) {
  if (now.gap > near) return;
  const Vec2d n = now.contact.normal;
  const bool of_a = leads_over_seam(a.core, inverse_rotate(now.pose_a.rotation, n));
  if (!of_a && !leads_over_seam(b.core, inverse_rotate(now.pose_b.rotation, -n))) return;
  const Mover<T>&chain = of_a ? a : b, &other = of_a ? b : a;
  if (other.core.kind == CoreKind::half_plane) return;
  const Pose2d &at = of_a ? now.pose_a : now.pose_b, &pose = of_a ? now.pose_b : now.pose_a;
  const Vec2d on_line = transform(at, chain.core.vertex(0));
  const auto furthest = [&](const Vec2d& d) { return support(other.core, inverse_rotate(pose.rotation, d)); };
  const auto height = [&](const Vec2d& d) { return dot(transform(pose, furthest(d).point) - on_line, d); };
  Vec2d up = rotate(at.rotation, normalized(right(chain.core.edge(0))));
  if (height(up) < height(-up)) up = -up;
  const CorePoint lowest = furthest(-up);
  now.gap = -height(-up) - a.core.radius - b.core.radius;
  now.contact.normal = of_a ? up : -up;
  now.axis_of_b = !of_a;
  (of_a ? now.vertex_b : now.vertex_a) = vertex_of(other.core, lowest.feature);
  now.on_a = of_a ? on_line + up * a.core.radius : transform(pose, lowest.point) - up * a.core.radius;
}

}  // namespace graze::plane
