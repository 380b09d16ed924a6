// Pairs of triangles, a register of them at a time in double, or one.
#include "narrow/batch/pair_bundle.hpp"
#include "narrow/batch/row_bundle.hpp"
#include "narrow/pairs/closed_form.hpp"
#include "narrow/pairs/triangle_triangle/triangle_lanes.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;
constexpr std::size_t part_lanes = lanes_of<double>;

/// The distances of a register of pairs, compiled once for all callers.
[[gnu::noinline, gnu::flatten]] void answer(const PlacedTriangle<S>& a, const PlacedTriangle<S>& b, const S& enough,
                                            TriangleDistance<S>& found) {
  found = triangle_distance<Packed<S, 3>>(a, b, enough);
}

/// Triangles in place, in lanes.
template <class L>
struct LaneTriangles {
  const TriangleCore<L>&a, &b;
  const Pose<L>&pose_a, &pose_b;
};
/// Measures the first `count` pairs, as many at a time as a register holds in double. Pairs further apart than
/// `enough`, by lane, need not be measured. Calls `f(distances, number of the first pair, how many)`.
template <class L, class F>
[[gnu::always_inline]] inline void visit_distances(const LaneTriangles<L>& of, const L& enough, std::size_t count,
                                                   const F& f) {
  visit_parts<typename L::Lane>(
      count, [&](auto number) __attribute__((always_inline)) {
        constexpr std::size_t part = number, first = part * part_lanes;
        TriangleDistance<S> found;
        answer(placed_in_double<part>(of.a, of.pose_a), placed_in_double<part>(of.b, of.pose_b),
               lanes_in_double<part>(enough), found);
        f(found, first, least(count - first, part_lanes));
      });
}

/// Measures pairs in rows, as `visit_distances` does.
template <class T, class F>
[[gnu::always_inline]] inline void visit_rows(const PairRows<T>& rows, std::size_t count, const Lanes<T>& enough,
                                              const F& f) {
  constexpr std::size_t lanes = lanes_of<T>;
  for (std::size_t begin = 0; begin < count; begin += lanes) {
    const RowBundle<Triangle<T>, Triangle<T>, T> p(rows, begin);
    visit_distances(
        LaneTriangles<Lanes<T>>{p.a.shapes.core, p.b.shapes.core, p.pose_a, p.pose_b}, enough,
        least(lanes, count - begin),
        [&](const TriangleDistance<S>& found, std::size_t first, std::size_t size)
            __attribute__((always_inline)) { f(found, begin + first, size); });
  }
}

}  // namespace

[[gnu::noinline, gnu::flatten]] void measure(const TrianglesInUnits<double>& in, const TwoTriangles<SingleRow>& p,
                                             double enough, TriangleDistance<double>& found) {
  found = in.restored(triangle_distance(p, in.a.radius, in.b.radius, in.a.pose.translation, enough / in.unit));
}

[[gnu::flatten]] void triangle_pair(const PlacedTriangle<double>& a, const PlacedTriangle<double>& b, double enough,
                                    TriangleDistance<double>& found) {
  const TrianglesInUnits<double> in(a, b);
  measure(in, two_triangles<SingleRow>(in.a, in.b), enough, found);
}

/// `turned` changes nothing: both shapes are of one kind.
template <class T>
[[gnu::flatten]] std::uint32_t triangle_row_distances(const PairRows<T>& rows, std::size_t count, bool,
                                                      Distance<T>* distances, std::uint8_t* unknown) {
  std::uint32_t unknown_count = 0;
  const Lanes<T> all(std::numeric_limits<T>::infinity());
  visit_rows(rows, count, all, [&](const TriangleDistance<S>& found, std::size_t first, std::size_t size) {
    const Distance<S>& d = found.at;
    for (std::size_t k = 0; k < size; ++k) {
      const int i = static_cast<int>(k);
      distances[first + k] = {static_cast<T>(d.distance[i]), lane<T>(d.normal, i), lane<T>(d.a, i), lane<T>(d.b, i)};
    }
    append_places(bits_of(!found.proven) & filled_lanes<double>(size), first, unknown, unknown_count);
  });
  return unknown_count;
}

template <class T>
[[gnu::flatten]] void triangle_pair_distances(const PairRef<T>* pairs, std::size_t count, FoundTriangles<T>* found) {
  using Pairs = PairBundle<Triangle<T>, Triangle<T>, T>;
  for (std::size_t begin = 0; begin < count; begin += Pairs::lanes) {
    const Pairs p(pairs + begin, count - begin);
    visit_distances(LaneTriangles<Lanes<T>>{p.a.core, p.b.core, p.pose_a, p.pose_b}, before_rounding<T>(p.margin),
                    p.count, [&](const TriangleDistance<S>& of, std::size_t first, std::size_t size) {
                      for (std::size_t k = 0; k < size; ++k) {
                        const std::size_t pair = begin + first + k;
                        const int i = static_cast<int>(k);
                        const T distance = static_cast<T>(of.at.distance[i]);
                        const bool certified = of.proven[i] && (!of.beyond[i] || distance > pairs[pair].margin);
                        found[pair] = {
                            certified ? distance : -std::numeric_limits<T>::infinity(),
                            {of.at.distance[i], lane<double>(of.at.normal, i), lane<double>(of.at.a, i), {}}};
                      }
                    });
  }
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template std::uint32_t triangle_row_distances(const PairRows<T>&, std::size_t, bool, Distance<T>*, std::uint8_t*);   \
  template void triangle_pair_distances(const PairRef<T>*, std::size_t, FoundTriangles<T>*);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
