// The first contact of two polygons, rounded or not, of which one moves along a line: a ray against their Minkowski
// difference.
//
// Guarantee: exact up to the rounding of doubles, at any speed and size. Inlined, so that vectors stay in registers.
#pragma once

#include <optional>

#include "plane/difference.hpp"
#include "plane/entry_axes.hpp"
#include "plane/first_contact.hpp"
#include "plane/outline_hit.hpp"

namespace graze::plane {

/// The first hits along a unit vector on the difference of polygons that do not overlap.
template <class T>
[[gnu::always_inline]] inline DifferenceHit meet_polygons(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a,
                                                          const Vec2d& direction, double size) {
  const double radius = a.radius + b.radius;
  DifferenceHit hit;
  const auto disc = [&](const Vec2d& center, std::uint32_t i) {
    if (meet_disc(center, radius, direction, hit.on_disc)) hit.vertex_a = i;
  };
  if (a.count == 1 && b.count == 1) {
    disc(a.vertex(0) - transform(b_in_a, b.vertex(0)), 0);
    return hit;
  }
  // Beside a single vertex the walk has no order to find and is faster.
  if (least(a.count, b.count) > 1 && entry_by_axes(a, b, b_in_a, direction, size, hit)) return hit;
  hit = {};
  for_each_difference_edge(a, b, b_in_a, [&](const DifferenceEdge& e) {
    if (meet_edge(e.start, e.edge, radius, direction, hit.on_edge)) hit.edge = e;
    if (radius > 0) disc(e.start, e.i);
  });
  // The points of an outline without rounding count where no edge does: where it is seen end on.
  if (radius == 0 && hit.on_edge.t == never)
    for_each_difference_edge(a, b, b_in_a, [&](const DifferenceEdge& e) { disc(e.start, e.i); });
  return hit;
}

/// The point of A's core at a hit.
template <class T>
[[gnu::always_inline]] inline Vec2d point_of_a(const Core<T>& a, const DifferenceHit& hit, const Vec2d& direction) {
  if (hit.on_disc.t < hit.on_edge.t) return a.vertex(hit.vertex_a);
  const DifferenceEdge& e = hit.edge;
  if (!e.of_a) return a.vertex(e.i);
  const double along = dot(direction * hit.on_edge.t - e.start, e.edge) / length_squared(e.edge);
  return a.vertex(e.i) + a.edge(e.i) * clamp(along, 0.0, 1.0);
}

/// The first contact, at a time in [0, duration], of polygons that are apart at the start, while B moves by `velocity`
/// in A's frame.
template <class T>
[[gnu::always_inline]] inline std::optional<FirstContact> straight_contact(const Core<T>& a, const Core<T>& b,
                                                                           const Pose2d& b_in_a, const Vec2d& velocity,
                                                                           double duration, double size) {
  const double speed = length(velocity);
  if (!(speed > 0)) return {};
  const Vec2d direction = unit_vector(velocity, {});
  const DifferenceHit hit = meet_polygons(a, b, b_in_a, direction, size);
  const OutlineHit& first = hit.on_disc.t < hit.on_edge.t ? hit.on_disc : hit.on_edge;
  const double t = first.t / speed;
  // A path without end that meets nothing does so at no time, and not at the last.
  if (!(t <= duration) || first.t == never) return {};
  return FirstContact{t, first.normal, point_of_a(a, hit, direction) + first.normal * a.radius};
}

}  // namespace graze::plane
