// Two polygons: one walk around their Minkowski difference. Where the origin lies outside, the nearest point lies on an
// edge that the origin sees; inside, the nearest edge's normal is the axis of least overlap, and no search is needed.
// The edges of polygons of few vertices are compared all at once (`nearest_axes.hpp`), with the same answer.
#include <limits>

#include "plane/nearest_axes.hpp"
#include "plane/nearest_edge.hpp"

namespace graze::plane {

namespace {

void offer(NearestEdge& best, const DifferenceEdge& e) {
  const NearestEdge on_edge = nearest_on(e);
  if (nearer(on_edge, best)) best = on_edge;
}

}  // namespace

template <class T>
Nearest nearest_by_walk(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a) {
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
  Nearest out;
  if (depth < 0) {
    take_apart(a, b, b_in_a, seen, out);
    return out;
  }
  const bool pointlike = depth == std::numeric_limits<double>::infinity();
  const double allowed = 4 * depth * depth;
  // Inside a polygon the foot on the nearest edge's line lies on that edge, or on one in line with it.
  if (pointlike || length_squared(point_on(shallowest, parameter_on(shallowest))) > allowed) {
    NearestEdge any;
    for_each_difference_edge(a, b, b_in_a, [&](const DifferenceEdge& e) {
      if (pointlike || !detail::is_zero(e.edge)) offer(any, e);
    });
    // No edge holds the foot: the difference has no inside (segments on one line, points upon each other).
    if (any.squared > 0 && (pointlike || any.squared > allowed)) {
      take_apart(a, b, b_in_a, any, out);
      return out;
    }
    shallowest = any.edge;
    if (pointlike) depth = 0;
  }
  take_overlap(a, b, b_in_a, shallowest, parameter_on(shallowest), depth, out);
  return out;
}

template <class T>
Nearest nearest_polygons(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size) {
  Nearest out;
  if (!nearest_by_axes(a, b, b_in_a, size, out)) out = nearest_by_walk(a, b, b_in_a);
  return out;
}

template Nearest nearest_by_walk(const Core<float>&, const Core<float>&, const Pose2d&);
template Nearest nearest_by_walk(const Core<double>&, const Core<double>&, const Pose2d&);
template Nearest nearest_polygons(const Core<float>&, const Core<float>&, const Pose2d&, double);
template Nearest nearest_polygons(const Core<double>&, const Core<double>&, const Pose2d&, double);

}  // namespace graze::plane
