#include "plane/edge_axes.hpp"

#include <limits>

#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace plane;

using Beside = Lanes<double>;
constexpr std::uint32_t width = Beside::lanes;

/// Vertices in one frame, and the first one again behind the last up to a register more than they fill: edges there
/// have no length.
struct Columns {
  static constexpr std::uint32_t room = most_edges + width;
  alignas(64) double x[room], y[room];
  std::uint32_t end;
};

template <class T>
[[gnu::always_inline]] inline void take_vertices(const AxesPolygon<T>& polygon, Columns& to) {
  to.end = (polygon.count + width - 1) / width * width + width;
  const Beside first_x(double(polygon.vertices[0].x)), first_y(double(polygon.vertices[0].y));
  for (std::uint32_t i = 0; i < to.end; i += width) first_x.store(to.x + i), first_y.store(to.y + i);
  for (std::uint32_t i = 1; i < polygon.count; ++i) {
    to.x[i] = double(polygon.vertices[i].x);
    to.y[i] = double(polygon.vertices[i].y);
  }
}

[[gnu::always_inline]] inline void turn(const Pose2d& pose, Columns& columns) {
  const Beside cosine(pose.rotation.cosine), sine(pose.rotation.sine);
  const Beside at_x(pose.translation.x), at_y(pose.translation.y);
  for (std::uint32_t i = 0; i < columns.end; i += width) {
    const Beside x = Beside::load(columns.x + i), y = Beside::load(columns.y + i);
    (at_x + (cosine * x - sine * y)).store(columns.x + i);
    (at_y + (sine * x + cosine * y)).store(columns.y + i);
  }
}

/// Heights of the origin below the edges of `own`, swept by the other polygon.
struct Heights {
  Beside of[(most_edges + width - 1) / width];
  Beside least{std::numeric_limits<double>::infinity()};
  bool regular = true;
};

/// Writes, for each edge of `own`, the height of the origin below it and the vertex of `other` that lies deepest. The
/// same for A and for B: the difference has B's edges turned by half a turn, and its vertices too.
[[gnu::always_inline]] inline void measure(const Columns& own, std::uint32_t count, const Columns& other,
                                           std::uint32_t other_count, double (&deepest)[most_edges], Heights& out) {
  for (std::uint32_t first = 0, k = 0; first < count; first += width, ++k) {
    const Beside x = Beside::load(own.x + first), y = Beside::load(own.y + first);
    const Beside edge_x = Beside::load(own.x + first + 1) - x, edge_y = Beside::load(own.y + first + 1) - y;
    const auto across = [&](const Beside& px, const Beside& py) __attribute__((always_inline)) {
      return px * edge_y - py * edge_x;
    };
    Beside lowest = across(Beside(other.x[0]), Beside(other.y[0])), at(0.0);
    for (std::uint32_t j = 1; j < other_count; ++j) {
      const Beside reach = across(Beside(other.x[j]), Beside(other.y[j]));
      const auto lower = reach < lowest;
      lowest = select(lower, reach, lowest);
      at = select(lower, Beside(double(j)), at);
    }
    at.store(deepest + first);
    const Beside squared = edge_x * edge_x + edge_y * edge_y;
    const auto extended = squared > Beside(0.0);
    const std::uint32_t edges = filled_lanes<double>(count - first);
    out.regular = out.regular && (bits_of(extended) & edges) == edges;
    const Beside height = (across(x, y) - lowest) / sqrt(squared);
    out.of[k] = select(extended, height, Beside(std::numeric_limits<double>::infinity()));
    out.least = least(out.least, out.of[k]);
  }
}

[[gnu::always_inline]] inline double least_lane(const Beside& x) {
  double lanes[width];
  x.store(lanes);
  for (std::uint32_t half = width / 2; half > 0; half /= 2)
    for (std::uint32_t i = 0; i < half; ++i) lanes[i] = lanes[i + half] < lanes[i] ? lanes[i + half] : lanes[i];
  return lanes[0];
}

[[gnu::always_inline]] inline std::uint32_t nearest_edges(const Heights& heights, std::uint32_t count, double limit) {
  std::uint32_t bits = 0;
  for (std::uint32_t first = 0, k = 0; first < count; first += width, ++k)
    bits |= bits_of(heights.of[k] <= Beside(limit)) << first;
  return bits;
}

template <class T>
[[gnu::flatten]] void edge_axes(const AxesPolygon<T>& a, const AxesPolygon<T>& b, const Pose2d& b_in_a, double slack,
                                EdgeAxes& out) {
  Columns of_a, of_b;
  take_vertices(a, of_a);
  take_vertices(b, of_b);
  turn(b_in_a, of_b);
  Heights heights_a, heights_b;
  const std::uint32_t edges_a = a.count < 2 ? 0 : a.count, edges_b = b.count < 2 ? 0 : b.count;
  measure(of_a, edges_a, of_b, b.count, out.deepest_b, heights_a);
  measure(of_b, edges_b, of_a, a.count, out.deepest_a, heights_b);
  out.regular = heights_a.regular && heights_b.regular;
  const double limit = least_lane(least(heights_a.least, heights_b.least)) + slack;
  out.edges_a = nearest_edges(heights_a, edges_a, limit);
  out.edges_b = nearest_edges(heights_b, edges_b, limit);
}

constexpr EdgeAxesKernels kernels{edge_axes<float>, edge_axes<double>};

}  // namespace

const EdgeAxesKernels& plane_edge_axes() { return kernels; }

}  // namespace graze::GRAZE_ISA
