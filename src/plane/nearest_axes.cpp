#include "plane/nearest_axes.hpp"

#include <bit>
#include <type_traits>

#include "plane/axes_kernels.hpp"
#include "plane/difference_outline.hpp"
#include "plane/nearest_edge.hpp"

namespace graze::plane {

namespace {

template <class T>
DifferenceEdge edge_of_a(const EdgeAxes& axes, DifferenceOutline<T>& outline, std::uint32_t edges) {
  const auto i = static_cast<std::uint32_t>(std::countr_zero(edges));
  return outline.edge_of_a(i, static_cast<std::uint32_t>(axes.deepest_b[i]));
}
template <class T>
DifferenceEdge edge_of_b(const EdgeAxes& axes, DifferenceOutline<T>& outline, std::uint32_t edges) {
  const auto j = static_cast<std::uint32_t>(std::countr_zero(edges));
  return outline.edge_of_b(static_cast<std::uint32_t>(axes.deepest_a[j]), j);
}

/// The nearest of the edges that the kernel has found, each at the vertex at which the walk comes to it.
template <class T>
DifferenceEdge nearest_edge(const EdgeAxes& axes, DifferenceOutline<T>& outline) {
  // Mostly there is one.
  const auto single = [](std::uint32_t edges, std::uint32_t none) { return none == 0 && (edges & (edges - 1)) == 0; };
  if (single(axes.edges_a, axes.edges_b)) return edge_of_a(axes, outline, axes.edges_a);
  if (single(axes.edges_b, axes.edges_a)) return edge_of_b(axes, outline, axes.edges_b);
  DifferenceEdge nearest{};
  double height = std::numeric_limits<double>::infinity();
  const auto offer = [&](const DifferenceEdge& e) {
    const double h = height_below(e);
    if (h < height || (h == height && earlier(e, nearest))) height = h, nearest = e;
  };
  for (std::uint32_t edges = axes.edges_a; edges != 0; edges &= edges - 1) offer(edge_of_a(axes, outline, edges));
  for (std::uint32_t edges = axes.edges_b; edges != 0; edges &= edges - 1) offer(edge_of_b(axes, outline, edges));
  return nearest;
}

/// The part of an edge, at its ends, in which rounding may make the next edge the nearer one: far more than the
/// rounding of a parameter is, so that the walk's choice is never missed, and no answer depends on it.
constexpr double beside_end = 0x1p-20;

/// The nearest point of the edges that the origin sees: along the outline from the edge whose line is furthest away, in
/// the direction in which the distance becomes less, as it does up to the nearest point of a convex outline.
template <class T>
NearestEdge nearest_seen(const DifferenceEdge& furthest, DifferenceOutline<T>& outline) {
  NearestEdge best = nearest_on(furthest);
  const bool forward = best.parameter >= 1 - beside_end;
  if (!forward && best.parameter > beside_end) return best;
  DifferenceEdge at = furthest;
  for (;;) {
    at = forward ? outline.after(at) : outline.before(at);
    if (!outline.known() || !(cross(at.start, at.edge) < 0)) return best;
    const NearestEdge next = nearest_on(at);
    if (nearer(next, best) || (!nearer(best, next) && earlier(at, best.edge))) best = next;
    if (forward ? next.parameter < 1 - beside_end : next.parameter > beside_end) return best;
  }
}

/// Fills `axes` and returns whether the kernel answers for these polygons.
template <class T>
bool compare_edges(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double slack, double size,
                   EdgeAxes& axes) {
  if (!axes_take(a, b, slack, size)) return false;
  const AxesPolygon<T> of_a = axes_polygon(a), of_b = axes_polygon(b);
  if constexpr (std::is_same_v<T, float>)
    axes_kernels().of_float(of_a, of_b, b_in_a, slack, axes);
  else
    axes_kernels().of_double(of_a, of_b, b_in_a, slack, axes);
  return axes.regular;
}

}  // namespace

template <class T>
std::optional<bool> within_by_axes(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size,
                                   double limit) {
  const double slack = axes_slack(b_in_a, size);
  EdgeAxes axes;
  if (!compare_edges(a, b, b_in_a, slack, size, axes)) return {};
  const auto height = double(axes.height);
  if (height > slack) return true;
  // Outside, the distance is no less than the gap along any normal.
  if (height < -limit * (1 + 0x1p-40) - slack) return false;
  return {};
}

template <class T>
bool nearest_by_axes(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size, Nearest& out) {
  EdgeAxes axes;
  if (!compare_edges(a, b, b_in_a, axes_slack(b_in_a, size), size, axes)) return false;
  if ((axes.edges_a | axes.edges_b) == 0) return false;
  DifferenceOutline<T> outline(a, b, b_in_a);
  const DifferenceEdge nearest = nearest_edge(axes, outline);
  const double height = height_below(nearest);
  if (!outline.known() || !(height < std::numeric_limits<double>::infinity())) return false;
  if (height < 0) {
    const NearestEdge seen = nearest_seen(nearest, outline);
    if (!outline.known()) return false;
    take_apart(a, b, b_in_a, seen, out);
    return true;
  }
  // Inside a polygon the foot on the nearest edge's line lies on that edge, or on one in line with it.
  const double parameter = parameter_on(nearest);
  if (length_squared(point_on(nearest, parameter)) > 4 * height * height) return false;
  take_overlap(a, b, b_in_a, nearest, parameter, height, out);
  return true;
}

template std::optional<bool> within_by_axes(const Core<float>&, const Core<float>&, const Pose2d&, double, double);
template std::optional<bool> within_by_axes(const Core<double>&, const Core<double>&, const Pose2d&, double, double);
template bool nearest_by_axes(const Core<float>&, const Core<float>&, const Pose2d&, double, Nearest&);
template bool nearest_by_axes(const Core<double>&, const Core<double>&, const Pose2d&, double, Nearest&);

}  // namespace graze::plane
