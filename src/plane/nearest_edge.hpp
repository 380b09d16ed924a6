// The point of the Minkowski difference that is nearest to the origin, given by the edge it lies on.
//
// Guarantee: the answer is computed from the vertices of that edge alone, so that every way to find the edge gives the
// same bits.
#pragma once

#include <limits>

#include "plane/difference.hpp"
#include "plane/nearest.hpp"

namespace graze::plane {

struct NearestEdge {
  DifferenceEdge edge{};
  double parameter = 0;                                      ///< of the nearest point on it, from 0 to 1
  double squared = std::numeric_limits<double>::infinity();  ///< distance of that point
};

inline double parameter_on(const DifferenceEdge& e) {
  const double l2 = length_squared(e.edge);
  return l2 > 0 ? clamp(-dot(e.start, e.edge) / l2, 0.0, 1.0) : 0.0;
}

/// The point between two at a parameter, from the nearer end, so that both ends come out to the last bit. A branch on
/// which end that is would be mispredicted often: both points are computed, which takes less time.
inline Vec2d point_between(const Vec2d& start, const Vec2d& end, const Vec2d& edge, double t) {
  const Vec2d from[2] = {start + edge * t, end - edge * (1 - t)};
  return from[t <= 0.5 ? 0 : 1];
}
inline Vec2d point_on(const DifferenceEdge& e, double t) { return point_between(e.start, e.start + e.edge, e.edge, t); }

/// The point of an edge that is nearest to the origin.
inline NearestEdge nearest_on(const DifferenceEdge& e) {
  const double t = parameter_on(e);
  return {e, t, length_squared(point_on(e, t))};
}

/// The relative difference of two squares of one distance by rounding: two products, a sum, and differences before.
inline constexpr double same_square = 32 * std::numeric_limits<double>::epsilon();

/// Whether an edge has a nearer point than another. A foot within an edge goes before an end that is as far up to
/// rounding: where the foot is near that end, squares of distances tell the two apart by half of their digits only, and
/// a normal from the end would be off by as much.
inline bool nearer(const NearestEdge& e, const NearestEdge& than) {
  const auto inner = [](const NearestEdge& edge) { return edge.parameter > 0 && edge.parameter < 1; };
  const bool same = e.squared <= than.squared * (1 + same_square) && than.squared <= e.squared * (1 + same_square);
  if (same && inner(e) != inner(than)) return inner(e);
  return e.squared < than.squared;
}

/// The height of the origin below an edge, seen from inside.
inline double height_below(const DifferenceEdge& e) { return cross(e.start, e.edge) / length(e.edge); }

/// The points of A and B that the point of the difference at parameter `t` is made of.
template <class T>
void take_points(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const DifferenceEdge& e, double t,
                 Nearest& out) {
  const std::uint32_t edges_end = e.of_a ? a.next(e.i) : b.next(e.j);
  const auto at = [&](const auto& core, std::uint32_t from) {
    const Vec2d p = core.vertex(from), q = core.vertex(edges_end);
    return point_between(p, q, q - p, t);
  };
  const auto feature = [&](std::uint32_t from) {
    return t <= 0 ? vertex_feature(from) : t >= 1 ? vertex_feature(edges_end) : side_feature(from);
  };
  if (e.of_a) {
    out.a.point = at(a, e.i), out.a.feature = feature(e.i);
    out.b.point = b.vertex(e.j), out.b.feature = vertex_feature(e.j);
  } else {
    out.a.point = a.vertex(e.i), out.a.feature = vertex_feature(e.i);
    out.b.point = at(b, e.j), out.b.feature = feature(e.j);
  }
  out.b.point = transform(b_in_a, out.b.point);
}

/// Fills the answer of an origin outside: towards the nearest point of the difference.
template <class T>
void take_apart(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const NearestEdge& best, Nearest& out) {
  const Vec2d to = point_on(best.edge, best.parameter), outward = normalized(right(best.edge.edge));
  const bool inner = best.parameter > 0 && best.parameter < 1;
  const double sizes = max_abs(a.vertex(best.edge.i)) + max_abs(b.vertex(best.edge.j)) + max_abs(b_in_a.translation);
  // The edge's own normal on an edge, where it keeps its digits when the gap has few, and also where corners touch up
  // to rounding, since the way between them has no direction.
  const bool touches = best.squared <= touching_rounding * touching_rounding * (sizes * sizes);
  out.normal = inner || touches ? outward : normalized(-to, outward);
  out.distance = inner ? greatest(-dot(to, outward), 0.0) : length(to);
  take_points(a, b, b_in_a, best.edge, best.parameter, out);
}

/// Fills the answer of an origin inside: out through the edge that it lies least deep below.
template <class T>
void take_overlap(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const DifferenceEdge& e, double parameter,
                  double depth, Nearest& out) {
  out.normal = normalized(right(e.edge));
  out.distance = -depth;
  take_points(a, b, b_in_a, e, parameter, out);
}

}  // namespace graze::plane
