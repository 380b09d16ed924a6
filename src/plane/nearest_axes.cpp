#include "plane/nearest_axes.hpp"

#include <bit>

#include "plane/edge_axes.hpp"
#include "plane/nearest_edge.hpp"

namespace graze::plane {

namespace {

const EdgeAxesKernels& kernels() {
  static const EdgeAxesKernels& chosen = GRAZE_KERNEL(chosen_isa(), plane_edge_axes)();
  return chosen;
}
EdgeAxesKernel<float> kernel_of(float) { return kernels().of_float; }
EdgeAxesKernel<double> kernel_of(double) { return kernels().of_double; }

template <class T>
const Vec2<T>* vertices_of(const Core<T>& core) {
  return core.outside ? core.outside : core.inside.data();
}

/// How far the kernel's heights of edges below the origin may be off, relative to the numbers they are made of: floats,
/// of which the vertices are off by three units (a rotation and a sum), the directions of edges by four, the two products
/// across and their differences by three more, the inverse of the length by three. Two heights are compared.
constexpr double height_rounding = 32 * double(std::numeric_limits<float>::epsilon());

/// Sizes whose squares floats hold with all their digits, and those of parts a thousandth as large.
constexpr double least_size = 1e-14, most_size = 1e14;

/// Which of two directions less than half a turn apart comes first, counter-clockwise.
enum class Order { before, same, after, unknown };
Order order(const Vec2d& first, const Vec2d& second) {
  const double turn = cross(first, second);
  if (turn != 0) return turn > 0 ? Order::before : Order::after;
  return dot(first, second) > 0 ? Order::same : Order::unknown;
}

/// The outline of the Minkowski difference, gone along step by step: as the walk does, edges of A come before edges of
/// B of the same direction.
template <class T>
class DifferenceOutline {
 public:
  DifferenceOutline(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a)
      : a_(a), b_(b), b_in_a_(b_in_a), more_(a.count + b.count) {}

  /// Whether rounding has left an order so far.
  bool known() const { return known_; }

  /// The edge of A numbered `i`, swept by the vertex of B below it: `j`, or one beside it.
  DifferenceEdge edge_of_a(std::uint32_t i, std::uint32_t j) {
    if (b_.count > 1) {
      const Vec2d e = a_.edge(i);
      while (comes_first(e, edge_b(b_.previous(j))) && step()) j = b_.previous(j);
      while (order(e, edge_b(j)) == Order::after && step()) j = b_.next(j);
    }
    return made(true, i, j);
  }
  /// The edge of B numbered `j`, swept by the vertex of A below it: `i`, or one beside it.
  DifferenceEdge edge_of_b(std::uint32_t i, std::uint32_t j) {
    if (a_.count > 1) {
      const Vec2d e = edge_b(j);
      while (order(a_.edge(a_.previous(i)), e) == Order::after && step()) i = a_.previous(i);
      while (comes_first(a_.edge(i), e) && step()) i = a_.next(i);
    }
    return made(false, i, j);
  }
  DifferenceEdge after(const DifferenceEdge& e) {
    step();
    const std::uint32_t i = e.of_a ? a_.next(e.i) : e.i, j = e.of_a ? e.j : b_.next(e.j);
    return made(a_first(i, j), i, j);
  }
  DifferenceEdge before(const DifferenceEdge& e) {
    step();
    const std::uint32_t i = a_.previous(e.i), j = b_.previous(e.j);
    return b_.count > 1 && (a_.count < 2 || a_first(i, j)) ? made(false, e.i, j) : made(true, i, e.j);
  }

 private:
  Vec2d edge_b(std::uint32_t j) const { return rotate(b_in_a_.rotation, -b_.edge(j)); }
  /// Whether A's edge i comes before B's edge j. Of a polygon without edges the other's come before and after.
  bool a_first(std::uint32_t i, std::uint32_t j) {
    if (a_.count < 2 || b_.count < 2) return b_.count < 2;
    const Order o = order(a_.edge(i), edge_b(j));
    known_ = known_ && o != Order::unknown;
    return o != Order::after;
  }
  /// Whether an edge of A comes before one of B.
  static bool comes_first(const Vec2d& of_a, const Vec2d& of_b) {
    const Order o = order(of_a, of_b);
    return o == Order::before || o == Order::same;
  }
  /// Goes on by one edge, unless it has been all around.
  bool step() {
    known_ = known_ && more_ > 0;
    if (known_) --more_;
    return known_;
  }
  DifferenceEdge made(bool of_a, std::uint32_t i, std::uint32_t j) const {
    const Vec2d start = a_.vertex(i) - transform(b_in_a_, b_.vertex(j));
    return {of_a, i, j, start, of_a ? a_.edge(i) : edge_b(j)};
  }

  const Core<T>&a_, &b_;
  const Pose2d& b_in_a_;
  std::uint32_t more_;  ///< steps that are left
  bool known_ = true;
};

/// Whether the walk comes to an edge earlier than to another one.
bool earlier(const DifferenceEdge& e, const DifferenceEdge& than) {
  return e.of_a ? detail::not_after(e.edge, than.edge) : !detail::not_after(than.edge, e.edge);
}

/// The nearest of the edges that the kernel has found, each at the vertex at which the walk comes to it.
template <class T>
DifferenceEdge nearest_edge(const EdgeAxes& axes, DifferenceOutline<T>& outline, double& height) {
  DifferenceEdge nearest{};
  height = std::numeric_limits<double>::infinity();
  const auto offer = [&](const DifferenceEdge& e) {
    const double h = height_below(e);
    if (h < height || (h == height && earlier(e, nearest))) height = h, nearest = e;
  };
  for (std::uint32_t edges = axes.edges_a; edges != 0; edges &= edges - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(edges));
    offer(outline.edge_of_a(i, static_cast<std::uint32_t>(axes.deepest_b[i])));
  }
  for (std::uint32_t edges = axes.edges_b; edges != 0; edges &= edges - 1) {
    const auto j = static_cast<std::uint32_t>(std::countr_zero(edges));
    offer(outline.edge_of_b(static_cast<std::uint32_t>(axes.deepest_a[j]), j));
  }
  return nearest;
}

/// The part of an edge, at its ends, in which rounding may make the next edge the nearer one: far more than the rounding
/// of a parameter is, so that the walk's choice is never missed, and no answer depends on it.
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
    if (next.squared < best.squared || (next.squared == best.squared && earlier(at, best.edge))) best = next;
    if (forward ? next.parameter < 1 - beside_end : next.parameter > beside_end) return best;
  }
}

/// What the kernel's heights may be off.
double slack_of(const Pose2d& b_in_a, double size) {
  return height_rounding * (size + size + max_abs(b_in_a.translation));
}

/// Fills `axes` and returns whether the kernel answers for these polygons.
template <class T>
bool compare_edges(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double slack, double size,
                   EdgeAxes& axes) {
  if (a.count > most_edges || b.count > most_edges || (a.count < 3 && b.count < 3)) return false;
  if (!(size >= least_size && slack <= height_rounding * most_size)) return false;
  kernel_of(T())({vertices_of(a), a.count}, {vertices_of(b), b.count}, b_in_a, slack, axes);
  return axes.regular;
}

}  // namespace

template <class T>
std::optional<bool> within_by_axes(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size,
                                   double limit) {
  const double slack = slack_of(b_in_a, size);
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
  if (!compare_edges(a, b, b_in_a, slack_of(b_in_a, size), size, axes)) return false;
  DifferenceOutline<T> outline(a, b, b_in_a);
  double height;
  const DifferenceEdge nearest = nearest_edge(axes, outline, height);
  if (!outline.known() || !(height < std::numeric_limits<double>::infinity())) return false;
  if (height < 0) {
    const NearestEdge seen = nearest_seen(nearest, outline);
    if (!outline.known()) return false;
    out = apart(a, b, b_in_a, seen);
    return true;
  }
  // Inside a polygon the foot on the nearest edge's line lies on that edge, or on one in line with it.
  if (length_squared(point_on(nearest, parameter_on(nearest))) > 4 * height * height) return false;
  out = overlapping(a, b, b_in_a, nearest, height);
  return true;
}

template std::optional<bool> within_by_axes(const Core<float>&, const Core<float>&, const Pose2d&, double, double);
template std::optional<bool> within_by_axes(const Core<double>&, const Core<double>&, const Pose2d&, double, double);
template bool nearest_by_axes(const Core<float>&, const Core<float>&, const Pose2d&, double, Nearest&);
template bool nearest_by_axes(const Core<double>&, const Core<double>&, const Pose2d&, double, Nearest&);

}  // namespace graze::plane
