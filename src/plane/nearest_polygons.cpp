// Two polygons: one walk around their Minkowski difference. Where the origin lies outside, the nearest point lies on an
// edge that the origin sees; inside, the nearest edge's normal is the axis of least overlap, and no search is needed.
#include <limits>

#include "plane/difference.hpp"
#include "plane/nearest.hpp"

namespace graze::plane {

namespace {

struct NearestEdge {
  DifferenceEdge edge{};
  double parameter = 0;                                      ///< of the nearest point on it, from 0 to 1
  double squared = std::numeric_limits<double>::infinity();  ///< distance of that point
};

double parameter_on(const DifferenceEdge& e) {
  const double l2 = length_squared(e.edge);
  return l2 > 0 ? clamp(-dot(e.start, e.edge) / l2, 0.0, 1.0) : 0.0;
}

/// From the nearer end, so that both ends come out to the last bit.
Vec2d point_on(const DifferenceEdge& e, double t) {
  return t <= 0.5 ? e.start + e.edge * t : (e.start + e.edge) - e.edge * (1 - t);
}

void offer(NearestEdge& best, const DifferenceEdge& e) {
  const double t = parameter_on(e), squared = length_squared(point_on(e, t));
  if (squared < best.squared) best = {e, t, squared};
}

/// The points of A and B that the point of the difference at parameter `t` is made of.
template <class T>
void take_points(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const DifferenceEdge& e, double t,
                 Nearest& out) {
  const std::uint32_t edges_end = e.of_a ? a.next(e.i) : b.next(e.j);
  const auto at = [&](const auto& core, std::uint32_t from) {
    const Vec2d p = core.vertex(from), q = core.vertex(edges_end);
    return t <= 0.5 ? p + (q - p) * t : q - (q - p) * (1 - t);
  };
  const auto feature = [&](std::uint32_t from) {
    return t <= 0 ? vertex_feature(from) : t >= 1 ? vertex_feature(edges_end) : side_feature(from);
  };
  out.a = e.of_a ? CorePoint{at(a, e.i), feature(e.i)} : CorePoint{a.vertex(e.i), vertex_feature(e.i)};
  out.b = e.of_a ? CorePoint{b.vertex(e.j), vertex_feature(e.j)} : CorePoint{at(b, e.j), feature(e.j)};
  out.b.point = transform(b_in_a, out.b.point);
}

/// Where the origin is outside: towards the nearest point of the difference.
template <class T>
Nearest apart(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const NearestEdge& best) {
  Nearest out;
  const Vec2d to = point_on(best.edge, best.parameter), outward = normalized(right(best.edge.edge));
  const bool inner = best.parameter > 0 && best.parameter < 1;
  // On an edge its own normal, which keeps its digits when the gap has few.
  out.normal = inner && dot(to, outward) < 0 ? outward : normalized(-to, outward);
  out.distance = inner ? -dot(to, out.normal) : length(to);
  take_points(a, b, b_in_a, best.edge, best.parameter, out);
  return out;
}

}  // namespace

template <class T>
Nearest nearest_polygons(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a) {
  if (a.count == 1 && b.count == 1) {
    Nearest out;
    out.a = {a.vertex(0), vertex_feature(0)};
    out.b = {transform(b_in_a, b.vertex(0)), vertex_feature(0)};
    const Vec2d between = out.b.point - out.a.point;
    out.normal = normalized(between);
    out.distance = length(between);
    return out;
  }
  NearestEdge seen;
  DifferenceEdge shallowest{};
  double depth = std::numeric_limits<double>::infinity();
  for_each_difference_edge(a, b, b_in_a, [&](const DifferenceEdge& e) {
    const double l = length(e.edge);
    if (!(l > 0)) return;
    const double height = cross(e.start, e.edge) / l;  // of the origin below this edge
    if (height < 0) offer(seen, e);
    if (height < depth) depth = height, shallowest = e;
  });
  if (depth < 0) return apart(a, b, b_in_a, seen);
  const bool pointlike = depth == std::numeric_limits<double>::infinity();
  const double allowed = 4 * depth * depth;
  // Inside a polygon the foot on the nearest edge's line lies on that edge, or on one in line with it.
  if (pointlike || length_squared(point_on(shallowest, parameter_on(shallowest))) > allowed) {
    NearestEdge any;
    for_each_difference_edge(a, b, b_in_a, [&](const DifferenceEdge& e) {
      if (pointlike || !detail::is_zero(e.edge)) offer(any, e);
    });
    // No edge has it: the difference has no inside (segments on one line, points upon each other).
    if (any.squared > 0 && (pointlike || any.squared > allowed)) return apart(a, b, b_in_a, any);
    shallowest = any.edge;
    if (pointlike) depth = 0;
  }
  Nearest out;
  out.normal = normalized(right(shallowest.edge));
  out.distance = -depth;
  take_points(a, b, b_in_a, shallowest, parameter_on(shallowest), out);
  return out;
}

template Nearest nearest_polygons(const Core<float>&, const Core<float>&, const Pose2d&);
template Nearest nearest_polygons(const Core<double>&, const Core<double>&, const Pose2d&);

}  // namespace graze::plane
