// The points of contact of pairs of triangles, a register of them at a time in double, or one.
#include "narrow/batch/layouts.hpp"
#include "narrow/batch/point_rows.hpp"
#include "narrow/pairs/triangle_triangle/triangle_lanes.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;
constexpr std::size_t part_lanes = lanes_of<double>;

/// Writes the points of a register of pairs, whose distances are `at`. Compiled once for both scalars.
[[gnu::noinline, gnu::flatten]] void answer(const PlacedTriangle<S>& a, const PlacedTriangle<S>& b,
                                            const Distance<S>& at, const S& margin, const AnswerRounding& rounding,
                                            ContactSlots<S>& found) {
  using Row = Packed<S, 3>;
  const TrianglesInUnits<S> in(a, b);
  const TwoTriangles<Row> p = two_triangles<Row>(in.a, in.b);
  lay_triangles(in, p, triangle_axes(p), at, margin, rounding, found);
}

/// Distances in lanes; lanes without a pair repeat the last one.
template <class T>
[[gnu::always_inline]] inline Distance<S> gathered_distances(const FoundTriangles<T>* found, std::size_t count) {
  const auto row = [&](std::size_t lane) __attribute__((always_inline))->const void* {
    return &found[lane < count ? lane : count - 1].at;
  };
  S n[4], a[3];
  gather<double>(row, 0, n);
  gather<double>(row, offsetof(Distance<double>, a), a);
  return {n[0], {n[1], n[2], n[3]}, {a[0], a[1], a[2]}, {}};
}

/// Writes the points of one lane's pair and returns their number; of two with the same features the deeper one.
template <class T>
[[gnu::always_inline]] inline std::size_t put_points(const ContactSlots<S>& found, int lane, ContactPoint<T>* to) {
  std::uint64_t seen = 0;
  std::size_t count = 0;
  for (auto filled = static_cast<unsigned>(static_cast<int>(found.filled[lane])); filled != 0; filled &= filled - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(filled));
    const auto vector = [&](const auto& column) __attribute__((always_inline)) {
      return Vec3<T>{static_cast<T>(column[0][i][lane]), static_cast<T>(column[1][i][lane]),
                     static_cast<T>(column[2][i][lane])};
    };
    const auto part_a = static_cast<std::uint32_t>(static_cast<int>(found.part_a[i][lane])),
               part_b = static_cast<std::uint32_t>(static_cast<int>(found.part_b[i][lane]));
    const std::uint32_t feature = feature_id(triangle_features[part_a], triangle_features[part_b]);
    const T distance = static_cast<T>(found.distance[i][lane]);
    const std::uint64_t bit = std::uint64_t{1} << (8 * part_a + part_b);
    const ContactPoint<T> point{vector(found.a), vector(found.b), distance, feature, T(0.5)};
    std::size_t place = count;
    if ((seen & bit) != 0) [[unlikely]] {
      place = 0;
      while (to[place].feature != feature) ++place;
      if (!IsDeeperTilted()(point, to[place])) continue;
    }
    seen |= bit;
    to[place] = point;
    count += place == count;
  }
  return count;
}

}  // namespace

[[gnu::flatten]] void triangle_pair_contact(const PlacedTriangle<double>& a, const PlacedTriangle<double>& b,
                                            double enough, double margin, const AnswerRounding& rounding,
                                            TriangleDistance<double>& found, TriangleAxes<double>& axes,
                                            ContactSlots<double>& points) {
  const TrianglesInUnits<double> in(a, b);
  const TwoTriangles<SingleRow> p = two_triangles<SingleRow>(in.a, in.b);
  measure(in, p, enough, found);
  points.known = 0;
  if (!found.proven || found.at.distance > enough) return;
  const TriangleAxes<double> in_units = triangle_axes(p);
  axes = in_units.times(in.unit);
  if (a.radius == 0 && b.radius == 0) lay_triangles(in, p, in_units, found.at, margin, rounding, points);
}

template <class T>
[[gnu::flatten]] void triangle_pair_points(const PairRef<T>* pairs, const FoundTriangles<T>* found, std::size_t count,
                                           PointBlock<T>& block) {
  using Pairs = PairBundle<Triangle<T>, Triangle<T>, T>;
  clear(block);
  const auto put_part = [&](const Pairs& p, std::size_t begin, auto number) {
    constexpr std::size_t part = number, first_lane = part * part_lanes;
    const std::size_t first = begin + first_lane, size = least(p.count - first_lane, part_lanes);
    ContactSlots<S> manifold;
    answer(placed_in_double<part>(p.a.core, p.pose_a), placed_in_double<part>(p.b.core, p.pose_b),
           gathered_distances(found + first, size), lanes_in_double<part>(p.margin), answer_rounding<T>(), manifold);
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t pair = first + k;
      const int i = static_cast<int>(k);
      if (manifold.known[i] == 0 || !(found[pair].distance > -std::numeric_limits<T>::infinity())) continue;
      const auto normal = [&](std::size_t axis) { return static_cast<T>(manifold.normal[axis][i]); };
      const auto points = static_cast<std::uint32_t>(put_points<T>(manifold, i, block.points + block.point_count));
      block.known |= std::uint32_t{1} << pair;
      block.manifolds[block.manifold_count++] = {
          {normal(0), normal(1), normal(2)}, 0, 0, block.first_point + block.point_count, points};
      block.point_count += points;
    }
  };
  for (std::size_t begin = 0; begin < count; begin += Pairs::lanes) {
    const Pairs p(pairs + begin, count - begin);
    visit_parts<T>(p.count, [&](auto part) { put_part(p, begin, part); });
  }
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void triangle_pair_points(const PairRef<T>*, const FoundTriangles<T>*, std::size_t, PointBlock<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
