#include "plane/edge_axes.hpp"

#include <limits>

#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace plane;

constexpr std::uint32_t width = lanes_of<float> < 8 ? lanes_of<float> : 8;
using Beside = Wide<float, static_cast<int>(width)>;
using Sequence = std::make_index_sequence<width>;
constexpr float infinite = std::numeric_limits<float>::infinity();

/// Edges shorter than this, squared, are too near the least float for their lengths to keep their digits.
constexpr float least_squared = 1e-36f;

/// The vertices of a polygon and its edges, all in one frame, up to `registers` full ones. Behind the last vertex
/// stands the first one again: edges there have no length.
template <std::uint32_t registers>
struct Columns {
  Beside x[registers], y[registers], edge_x[registers], edge_y[registers];
};
/// Vertices to be read one by one.
template <std::uint32_t registers>
struct Vertices {
  alignas(64) float x[registers * width], y[registers * width];
};

template <std::size_t first, std::size_t... I>
[[gnu::always_inline]] inline Beside every_second(const Beside& low, const Beside& high, std::index_sequence<I...>) {
  return Beside::of(__builtin_shufflevector(low.v, high.v, (2 * I + first)...));
}
template <std::size_t... I>
[[gnu::always_inline]] inline Beside numbers_from(float first, std::index_sequence<I...>) {
  return Beside::of(typename Beside::Vector{(first + float(I))...});
}
/// The lanes from the second on, and behind them the first of the next register.
template <std::size_t... I>
[[gnu::always_inline]] inline Beside moved_up(const Beside& x, const Beside& next, std::index_sequence<I...>) {
  return Beside::of(__builtin_shufflevector(x.v, next.v, (I + 1)...));
}

/// Loads a polygon from memory in which `registers` full registers of vertices can be read.
template <std::uint32_t registers>
[[gnu::always_inline]] inline void take_together(const AxesPolygon<float>& polygon, Columns<registers>& to) {
  static_assert(sizeof(Vec2<float>) == 2 * sizeof(float));
  const float* const from = &polygon.vertices[0].x;
  const Beside first_x(from[0]), first_y(from[1]), count(float(polygon.count));
  for (std::uint32_t k = 0; k < registers; ++k) {
    const Beside low = Beside::load(from + 2 * k * width), high = Beside::load(from + (2 * k + 1) * width);
    const auto there = numbers_from(float(k * width), Sequence()) < count;
    to.x[k] = select(there, every_second<0>(low, high, Sequence()), first_x);
    to.y[k] = select(there, every_second<1>(low, high, Sequence()), first_y);
  }
  for (std::uint32_t k = 0; k < registers; ++k) {
    to.edge_x[k] = moved_up(to.x[k], k + 1 < registers ? to.x[k + 1] : first_x, Sequence()) - to.x[k];
    to.edge_y[k] = moved_up(to.y[k], k + 1 < registers ? to.y[k + 1] : first_y, Sequence()) - to.y[k];
  }
}

/// Loads a polygon vertex by vertex; edges in T, since the difference of two rounded vertices has no digits left where
/// it is short.
template <class T, std::uint32_t registers>
[[gnu::always_inline]] inline void take_singly(const AxesPolygon<T>& polygon, Columns<registers>& to) {
  constexpr std::uint32_t room = registers * width;
  alignas(64) float x[room], y[room], edge_x[room], edge_y[room];
  for (std::uint32_t i = 0; i < room; ++i) {
    const bool there = i < polygon.count;
    const Vec2<T> p = polygon.vertices[there ? i : 0], q = polygon.vertices[there && i + 1 < polygon.count ? i + 1 : 0];
    x[i] = float(p.x), y[i] = float(p.y);
    edge_x[i] = float(q.x - p.x), edge_y[i] = float(q.y - p.y);
  }
  for (std::uint32_t k = 0; k < registers; ++k) {
    to.x[k] = Beside::load(x + k * width), to.y[k] = Beside::load(y + k * width);
    to.edge_x[k] = Beside::load(edge_x + k * width), to.edge_y[k] = Beside::load(edge_y + k * width);
  }
}

template <class T, std::uint32_t registers>
[[gnu::always_inline]] inline void take_vertices(const AxesPolygon<T>& polygon, Columns<registers>& to) {
  if constexpr (sizeof(T) == sizeof(float) && registers * width <= readable_vertices)
    take_together(polygon, to);
  else
    take_singly(polygon, to);
}

template <std::uint32_t registers>
[[gnu::always_inline]] inline void turn(const Pose2d& pose, Columns<registers>& columns) {
  const Beside cosine(float(pose.rotation.cosine)), sine(float(pose.rotation.sine));
  const Beside at_x(float(pose.translation.x)), at_y(float(pose.translation.y));
  for (std::uint32_t k = 0; k < registers; ++k) {
    const Beside x = columns.x[k], y = columns.y[k], edge_x = columns.edge_x[k], edge_y = columns.edge_y[k];
    columns.x[k] = at_x + (cosine * x - sine * y);
    columns.y[k] = at_y + (sine * x + cosine * y);
    columns.edge_x[k] = cosine * edge_x - sine * edge_y;
    columns.edge_y[k] = sine * edge_x + cosine * edge_y;
  }
}
template <std::uint32_t registers>
[[gnu::always_inline]] inline void store(const Columns<registers>& columns, Vertices<registers>& to) {
  for (std::uint32_t k = 0; k < registers; ++k) {
    columns.x[k].store(to.x + k * width);
    columns.y[k].store(to.y + k * width);
  }
}

/// Heights of the origin below the edges of a polygon, swept by the other one.
template <std::uint32_t registers>
struct Heights {
  Beside of[registers], inverse_length[registers];
  Beside least{infinite};
  std::uint32_t irregular = 0;  ///< edges without a length, as bits
};

/// Writes, for each edge of `own`, the height of the origin below it and the vertex of `other` that lies deepest. A and
/// B are treated alike: the difference has B's edges turned by half a turn, and its vertices too.
template <std::uint32_t registers>
[[gnu::always_inline]] inline void measure(const Columns<registers>& own, const Vertices<registers>& other,
                                           std::uint32_t other_count, float (&deepest)[most_edges],
                                           Heights<registers>& out) {
  const Beside one(1.0f);
  Beside lowest[registers], at[registers], number(0.0f);
  const auto across = [&](std::uint32_t k, const Beside& px, const Beside& py) __attribute__((always_inline)) {
    return px * own.edge_y[k] - py * own.edge_x[k];
  };
  for (std::uint32_t k = 0; k < registers; ++k) lowest[k] = across(k, Beside(other.x[0]), Beside(other.y[0]));
  for (std::uint32_t j = 1; j < other_count; ++j) {
    const Beside x(other.x[j]), y(other.y[j]);
    number += one;
    for (std::uint32_t k = 0; k < registers; ++k) {
      const Beside reach = across(k, x, y);
      const auto lower = reach < lowest[k];
      lowest[k] = select(lower, reach, lowest[k]);
      at[k] = select(lower, number, at[k]);
    }
  }
  for (std::uint32_t k = 0; k < registers; ++k) {
    at[k].store(deepest + k * width);
    const Beside squared = own.edge_x[k] * own.edge_x[k] + own.edge_y[k] * own.edge_y[k];
    const auto extended = squared >= Beside(least_squared);
    out.irregular |= bits_of(!extended) << (k * width);
    out.inverse_length[k] = one / sqrt(squared);
    const Beside height = (across(k, own.x[k], own.y[k]) - lowest[k]) * out.inverse_length[k];
    out.of[k] = select(extended, height, Beside(infinite));
    out.least = least(out.least, out.of[k]);
  }
}

template <int N, std::size_t... I>
[[gnu::always_inline]] inline float least_lane(const Wide<float, N>& x, std::index_sequence<I...>) {
  if constexpr (N == 4) {
    const float low = x[1] < x[0] ? x[1] : x[0], high = x[3] < x[2] ? x[3] : x[2];
    return high < low ? high : low;
  } else {
    using Half = Wide<float, N / 2>;
    const Half low = Half::of(graze::detail::lanes_from<0>(x.v, std::index_sequence<I...>())),
               high = Half::of(graze::detail::lanes_from<N / 2>(x.v, std::index_sequence<I...>()));
    return least_lane(least(low, high), std::make_index_sequence<N / 4>());
  }
}

template <std::uint32_t registers>
[[gnu::always_inline]] inline std::uint32_t nearest_edges(const Heights<registers>& heights, float limit) {
  std::uint32_t bits = 0;
  for (std::uint32_t k = 0; k < registers; ++k) bits |= bits_of(heights.of[k] <= Beside(limit)) << (k * width);
  return bits;
}

[[gnu::always_inline]] inline bool has_irregular(std::uint32_t edges, std::uint32_t count) {
  return count > 1 && (edges & ((std::uint32_t{1} << count) - 1)) != 0;
}

/// Two polygons in A's frame, and the heights below the edges of each.
template <std::uint32_t registers>
struct Measured {
  Columns<registers> of_a, of_b;
  Heights<registers> heights_a, heights_b;

  template <class T, class Out>
  [[gnu::always_inline]] Measured(const AxesPolygon<T>& a, const AxesPolygon<T>& b, const Pose2d& b_in_a, Out& out) {
    Vertices<registers> vertices_a, vertices_b;
    take_vertices(a, of_a);
    take_vertices(b, of_b);
    turn(b_in_a, of_b);
    store(of_a, vertices_a);
    store(of_b, vertices_b);
    measure(of_a, vertices_b, b.count, out.deepest_b, heights_a);
    measure(of_b, vertices_a, a.count, out.deepest_a, heights_b);
    out.regular = !has_irregular(heights_a.irregular, a.count) && !has_irregular(heights_b.irregular, b.count);
  }
};

template <std::uint32_t registers, class T>
[[gnu::always_inline]] inline void compare(const AxesPolygon<T>& a, const AxesPolygon<T>& b, const Pose2d& b_in_a,
                                           double slack, EdgeAxes& out) {
  const Measured<registers> both(a, b, b_in_a, out);
  out.height = least_lane(least(both.heights_a.least, both.heights_b.least), std::make_index_sequence<width / 2>());
  const float limit = out.height + float(slack);
  out.edges_a = nearest_edges(both.heights_a, limit);
  out.edges_b = nearest_edges(both.heights_b, limit);
}

/// The least sine of the angle at which the ray meets an edge for floats to bound the time of the crossing.
constexpr float least_toward = 0x1p-13f;
/// The rounding error of the sine between an edge and the ray.
constexpr float toward_rounding = 8 * std::numeric_limits<float>::epsilon();

/// Bounds of the times at which the ray crosses the lines of a polygon's edges, and from which side it does.
template <std::uint32_t registers>
struct Crossings {
  using Mask = decltype(Beside() < Beside());
  Beside upper[registers];
  Mask facing[registers];
  Beside last_entry{-infinite}, first_exit{infinite};
  std::uint32_t along = 0;  ///< edges that the ray may run along, as bits

  /// `sign` is 1 for edges of A and -1 for those of B, which the difference has turned by half a turn.
  [[gnu::always_inline]] Crossings(const Columns<registers>& own, const Heights<registers>& heights, float radius,
                                   const Vec2d& direction, float sign, float slack) {
    const Beside x(sign * float(direction.x)), y(sign * float(direction.y)), zero(0.0f);
    for (std::uint32_t k = 0; k < registers; ++k) {
      const Beside height = heights.of[k] + Beside(radius);
      const Beside toward = (own.edge_x[k] * y - own.edge_y[k] * x) * heights.inverse_length[k];
      const Beside inverse = Beside(1.0f) / toward, t = zero - height * inverse;
      const Beside error = (Beside(slack) + abs(t) * Beside(toward_rounding)) * abs(inverse);
      facing[k] = toward >= Beside(least_toward);
      const auto leaving = toward <= Beside(-least_toward);
      along |= bits_of((!(facing[k] | leaving)) & (height < Beside(slack))) << (k * width);
      upper[k] = t + error;
      last_entry = greatest(last_entry, select(facing[k], t - error, Beside(-infinite)));
      first_exit = least(first_exit, select(leaving, upper[k], Beside(infinite)));
    }
  }
  [[gnu::always_inline]] std::uint32_t entries(float last) const {
    std::uint32_t bits = 0;
    for (std::uint32_t k = 0; k < registers; ++k)
      bits |= bits_of(facing[k] & (upper[k] >= Beside(last))) << (k * width);
    return bits;
  }
};

template <std::uint32_t registers, class T>
[[gnu::always_inline]] inline void enter(const AxesPolygon<T>& a, const AxesPolygon<T>& b, const Pose2d& b_in_a,
                                         double radius, const Vec2d& direction, double slack, EdgeEntries& out) {
  const Measured<registers> both(a, b, b_in_a, out);
  const Crossings<registers> of_a(both.of_a, both.heights_a, float(radius), direction, 1, float(slack)),
      of_b(both.of_b, both.heights_b, float(radius), direction, -1, float(slack));
  const auto half = std::make_index_sequence<width / 2>();
  const float last_entry = -least_lane(least(-of_a.last_entry, -of_b.last_entry), half),
              first_exit = least_lane(least(of_a.first_exit, of_b.first_exit), half);
  out.regular = out.regular && (of_a.along | of_b.along) == 0;
  out.missed = last_entry > first_exit || first_exit < 0;
  out.edges_a = of_a.entries(last_entry);
  out.edges_b = of_b.entries(last_entry);
}

template <class T>
[[gnu::flatten]] void edge_axes(const AxesPolygon<T>& a, const AxesPolygon<T>& b, const Pose2d& b_in_a, double slack,
                                EdgeAxes& out) {
  if (a.count <= readable_vertices && b.count <= readable_vertices)
    compare<readable_vertices / width>(a, b, b_in_a, slack, out);
  else
    compare<most_edges / width>(a, b, b_in_a, slack, out);
}

template <class T>
[[gnu::flatten]] void edge_entries(const AxesPolygon<T>& a, const AxesPolygon<T>& b, const Pose2d& b_in_a,
                                   double radius, const Vec2d& direction, double slack, EdgeEntries& out) {
  if (a.count <= readable_vertices && b.count <= readable_vertices)
    enter<readable_vertices / width>(a, b, b_in_a, radius, direction, slack, out);
  else
    enter<most_edges / width>(a, b, b_in_a, radius, direction, slack, out);
}

constexpr EdgeAxesKernels kernels{edge_axes<float>, edge_axes<double>, edge_entries<float>, edge_entries<double>};

}  // namespace

const EdgeAxesKernels& plane_edge_axes() { return kernels; }

}  // namespace graze::GRAZE_ISA
