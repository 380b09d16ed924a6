#include <array>

#include "plane/pairs/cast_kernels.hpp"
#include "plane/pairs/lane_answers.hpp"
#include "plane/pairs/lane_cast.hpp"
#include "plane/pairs/lane_cores.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace plane;
using plane_answers::put;
using plane_answers::put_truth;

using Beside = Lanes<double>;

/// A polygon at the place from which it moves, without negative zeros, as a cast alone has it.
template <std::size_t N>
[[gnu::always_inline]] inline LanePolygon<Beside, N> at_start(LanePolygon<Beside, N> polygon) {
  polygon.pose.translation = polygon.pose.translation + Vec2<Beside>{Beside(0.0), Beside(0.0)};
  return polygon;
}

template <std::size_t N, std::size_t M>
[[gnu::always_inline]] inline void cast_at(const LanePolygons<Beside, N, M>& pair, const MotionColumns& motion,
                                           std::size_t first, CastColumns& out) {
  const auto velocity = [&](const double(&columns)[2][block_pairs]) __attribute__((always_inline)) {
    return Vec2<Beside>{Beside::load(columns[0] + first), Beside::load(columns[1] + first)};
  };
  const Vec2<Beside> of_a = velocity(motion.a), of_b = velocity(motion.b);
  const Vec2<Beside> of_b_in_a = inverse_rotate(pair.pose_a.rotation, of_b - of_a);
  const Beside square = length_squared(of_b_in_a), speed = sqrt(square);
  const LaneContact<Beside> found = straight_contact_in_lanes(pair, of_b_in_a / speed);
  const Beside t = found.way / speed;
  put_truth<Beside>(out.known, first,
                    found.known & (square >= Beside(least_plain_square)) & (square <= Beside(most_plain_square)));
  put(out.t, first, t);
  put(out.normal, first, rotate(pair.pose_a.rotation, found.normal));
  put(out.point, first, pair.pose_a.translation + of_a * t + rotate(pair.pose_a.rotation, found.point));
}

template <class Pair, bool turned>
[[gnu::flatten]] void casts(const PairColumns<block_pairs>& columns, const MotionColumns& motion, std::size_t count,
                            CastColumns& out) {
  constexpr LaneCore core_a = turned ? Pair::b : Pair::a, core_b = turned ? Pair::a : Pair::b;
  for (std::size_t i = 0; i < count; i += Beside::lanes) {
    const LaneShape<Beside> a = plane_answers::shape<Beside>(turned ? columns.b : columns.a, i),
                            b = plane_answers::shape<Beside>(turned ? columns.a : columns.b, i);
    cast_at(LanePolygons<Beside, corners_of(core_a), corners_of(core_b)>(at_start(core_polygon<core_a>(a)),
                                                                         at_start(core_polygon<core_b>(b))),
            motion, i, out);
  }
}

template <class Pair, bool turned>
constexpr CastKernels::OfEntry kernel_of() {
  if constexpr (corners_of(Pair::a) == 0 || corners_of(Pair::b) == 0 || (turned && Pair::a == Pair::b))
    return nullptr;
  else
    return casts<Pair, turned>;
}
template <class... P>
struct EntryKernels {
  static constexpr CastKernels::OfEntry all[][2] = {{kernel_of<P, false>(), kernel_of<P, true>()}...};
};
template <class... P>
constexpr auto entry_kernels(Pairs<P...>) {
  return EntryKernels<P...>::all;
}

template <std::size_t N>
[[gnu::flatten]] void casts_of(const PolygonBlock& block, const MotionColumns& motion, std::size_t count,
                               CastColumns& out) {
  for (std::size_t i = 0; i < count; i += Beside::lanes)
    cast_at(LanePolygons<Beside, N>(at_start(polygon_at<Beside, N>(block.a, i)),
                                    at_start(polygon_at<Beside, N>(block.b, i))),
            motion, i, out);
}
void casts_of_polygons(const PolygonBlock& block, const MotionColumns& motion, std::size_t count, CastColumns& out) {
  with_vertices(block, [&](auto n) { casts_of<decltype(n)::value>(block, motion, count, out); });
}

constexpr CastKernels kernels{entry_kernels(PairList()), casts_of_polygons, Beside::lanes >= 4};

}  // namespace

const CastKernels& plane_cast_kernels() { return kernels; }

}  // namespace graze::GRAZE_ISA
