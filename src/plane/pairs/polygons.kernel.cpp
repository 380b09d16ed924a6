#include "plane/pairs/lane_answers.hpp"
#include "plane/pairs/lane_polygon_manifold.hpp"
#include "plane/pairs/polygon_kernels.hpp"
#include "simd/gather.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace plane;
using plane_answers::put;
using plane_answers::put_truth;

using Beside = Lanes<double>;

template <std::size_t N>
[[gnu::flatten]] void distances_of(const PolygonBlock& block, std::size_t count, DistanceColumns<block_pairs>& out) {
  for (std::size_t i = 0; i < count; i += Beside::lanes) {
    const LanePolygons<Beside, N> pair(block, i);
    const LanePolygonNearest<Beside> nearest = nearest_lanes(pair);
    const LaneNearest<Beside>& found = nearest.points;
    put_truth<Beside>(out.known, i, nearest.known);
    put(out.distance, i, found.distance - pair.radius_a - pair.radius_b);
    put(out.normal, i, rotate(pair.pose_a.rotation, found.normal));
    put(out.a, i, transform(pair.pose_a, found.a + found.normal * pair.radius_a));
    put(out.b, i, transform(pair.pose_a, found.b - found.normal * pair.radius_b));
  }
}

[[gnu::always_inline]] inline void put_point(const Pose2<Beside>& pose, const LanePoint<Beside>& p, std::size_t first,
                                             double (&out)[point_columns][block_pairs]) {
  const Vec2<Beside> a = transform(pose, p.a), b = transform(pose, p.b);
  put(out[0], first, a.x);
  put(out[1], first, a.y);
  put(out[2], first, b.x);
  put(out[3], first, b.y);
  put(out[4], first, p.distance);
  put(out[5], first, p.feature);
  put(out[6], first, p.weight);
}

template <std::size_t N>
[[gnu::flatten]] void contacts_of(const PolygonBlock& block, std::size_t count, const double (&margins)[block_pairs],
                                  ContactColumns<block_pairs>& out) {
  for (std::size_t i = 0; i < count; i += Beside::lanes) {
    const LanePolygons<Beside, N> pair(block, i);
    LanePolygonNearest<Beside> nearest = nearest_lanes(pair);
    const LaneManifold<Beside> m = lane_polygon_manifold(pair, nearest, Beside::load(margins + i));
    put_truth<Beside>(out.known, i, nearest.known);
    put_truth<Beside>(out.overlap, i, nearest.points.distance - pair.radius_a - pair.radius_b <= Beside(0.0));
    put(out.filled, i, select(m.has_first, Beside(1.0), Beside(0.0)) + select(m.has_second, Beside(2.0), Beside(0.0)));
    put(out.normal, i, rotate(pair.pose_a.rotation, m.normal));
    put_point(pair.pose_a, m.first, i, out.points[0]);
    put_point(pair.pose_a, m.second, i, out.points[1]);
  }
}

void distances(const PolygonBlock& block, std::size_t count, DistanceColumns<block_pairs>& out) {
  with_vertices(block, [&](auto n) { distances_of<decltype(n)::value>(block, count, out); });
}
void contacts(const PolygonBlock& block, std::size_t count, const double (&margins)[block_pairs],
              ContactColumns<block_pairs>& out) {
  with_vertices(block, [&](auto n) { contacts_of<decltype(n)::value>(block, count, margins, out); });
}

/// Loads vertices two by two, and behind the last one of a polygon its first.
template <class T>
[[gnu::flatten]] void load_vertices(const Vec2<T>* const* rows, std::size_t count, PolygonColumns& to) {
  static_assert(sizeof(Vec2<T>) == 2 * sizeof(T));
  for (std::size_t first = 0; first < count; first += lanes_of<T>) {
    const auto put_lanes = [&](const Lanes<T>& x, double* column) __attribute__((always_inline)) {
      lanes_in_double<0>(x).store(column + first);
      if constexpr (lanes_of < T >> lanes_of<double>) lanes_in_double<1>(x).store(column + first + lanes_of<double>);
    };
    for (std::size_t k = 0; k < lane_vertices; k += 2) {
      Lanes<T> n[4];
      gather<T>(
          [&](std::size_t lane) __attribute__((always_inline)) { return rows[first + lane]; }, k * sizeof(Vec2<T>), n);
      put_lanes(n[0], to.x[k]);
      put_lanes(n[1], to.y[k]);
      put_lanes(n[2], to.x[k + 1]);
      put_lanes(n[3], to.y[k + 1]);
    }
    for (std::size_t lane = first; lane < first + lanes_of<T>; lane += Beside::lanes) {
      const Beside number = Beside::load(to.count + lane), x = Beside::load(to.x[0] + lane),
                   y = Beside::load(to.y[0] + lane);
      for (std::size_t k = 1; k < lane_vertices; ++k) {
        const auto there = Beside(double(k)) < number;
        select(there, Beside::load(to.x[k] + lane), x).store(to.x[k] + lane);
        select(there, Beside::load(to.y[k] + lane), y).store(to.y[k] + lane);
      }
    }
  }
}

constexpr PolygonKernels kernels{Beside::lanes >= 4, Beside::lanes >= 8,   distances,
                                 contacts,           load_vertices<float>, load_vertices<double>};

}  // namespace

const PolygonKernels& plane_polygon_kernels() { return kernels; }

}  // namespace graze::GRAZE_ISA
